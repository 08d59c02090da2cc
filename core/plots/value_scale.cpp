// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/value_scale.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/math/round_number.h"

namespace gonio::plots {

double ValueScale::fraction(double value) const {
  if (!logarithmic) return (value - min) / (max - min);
  return value > 0 ? std::max(0.0, std::log(value / min) / std::log(max / min)) : 0.0;
}

double ValueScale::value(double fraction) const {
  return logarithmic ? min * std::pow(max / min, fraction) : min + fraction * (max - min);
}

ValueScale scaleFor(std::span<const double> values, bool logarithmic, int maxDecades, double shown) {
  std::vector<double> positive;
  std::ranges::copy_if(values, std::back_inserter(positive),
                       [](double value) { return value > 0 && std::isfinite(value); });
  if (positive.empty()) return {logarithmic, logarithmic ? 0.1 : 0.0, 1};
  const double smallest = std::ranges::min(positive);
  const auto end = positive.begin() + std::ptrdiff_t(shown * double(positive.size() - 1));
  std::ranges::nth_element(positive, end);
  const double largest = *end;
  if (!logarithmic) return {false, 0, largest * 1.05};
  const double top = std::ceil(std::log10(largest) - 1e-9);
  const double bottom = std::clamp(std::floor(std::log10(smallest) + 1e-9), top - maxDecades, top - 1);
  return {true, std::pow(10, bottom), std::pow(10, top)};
}

std::vector<double> scaleTicks(const ValueScale& scale, int count) {
  std::vector<double> ticks;
  if (scale.logarithmic) {
    const int first = int(std::ceil(std::log10(scale.min) - 1e-9)),
              last = int(std::floor(std::log10(scale.max) + 1e-9));
    const int step = std::max(1, (last - first + count - 1) / std::max(1, count));
    for (int exponent = last; exponent >= first; exponent -= step) ticks.insert(ticks.begin(), std::pow(10, exponent));
    return ticks;
  }
  const double step = roundedUp((scale.max - scale.min) / count);
  for (double i = std::ceil(scale.min / step - 1e-9); i * step <= scale.max * (1 + 1e-12); ++i)
    if (i != 0) ticks.push_back(i * step);
  return ticks;
}

namespace {

bool isFinite(const glm::dvec2& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

/// The fractions [first, second] of the segment from a to b between which it lies inside.
std::optional<std::pair<double, double>> insideFractions(const glm::dvec2& a, const glm::dvec2& b,
                                                         const glm::dvec2& min, const glm::dvec2& max) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    if (way == 0) {
      if (a[axis] < min[axis] || a[axis] > max[axis]) return std::nullopt;
      continue;
    }
    const double toMin = (min[axis] - a[axis]) / way, toMax = (max[axis] - a[axis]) / way;
    enter = std::fmax(enter, std::fmin(toMin, toMax));
    leave = std::fmin(leave, std::fmax(toMin, toMax));
  }
  if (enter > leave) return std::nullopt;
  return std::pair(enter, leave);
}

}  // namespace

std::vector<std::vector<glm::dvec2>> clipPolyline(std::span<const glm::dvec2> points, const glm::dvec2& min,
                                                  const glm::dvec2& max) {
  std::vector<std::vector<glm::dvec2>> parts;
  bool open = false;  // the last part reaches to the segment's start
  for (std::size_t i = 1; i < points.size(); ++i) {
    const glm::dvec2 &a = points[i - 1], &b = points[i];
    const auto fractions = isFinite(a) && isFinite(b) ? insideFractions(a, b, min, max) : std::nullopt;
    if (!fractions) {
      open = false;
      continue;
    }
    const auto [enter, leave] = *fractions;
    if (!open || enter > 0) parts.push_back({a + enter * (b - a)});
    parts.back().push_back(leave == 1 ? b : a + leave * (b - a));
    open = leave == 1;
  }
  return parts;
}

}  // namespace gonio::plots
