// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace gonio::study {

namespace {

/// Fraction of an axis that an end takes.
constexpr double endShare = 0.07;
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

}  // namespace

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
  const double low = zeroEnd ? endShare : 0, high = infiniteEnd ? 1 - endShare : 1;
  if (std::isinf(value)) return value > 0 ? 1 - endShare / 3 : endShare / 3;
  if (scale.logarithmic && value <= 0) return endShare / 3;
  return low + (high - low) * std::clamp(scale.fraction(value), 0.0, 1.0);
}

std::vector<StudyAxis::Tick> StudyAxis::ticks() const {
  constexpr int wanted = 7;
  constexpr double clear = 0.1;  // of the axis, from the labels of values beyond the scale
  std::vector<Tick> ticks;
  if (zeroEnd) ticks.push_back({endShare / 3, scale.logarithmic ? "0" : "-∞"});
  for (const double value : plots::scaleTicks(scale, wanted))
    if (const double at = *position(value); !(zeroEnd && at < clear) && !(infiniteEnd && at > 1 - clear))
      ticks.push_back({at, shortNumber(value)});
  if (!scale.logarithmic) ticks.push_back({*position(0), "0"});
  if (infiniteEnd) ticks.push_back({1 - endShare / 3, "∞"});
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

}  // namespace gonio::study
