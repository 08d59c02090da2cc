// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/clip_polyline.h"

#include <cmath>
#include <optional>
#include <utility>

namespace gonio::plots {

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
