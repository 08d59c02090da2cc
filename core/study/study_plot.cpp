// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_plot.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gonio::study {

namespace {

using plots::Marker;
using plots::SvgDrawing;
using Anchor = SvgDrawing::Anchor;

constexpr double panelWidth = 620, panelHeight = 420, legendLine = 18, titleHeight = 40, noteHeight = 17;
constexpr double left = 64, right = 20, top = 14, bottom = 52;
constexpr double markerSize = 4.6, labelSize = 10.5;
constexpr std::string_view gridColour = "#dddddd", frontColour = "#888888";
constexpr plots::SvgStroke frontStroke{.colour = frontColour, .width = 2.5, .dashes = "7 3"};

struct FamilyStyle {
  Marker marker;
  std::string_view colour;
};
/// Colours that the colour-blind can distinguish (Okabe and Ito 2008, "Color Universal Design").
constexpr FamilyStyle styles[representationFamilyCount] = {
    {Marker::square, "#000000"},   {Marker::circle, "#0072b2"},        {Marker::triangle, "#d55e00"},
    {Marker::diamond, "#009e73"},  {Marker::cross, "#cc79a7"},         {Marker::hourglass, "#44aa99"},
    {Marker::star, "#e69f00"},     {Marker::hourglass, "#999933"},     {Marker::triangleDown, "#56b4e9"},
    {Marker::pentagon, "#882255"}, {Marker::triangleRight, "#117733"}, {Marker::fourStar, "#332288"}};

struct Shape {
  Marker marker;
  bool hollow;
};
/// Shapes of the baselines in their order; no family has them.
constexpr Shape baselineShapes[] = {
    {Marker::circle, true},       {Marker::saltire, false}, {Marker::triangleDown, false}, {Marker::diamond, true},
    {Marker::triangleDown, true}, {Marker::cross, true},    {Marker::star, true},          {Marker::threeStar, true},
    {Marker::saltire, true},      {Marker::fourStar, true}};

Shape baselineShape(std::string_view id) {
  const auto all = studiedBaselines();
  const auto found = std::ranges::find(all, id, &factorization::Baseline::id);
  return baselineShapes[std::size_t(found - all.begin()) % std::size(baselineShapes)];
}

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

/// Short, beside a point: the budget where its shape shows the rest.
std::string labelOf(const Representation& r) {
  return r.family == RepresentationFamily::factors || r.family == RepresentationFamily::published ||
                 r.family == RepresentationFamily::alternatives || r.family == RepresentationFamily::code ||
                 r.family == RepresentationFamily::components || r.family == RepresentationFamily::patches
             ? r.budgetText
             : r.label;
}

class PanelPainter {
 public:
  PanelPainter(SvgDrawing& svg, const glm::dvec2& origin, std::span<const StudyRecord> records, const StudyAxes& panel)
      : svg_(svg),
        records_(records),
        panel_(panel),
        low_(origin.x + left, origin.y + panelHeight - bottom),
        high_(origin.x + panelWidth - right, origin.y + top),
        costs_(costAxis(records, panel.cost)),
        qualities_(qualityAxis(records, panel.quality)) {
    for (const StudyRecord& record : records) places_.push_back(placeOf(record));
  }

  void paint() {
    paintAxes();
    paintLines();
    for (std::size_t i = 0; i < records_.size(); ++i) {
      if (!places_[i]) continue;
      const SeriesStyle style = styleOf(records_[i].representation);
      svg_.marker(style.marker, *places_[i], markerSize, style.colour, style.hollow, numbersText(records_[i]));
      taken_.push_back({*places_[i] - markerSize, *places_[i] + markerSize});
    }
    for (const std::size_t i : front_) paintLabel(i);
  }

 private:
  std::optional<glm::dvec2> placeOf(const StudyRecord& record) const {
    const auto x = costs_.position(costOf(record, panel_.cost));
    const auto y = qualities_.position(qualityOf(record, panel_.quality));
    if (!x || !y) return std::nullopt;
    return glm::dvec2(low_.x + *x * (high_.x - low_.x), low_.y + *y * (high_.y - low_.y));
  }

  void paintAxes() {
    for (const auto& [position, text] : costs_.ticks()) {
      const double x = low_.x + position * (high_.x - low_.x);
      svg_.line({x, low_.y}, {x, high_.y}, {gridColour});
      svg_.text({x, low_.y + 16}, text, {.size = 11, .anchor = Anchor::middle});
    }
    for (const auto& [position, text] : qualities_.ticks()) {
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
    std::map<std::string, std::vector<glm::dvec2>> lines;
    std::map<std::string, std::string_view> colours;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const Representation& r = records_[i].representation;
      if (!places_[i]) continue;
      lines[r.id].push_back(*places_[i]);
      colours[r.id] = styleOf(r).colour;
    }
    for (const auto& [id, points] : lines)
      if (points.size() > 1) svg_.polyline(points, {colours[id], 0.8});
    front_ = paretoFront(costsAndErrors(records_, panel_.cost, panel_.quality));
    // Steps: between two points there is nothing to be had but the cheaper one.
    std::vector<glm::dvec2> steps;
    for (const std::size_t i : front_) {
      if (!steps.empty()) steps.emplace_back(places_[i]->x, steps.back().y);
      steps.push_back(*places_[i]);
    }
    svg_.polyline(steps, frontStroke);
  }

  /// Beside its point, on the first side that is free; nowhere where none is. The steps of the front come from below
  /// and leave to the right.
  void paintLabel(std::size_t i) {
    const std::string text = labelOf(records_[i].representation);
    const glm::dvec2 at = *places_[i];
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
  StudyAxis costs_, qualities_;
  std::vector<std::optional<glm::dvec2>> places_;
  std::vector<std::size_t> front_;
  std::vector<Box> taken_;
};

struct LegendEntry {
  SeriesStyle style;
  glm::dvec2 at;
};

/// The series of the records and, without a marker, the front; in lines of a width, from (0, 0).
std::vector<LegendEntry> legendOf(std::span<const StudyRecord> records, double width) {
  std::vector<LegendEntry> legend;
  for (const StudyRecord& record : records)
    if (const SeriesStyle style = styleOf(record.representation);
        std::ranges::none_of(legend, [&](const LegendEntry& entry) { return entry.style.name == style.name; }))
      legend.push_back({style, {}});
  legend.push_back({{.marker = {}, .colour = frontColour, .hollow = false, .name = "Pareto front"}, {}});
  glm::dvec2 place(0);
  for (LegendEntry& entry : legend) {
    const double taken = 34 + 7 * double(entry.style.name.size());
    if (place.x + taken > width) place = {0, place.y + legendLine};
    entry.at = place;
    place.x += taken;
  }
  return legend;
}

void paintLegend(SvgDrawing& svg, const glm::dvec2& origin, const std::vector<LegendEntry>& legend) {
  for (const LegendEntry& entry : legend) {
    const glm::dvec2 at = origin + entry.at;
    if (&entry == &legend.back())
      svg.line({at.x - 4, at.y}, {at.x + 16, at.y}, frontStroke);
    else
      svg.marker(entry.style.marker, {at.x + 6, at.y}, markerSize, entry.style.colour, entry.style.hollow);
    svg.text({at.x + 20, at.y + 4}, entry.style.name);
  }
}

}  // namespace

SeriesStyle styleOf(const Representation& r) {
  const FamilyStyle& style = styles[std::size_t(r.family)];
  if (r.family == RepresentationFamily::baselines) {
    const Shape shape = baselineShape(r.id);
    return {shape.marker, style.colour, shape.hollow, r.label};
  }
  if (r.id == separatedComponentsId) return {Marker::threeStar, style.colour, false, r.label};
  // Codes of the families that contain factors too have a shape of their own, and so have compact factors.
  const bool variantCode = r.id.starts_with("code-"), alternative = r.family == RepresentationFamily::alternatives;
  const bool hollow = r.id == "table-nearest" || r.id.starts_with("factors-2d") || (variantCode && alternative) ||
                      r.family == RepresentationFamily::patches;
  const bool named = r.family == RepresentationFamily::table || r.family == RepresentationFamily::factors ||
                     r.family == RepresentationFamily::published || alternative;
  const Marker marker = variantCode                    ? Marker::triangleLeft
                        : r.id == "factors-3d-compact" ? Marker::arrowhead
                                                       : style.marker;
  return {marker, style.colour, hollow, named ? r.label : std::string(familyName(r.family))};
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
