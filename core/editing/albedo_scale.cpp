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

constexpr int azimuthCount = 24;

}  // namespace

Rgb AlbedoScale::operator()(double cosine) const {
  const Place place = placeOf(cosine);
  return glm::mix(values[place.first], values[place.first + 1], place.fraction);
}

RgbRange AlbedoScale::over(const Range& cosines) const {
  // The places fall with the cosine.
  const Place first = placeOf(cosines.high), last = placeOf(cosines.low);
  const Rgb ends[] = {(*this)(cosines.high), (*this)(cosines.low)};
  RgbRange result{glm::min(ends[0], ends[1]), glm::max(ends[0], ends[1])};
  for (std::size_t node = first.first + 1; node <= last.first; ++node) {
    result.low = glm::min(result.low, values[node]);
    result.high = glm::max(result.high, values[node]);
  }
  return result;
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

AlbedoQuadrature::AlbedoQuadrature(double cosine, double narrowest, bool isIsotropic, bool isMirrorSymmetric) {
  const double sine = std::sqrt(1 - cosine * cosine);
  const int turns = isIsotropic ? 1 : 4;
  for (int turn = 0; turn < turns; ++turn) {
    const double azimuth = pi * turn / turns;
    add({sine * std::cos(azimuth), sine * std::sin(azimuth), cosine}, narrowest,
        isIsotropic && isMirrorSymmetric ? azimuthCount / 2 : azimuthCount, 1.0 / turns);
  }
}

void AlbedoQuadrature::add(const Direction& wi, double narrowest, int azimuths, double part) {
  constexpr double step = 0.4, peak = 5e-4, beyond = 40, goldenRatio = 0.6180339887498949;
  const int first = int(std::floor(std::log(std::min(peak, narrowest / 20)) / step));
  const int last = int(std::ceil(std::log(beyond) / step));
  const double turn = std::atan2(wi.y, wi.x);
  for (int j = 0; j < azimuths; ++j) {
    const double azimuth = turn + 2 * pi * (j + 0.5) / azimuthCount, offset = std::fmod(j * goldenRatio, 1);
    for (int k = first; k < last; ++k) {
      const double slope = std::exp((k + offset) * step), cosine = 1 / std::sqrt(1 + slope * slope);
      const Direction half = cosine * Direction(slope * std::cos(azimuth), slope * std::sin(azimuth), 1);
      const double d = glm::dot(wi, half);
      const Direction wo = 2 * d * half - wi;
      if (!(d > 0 && wo.z > 0)) continue;
      // d omega_h = slope^2 cosine^3 d log slope d phi
      const double area = slope * slope * cosine * cosine * cosine * step * 2 * pi / azimuths;
      pairs.push_back({wi, wo});
      weights.push_back(part * 4 * d * wo.z * area);
    }
  }
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
