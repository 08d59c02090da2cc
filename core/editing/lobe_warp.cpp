// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_warp.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/azimuth_rotation.h"

namespace gonio::editing {

namespace {

/// Where a rotation ends: the sine of 0.57 degrees above the horizon, within the nodes of every measurement.
constexpr double lowestSine = 0.01;

/// The shortest rotation from one half vector to another.
struct HalfTurn {
  Direction axis{0};  ///< times the sine of the angle
  double cosine = 1;

  Direction operator()(const Direction& w) const {
    return w * cosine + glm::cross(axis, w) + axis * (glm::dot(axis, w) / (1 + cosine));
  }
};

HalfTurn halfTurn(const Direction& half, const glm::dvec2& scale) {
  const Direction scaled{half.x * scale.x, half.y * scale.y, half.z};
  const double inverse = 1 / glm::length(scaled);
  // half x scaled, without its cancellation.
  return {inverse * Direction{half.y * half.z * (1 - scale.y), half.x * half.z * (scale.x - 1),
                              half.x * half.y * (scale.y - scale.x)},
          inverse * glm::dot(half, scaled)};
}

/// The angle about the unit axis at which a direction comes down to the horizon, rad; pi where it never does.
double angleToHorizon(const Direction& w, const Direction& axis) {
  const double along = axis.z * glm::dot(axis, w), up = w.z - along, ahead = axis.x * w.y - axis.y * w.x;
  const double radius = std::hypot(up, ahead);
  if (!(radius > 0)) return pi;
  return std::max(0.0, std::atan2(ahead, up) + std::acos(std::clamp(lowestSine - along / radius, -1.0, 1.0)));
}

HalfTurn endingAtTheHorizon(const HalfTurn& turn, const DirectionPair& pair) {
  const double sine = glm::length(turn.axis), angle = std::atan2(sine, turn.cosine);
  const Direction axis = turn.axis / sine;
  const double last = std::min({angle, angleToHorizon(pair.wi, axis), angleToHorizon(pair.wo, axis)});
  return {axis * std::sin(last), std::cos(last)};
}

}  // namespace

DirectionPair withScaledHalfSlopes(const DirectionPair& pair, const glm::dvec2& scale) {
  const Direction sum = pair.wi + pair.wo;
  if (!(sum.z > 0 && glm::dot(sum, sum) > 1e-24)) return pair;
  HalfTurn turn = halfTurn(glm::normalize(sum), scale);
  if (!(glm::dot(turn.axis, turn.axis) > 1e-24)) return pair;
  const DirectionPair turned{turn(pair.wi), turn(pair.wo)};
  if (std::min(turned.wi.z, turned.wo.z) >= lowestSine) return turned;
  turn = endingAtTheHorizon(turn, pair);
  return {turn(pair.wi), turn(pair.wo)};
}

void warp(const LobeWarp& warp, std::span<const DirectionPair> pairs, std::span<DirectionPair> moved) {
  const AzimuthRotation toGrain(-warp.edited), fromGrain(warp.fitted);
  std::ranges::transform(pairs, moved.begin(), [&](const DirectionPair& pair) {
    return fromGrain(withScaledHalfSlopes(toGrain(pair), warp.scale));
  });
}

}  // namespace gonio::editing
