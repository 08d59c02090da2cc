// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <tuple>

namespace gonio::study {

namespace {

/// Fraction of an axis that an end takes.
constexpr double endFraction = 0.07;
constexpr int mostDecades = 12;
constexpr double decibelStep = 10;

struct Prefix {
  double size;
  const char* symbol;
};
constexpr Prefix prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};

/// Three significant digits, with the largest prefix that fits: `separator` before it, and none below `smallest`.
std::string prefixed(double value, double smallest, const char* separator) {
  // What three digits round up to the next thousand has its prefix.
  const Prefix& prefix = *std::ranges::find_if(
      prefixes, [&](const Prefix& one) { return one.size <= smallest || std::abs(value) >= 0.9995 * one.size; });
  char text[32];
  std::snprintf(text, sizeof text, "%.3g%s%s", value / prefix.size, separator, prefix.symbol);
  return text;
}

/// Without both ends, so that a scale of whole decades or tens shows all.
StudyAxis logarithmicAxis(const std::vector<double>& values) {
  return {.scale = plots::scaleFor(values, true, mostDecades),
          .zeroEnd = std::ranges::any_of(values, [](double value) { return value <= 0; })};
}

StudyAxis decibelAxis(const std::vector<double>& values) {
  StudyAxis axis{.scale = {false, 0, decibelStep}};
  for (const double value : values) {
    if (std::isfinite(value)) {
      axis.scale.min = std::min(axis.scale.min, decibelStep * std::floor(value / decibelStep));
      axis.scale.max = std::max(axis.scale.max, decibelStep * std::ceil(value / decibelStep));
    } else if (value > 0) {
      axis.infiniteEnd = true;
    } else if (value < 0) {
      axis.zeroEnd = true;
    }
  }
  return axis;
}

template <typename Value>
std::vector<double> valuesOf(std::span<const StudyRecord> records, const Value& value) {
  std::vector<double> values;
  for (const StudyRecord& record : records) values.push_back(value(record));
  return values;
}

using plots::Marker;
using plots::SvgDrawing;
using Anchor = SvgDrawing::Anchor;

constexpr double panelWidth = 620, panelHeight = 420, legendLine = 18, titleHeight = 40, noteHeight = 17;
constexpr double left = 64, right = 20, top = 14, bottom = 52;
constexpr double markerSize = 4.6, labelSize = 10.5;
constexpr std::string_view gridColour = "#dddddd", frontColour = "#888888";
constexpr plots::SvgStroke frontStroke{.colour = frontColour, .width = 2.5, .dashes = "7 3"};

/// A rectangle that a label takes.
struct Box {
  glm::dvec2 low, high;
  bool overlaps(const Box& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
};

std::string numbersText(const StudyRecord& record) {
  return record.representation.fullLabel() + ": " + shortNumber(record.renderedSnr) + " dB, " +
         shortQuantity(1e-9 * record.evaluation.median, "s") + ", " +
         shortQuantity(1e-3 * record.frameMilliseconds, "s") + " per frame, " +
         shortQuantity(double(record.bytes), "B") +
         (std::isnan(record.encodeSeconds) ? "" : ", encoded in " + shortQuantity(record.encodeSeconds, "s"));
}

std::vector<StudySeries> seriesOf(std::span<const StudyRecord> records) {
  std::vector<StudySeries> all;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const RepresentationKind* kind = records[i].representation.kind;
    const auto known =
        std::ranges::find(all, kind->legendName(), [](const StudySeries& one) { return one.kind->legendName(); });
    StudySeries& series =
        known == all.end()
            ? all.emplace_back(StudySeries{kind, {}, kind->unit == BudgetUnit::bytes || kind->hasCountedBudget()})
            : *known;
    series.records.push_back(i);
  }
  for (StudySeries& series : all)
    std::ranges::stable_sort(series.records, {}, [&](std::size_t i) { return records[i].representation.budget; });
  return all;
}

/// Short, beside a point: the budget where its shape shows the rest.
std::string labelOf(const Representation& r) { return r.kind->hasCountedBudget() ? r.budgetText() : r.label(); }

class PanelPainter {
 public:
  PanelPainter(SvgDrawing& svg, const glm::dvec2& origin, std::span<const StudyRecord> records, const StudyAxes& panel)
      : svg_(svg),
        records_(records),
        panel_(panel),
        low_(origin.x + left, origin.y + panelHeight - bottom),
        high_(origin.x + panelWidth - right, origin.y + top),
        geometry_(studyGeometry(records, panel)) {}

  void paint() {
    paintAxes();
    paintLines();
    for (std::size_t i = 0; i < records_.size(); ++i) {
      if (!geometry_.places[i]) continue;
      const RepresentationKind& kind = *records_[i].representation.kind;
      const glm::dvec2 at = placeOf(*geometry_.places[i]);
      svg_.marker(kind.style.marker, at, markerSize, kind.family->colour, kind.style.hollow, numbersText(records_[i]));
      taken_.push_back({at - markerSize, at + markerSize});
    }
    for (const std::size_t i : geometry_.front) paintLabel(i);
  }

 private:
  glm::dvec2 placeOf(const glm::dvec2& fraction) const { return low_ + fraction * (high_ - low_); }

  void paintAxes() {
    for (const auto& [position, text] : geometry_.costs.ticks()) {
      const double x = low_.x + position * (high_.x - low_.x);
      svg_.line({x, low_.y}, {x, high_.y}, {gridColour});
      svg_.text({x, low_.y + 16}, text, {.size = 11, .anchor = Anchor::middle});
    }
    for (const auto& [position, text] : geometry_.qualities.ticks()) {
      const double y = low_.y + position * (high_.y - low_.y);
      svg_.line({low_.x, y}, {high_.x, y}, {gridColour});
      svg_.text({low_.x - 6, y + 4}, text, {.size = 11, .anchor = Anchor::end});
    }
    svg_.frame({low_.x, high_.y}, {high_.x, low_.y});
    svg_.text({(low_.x + high_.x) / 2, low_.y + 36}, axisTitle(panel_.cost), {.anchor = Anchor::middle});
    svg_.text({low_.x - 44, (low_.y + high_.y) / 2}, axisTitle(panel_.quality),
              {.anchor = Anchor::middle, .upward = true});
  }

  /// Budgets of one representation, and the front over all.
  void paintLines() {
    for (const StudySeries& series : geometry_.series) {
      std::vector<glm::dvec2> points;
      for (const std::size_t i : series.records)
        if (geometry_.places[i]) points.push_back(placeOf(*geometry_.places[i]));
      if (series.isLine && points.size() > 1) svg_.polyline(points, {series.kind->family->colour, 0.8});
    }
    std::vector<glm::dvec2> steps;
    for (const glm::dvec2& corner : geometry_.frontSteps) steps.push_back(placeOf(corner));
    svg_.polyline(steps, frontStroke);
  }

  /// Beside its point, on the first side that is free; nowhere where none is. The steps of the front come from below
  /// and leave to the right.
  void paintLabel(std::size_t i) {
    const std::string text = labelOf(records_[i].representation);
    const glm::dvec2 at = placeOf(*geometry_.places[i]);
    const double width = 0.6 * labelSize * double(text.size()), gap = 2 * markerSize;
    const struct {
      double x, y;  ///< on the base line
      Anchor anchor;
    } sides[] = {{at.x - gap, at.y + 4, Anchor::end},
                 {at.x - gap, at.y - gap, Anchor::end},
                 {at.x, at.y - gap, Anchor::middle},
                 {at.x + gap, at.y - gap, Anchor::start},
                 {at.x + gap, at.y + 4, Anchor::start},
                 {at.x, at.y + gap + labelSize, Anchor::middle},
                 {at.x + gap, at.y + gap + labelSize, Anchor::start}};
    for (const auto& [x, y, anchor] : sides) {
      const double start = x - width * (anchor == Anchor::end ? 1.0 : anchor == Anchor::middle ? 0.5 : 0.0);
      const Box box{{start, y - labelSize}, {start + width, y + 2}};
      const bool inside = box.low.x > low_.x && box.high.x < high_.x && box.low.y > high_.y && box.high.y < low_.y;
      if (!inside || std::ranges::any_of(taken_, [&](const Box& other) { return box.overlaps(other); })) continue;
      svg_.text({x, y}, text, {.size = labelSize, .anchor = anchor, .halo = true});
      taken_.push_back(box);
      return;
    }
  }

  SvgDrawing& svg_;
  std::span<const StudyRecord> records_;
  StudyAxes panel_;
  glm::dvec2 low_, high_;  ///< corners of the axes: bottom left, top right
  StudyGeometry geometry_;
  std::vector<Box> taken_;
};

struct LegendEntry {
  const RepresentationKind* kind;  ///< null: the front
  glm::dvec2 at;
  std::string_view name() const { return kind ? kind->legendName() : "Pareto front"; }
};

/// The series of the records and the front, in lines of a width, from (0, 0).
std::vector<LegendEntry> legendOf(std::span<const StudyRecord> records, double width) {
  std::vector<LegendEntry> legend;
  for (const StudySeries& series : seriesOf(records)) legend.push_back({series.kind, {}});
  legend.push_back({nullptr, {}});
  glm::dvec2 place(0);
  for (LegendEntry& entry : legend) {
    const double taken = 34 + 7 * double(entry.name().size());
    if (place.x + taken > width) place = {0, place.y + legendLine};
    entry.at = place;
    place.x += taken;
  }
  return legend;
}

void paintLegend(SvgDrawing& svg, const glm::dvec2& origin, const std::vector<LegendEntry>& legend) {
  for (const LegendEntry& entry : legend) {
    const glm::dvec2 at = origin + entry.at;
    if (!entry.kind)
      svg.line({at.x - 4, at.y}, {at.x + 16, at.y}, frontStroke);
    else
      svg.marker(entry.kind->style.marker, {at.x + 6, at.y}, markerSize, entry.kind->family->colour,
                 entry.kind->style.hollow);
    svg.text({at.x + 20, at.y + 4}, std::string(entry.name()));
  }
}

}  // namespace

std::vector<std::size_t> paretoFront(std::span<const CostAndError> candidates) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!std::isnan(candidates[i].cost) && !std::isnan(candidates[i].error)) order.push_back(i);
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return std::tuple(candidates[i].cost, candidates[i].error); });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    const bool equal = !front.empty() && candidates[front.back()].cost == candidates[i].cost &&
                       candidates[front.back()].error == candidates[i].error;
    if (front.empty() || equal || candidates[i].error < candidates[front.back()].error) front.push_back(i);
  }
  return front;
}

std::optional<std::size_t> bestWithin(std::span<const StudyRecord> records, const Budget& budget) {
  const auto keeps = [&](const StudyRecord& record) {
    return (!budget.frameMilliseconds || record.frameMilliseconds <= *budget.frameMilliseconds) &&
           !(budget.bytes && double(record.bytes) > *budget.bytes) &&
           (!budget.renderedSnr || record.renderedSnr >= *budget.renderedSnr);
  };
  const auto order = [](const StudyRecord& record) {
    const bool undefined = std::isnan(record.renderedSnr);
    const double frame = record.frameMilliseconds;
    return std::tuple(undefined, undefined ? 0 : -record.renderedSnr,
                      std::isnan(frame) ? std::numeric_limits<double>::infinity() : frame, record.bytes);
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < records.size(); ++i)
    if (keeps(records[i]) && (!best || order(records[i]) < order(records[*best]))) best = i;
  return best;
}

double qualityOf(const StudyRecord& record, Quality quality) {
  return quality ? record.errors[std::size_t(*quality)] : record.renderedSnr;
}

std::string axisTitle(Quality quality) {
  if (!quality) return "rendered SNR [dB]";
  const metrics::MetricRecord& metric = metrics::metricRecord(*quality);
  return "error " + std::string(metric.id) + (metric.unit.empty() ? "" : " [" + std::string(metric.unit) + "]");
}

std::string axisTitle(Cost cost) { return std::string(costName(cost)) + " [" + std::string(costUnit(cost)) + "]"; }

std::vector<CostAndError> costsAndErrors(std::span<const StudyRecord> records, Cost cost, Quality quality) {
  std::vector<CostAndError> alternatives;
  for (const StudyRecord& record : records)
    alternatives.push_back({costOf(record, cost), quality ? qualityOf(record, quality) : -record.renderedSnr});
  return alternatives;
}

std::optional<double> StudyAxis::position(double value) const {
  if (std::isnan(value)) return std::nullopt;
  const double low = zeroEnd ? endFraction : 0, high = infiniteEnd ? 1 - endFraction : 1;
  if (std::isinf(value)) return value > 0 ? 1 - endFraction / 3 : endFraction / 3;
  if (scale.logarithmic && value <= 0) return endFraction / 3;
  return low + (high - low) * std::clamp(scale.fraction(value), 0.0, 1.0);
}

std::vector<StudyAxis::Tick> StudyAxis::ticks() const {
  constexpr int wanted = 7;
  constexpr double clear = 0.1;  // of the axis, from the labels of values beyond the scale
  std::vector<Tick> ticks;
  if (zeroEnd) ticks.push_back({endFraction / 3, scale.logarithmic ? "0" : "-∞"});
  for (const double value : plots::scaleTicks(scale, wanted))
    if (const double at = *position(value); !(zeroEnd && at < clear) && !(infiniteEnd && at > 1 - clear))
      ticks.push_back({at, shortNumber(value)});
  if (!scale.logarithmic) ticks.push_back({*position(0), "0"});
  if (infiniteEnd) ticks.push_back({1 - endFraction / 3, "∞"});
  return ticks;
}

StudyAxis costAxis(std::span<const StudyRecord> records, Cost cost) {
  return logarithmicAxis(valuesOf(records, [cost](const StudyRecord& record) { return costOf(record, cost); }));
}

StudyAxis qualityAxis(std::span<const StudyRecord> records, Quality quality) {
  const auto values = valuesOf(records, [quality](const StudyRecord& r) { return qualityOf(r, quality); });
  return quality ? logarithmicAxis(values) : decibelAxis(values);
}

std::string shortNumber(double value) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  return prefixed(value, 1, "");
}

std::string shortQuantity(double value, std::string_view unit) {
  const bool hasPrefix = std::isfinite(value) && value != 0;
  return (hasPrefix ? prefixed(value, prefixes[std::size(prefixes) - 1].size, " ") : shortNumber(value) + " ") +
         std::string(unit);
}

StudyGeometry studyGeometry(std::span<const StudyRecord> records, const StudyAxes& axes) {
  StudyGeometry geometry{.costs = costAxis(records, axes.cost),
                         .qualities = qualityAxis(records, axes.quality),
                         .places = {},
                         .series = seriesOf(records),
                         .front = paretoFront(costsAndErrors(records, axes.cost, axes.quality)),
                         .frontSteps = {}};
  for (const StudyRecord& record : records) {
    const auto x = geometry.costs.position(costOf(record, axes.cost));
    const auto y = geometry.qualities.position(qualityOf(record, axes.quality));
    geometry.places.push_back(x && y ? std::optional(glm::dvec2(*x, *y)) : std::nullopt);
  }
  // Steps: between two points there is nothing to be had but the cheaper one.
  for (const std::size_t i : geometry.front) {
    const glm::dvec2 at = *geometry.places[i];
    if (!geometry.frontSteps.empty()) geometry.frontSteps.emplace_back(at.x, geometry.frontSteps.back().y);
    geometry.frontSteps.push_back(at);
  }
  return geometry;
}

std::vector<StudyAxes> allCostAxes() {
  std::vector<StudyAxes> panels;
  for (const Cost cost : allCosts) panels.push_back({.cost = cost});
  return panels;
}

std::string studySvg(const std::string& title, std::span<const StudyRecord> records, std::span<const StudyAxes> panels,
                     const std::vector<std::string>& notes) {
  const std::size_t columns = std::min<std::size_t>(2, std::max<std::size_t>(1, panels.size()));
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  const double width = panelWidth * double(columns);
  const std::vector<LegendEntry> legend = legendOf(records, width - left - right);
  const double panelsTop = titleHeight + legend.back().at.y + 1.5 * legendLine;
  SvgDrawing svg(width, panelsTop + panelHeight * double(rows) + noteHeight * double(notes.size()) + 8);
  svg.text({left, 26}, title, {.size = 16, .bold = true});
  paintLegend(svg, {left + 4, titleHeight + 8}, legend);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    PanelPainter(svg, {panelWidth * double(column), panelsTop + panelHeight * double(row)}, records, panels[i]).paint();
  }
  for (std::size_t i = 0; i < notes.size(); ++i)
    svg.text({left, panelsTop + panelHeight * double(rows) + noteHeight * (double(i) + 0.5)}, notes[i],
             {.size = 11, .colour = "#555555"});
  return svg.str();
}

}  // namespace gonio::study
