// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/albedo_scale.h"

#include <algorithm>
#include <cmath>

namespace gonio::editing {

namespace {

/// Between two nodes: the first of them, and how far towards the second.
struct Place {
  std::size_t first;
  double fraction;
};
Place placeOf(double cosine) {
  const double x = std::sqrt(1 - std::clamp(cosine, 0.0, 1.0)),
               place = x * (1 + x) / 2 * double(AlbedoScale::nodes - 1);
  const std::size_t first = std::min(std::size_t(place), AlbedoScale::nodes - 2);
  return {first, place - double(first)};
}

}  // namespace

Rgb AlbedoScale::operator()(double cosine) const {
  const Place place = placeOf(cosine);
  return glm::mix(values[place.first], values[place.first + 1], place.fraction);
}

double AlbedoScale::cosineOf(std::size_t node) {
  constexpr double lowest = 0.01;  // 89.4 degrees: at 90 degrees nothing is reflected
  const double x = std::sqrt(0.25 + 2 * double(node) / double(nodes - 1)) - 0.5;
  return std::max(lowest, 1 - x * x);
}

void AlbedoNode::add(double cosine, const Rgb& contribution) {
  const Place place = placeOf(cosine);
  edited[place.first] += (1 - place.fraction) * contribution;
  edited[place.first + 1] += place.fraction * contribution;
}

AlbedoScale albedoScale(const std::array<AlbedoNode, AlbedoScale::nodes>& nodes) {
  constexpr int maxIterations = 40;
  constexpr double largest = 64, tolerance = 1e-4, darkest = 1e-9;
  AlbedoScale scale;
  for (int iteration = 0; iteration < maxIterations; ++iteration) {
    double step = 0;
    AlbedoScale next = scale;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Rgb albedo(0);
      for (std::size_t k = 0; k < nodes.size(); ++k) albedo += nodes[i].edited[k] * scale.values[k];
      albedo *= scale.values[i];
      for (int channel = 0; channel < 3; ++channel) {
        const double before = nodes[i].before[channel], now = albedo[channel];
        if (!(before > darkest && now > darkest)) continue;
        const double factor = std::sqrt(before / now);
        step = std::max(step, std::abs(factor - 1));
        next.values[i][channel] = std::clamp(scale.values[i][channel] * factor, 1 / largest, largest);
      }
    }
    scale = next;
    if (step < tolerance) break;
  }
  return scale;
}

}  // namespace gonio::editing
