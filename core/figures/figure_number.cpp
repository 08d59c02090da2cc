// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_number.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_errors.h"

namespace gonio::figures {

namespace {

using study::MeasuredRepresentation;

void addImageMetrics(std::vector<FigureNumber>& numbers) {
  for (const metrics::ImageMetricRecord& metric : metrics::imageMetricRecords())
    numbers.push_back(
        {.id = std::string(metric.id),
         .name = std::string(metric.name),
         .unit = "",
         .better = metric.higherIsBetter ? Better::higher : Better::lower,
         .value = [compute = metric.compute](const MeasuredRepresentation& studied, const Image& reference) {
           return compute(reference, studied.picture);
         }});
}

void addBrdfMetrics(std::vector<FigureNumber>& numbers) {
  const auto metrics = metrics::metricRecords();
  for (std::size_t i = 0; i < metrics.size(); ++i)
    numbers.push_back(
        {.id = std::string(metrics[i].id),
         .name = std::string(metrics[i].id),
         .unit = std::string(metrics[i].unit),
         .value = [i](const MeasuredRepresentation& studied, const Image&) { return studied.record.errors[i]; }});
}

void addCosts(std::vector<FigureNumber>& numbers) {
  using S = const MeasuredRepresentation&;
  const auto add = [&](const char* id, const char* name, const char* unit, bool isTimed, auto value) {
    numbers.push_back({.id = id,
                       .name = name,
                       .unit = unit,
                       .isError = false,
                       .isTimed = isTimed,
                       .value = [value](S studied, const Image&) { return double(value(studied.record)); }});
  };
  using R = const study::StudyRecord&;
  add("bytes", "size", "B", false, [](R record) { return record.bytes; });
  add("encoding-time", "encoding", "s", true, [](R record) { return record.encodeSeconds; });
  add("evaluation-time", "evaluation", "s", true, [](R record) { return 1e-9 * record.evaluation.median; });
  add("frame-time", "frame", "s", true, [](R record) { return 1e-3 * record.frameMilliseconds; });
}

std::vector<FigureNumber> makeNumbers() {
  std::vector<FigureNumber> numbers{
      {.id = "rendered-snr",
       .name = "SNR",
       .unit = "dB",
       .better = Better::higher,
       .value = [](const MeasuredRepresentation& studied, const Image&) { return studied.record.renderedSnr; }}};
  addImageMetrics(numbers);
  addBrdfMetrics(numbers);
  addCosts(numbers);
  return numbers;
}

/// Three significant digits; whole numbers from 1000 on.
std::string digitsOf(double value) {
  constexpr int digits = 3;
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  if (std::abs(value) >= 1000) return std::to_string(std::llround(value));
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%#.*g", digits, value);
  std::string result(text, std::size_t(length));
  if (result.ends_with('.')) result.pop_back();
  return value == 0 ? "0" : result;
}

}  // namespace

std::string FigureNumber::title() const { return unit.empty() ? name : name + " [" + unit + "]"; }

std::span<const FigureNumber> figureNumbers() {
  static const std::vector<FigureNumber> numbers = makeNumbers();
  return numbers;
}

const FigureNumber& figureNumber(std::string_view id) {
  const auto found = std::ranges::find(figureNumbers(), id, &FigureNumber::id);
  if (found != figureNumbers().end()) return *found;
  std::string known;
  for (const FigureNumber& number : figureNumbers()) known += (known.empty() ? "" : ", ") + number.id;
  throw Error("found the quantity '" + std::string(id) + "', expected one of " + known);
}

std::string tableText(const FigureNumber& number, double value) {
  return number.unit == "B" && std::isfinite(value) ? std::to_string(std::llround(value)) : digitsOf(value);
}

std::string valueText(const FigureNumber& number, double value) {
  struct Prefix {
    double factor;
    const char* letter;
  };
  constexpr Prefix prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
  const std::string unit = number.unit.empty() ? "" : " " + number.unit;
  if (number.isError || !std::isfinite(value) || value == 0) return digitsOf(value) + unit;
  // A value that rounds to 1000 has the next prefix.
  constexpr double rounding = 0.9995;
  if (number.unit == "B" && value < 1000) return tableText(number, value) + unit;
  const auto prefix = std::ranges::find_if(prefixes, [&](const Prefix& one) { return value >= rounding * one.factor; });
  const Prefix used = prefix == std::end(prefixes) ? prefixes[std::size(prefixes) - 1] : *prefix;
  return digitsOf(value / used.factor) + " " + used.letter + number.unit;
}

}  // namespace gonio::figures
