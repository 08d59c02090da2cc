// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_warp.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/azimuth_rotation.h"

namespace gonio::editing {

namespace {

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

/// The cosine of the angle, in [0, pi], about the unit axis at which a direction comes down to the horizon: 1 where it
/// is there and would go on down, -1 where it comes there after half a turn or never.
double cosineToHorizon(const Direction& w, const Direction& axis) {
  // The height at the angle a is along + up cos a + ahead sin a.
  const double along = axis.z * glm::dot(axis, w), up = w.z - along, ahead = axis.x * w.y - axis.y * w.x;
  const double radius = std::hypot(up, ahead);
  if (!(radius > 0)) return -1;
  const double cosine = std::clamp((minWarpCosine - along) / radius, -1.0, 1.0), sine = std::sqrt(1 - cosine * cosine);
  if (ahead * cosine + up * sine >= 0) return (up * cosine - ahead * sine) / radius;
  return ahead < 0 && w.z < minWarpCosine ? 1 : -1;
}

HalfTurn endingAtTheHorizon(const HalfTurn& turn, const DirectionPair& pair) {
  const Direction axis = glm::normalize(turn.axis);
  const double last = std::max(cosineToHorizon(pair.wi, axis), cosineToHorizon(pair.wo, axis));
  if (last <= turn.cosine) return turn;
  return {axis * std::sqrt(std::max(0.0, 1 - last * last)), last};
}

}  // namespace

DirectionPair withScaledHalfSlopes(const DirectionPair& pair, const glm::dvec2& scale) {
  const Direction sum = pair.wi + pair.wo;
  if (!(sum.z > 0 && glm::dot(sum, sum) > 1e-24)) return pair;
  HalfTurn turn = halfTurn(glm::normalize(sum), scale);
  if (!(glm::dot(turn.axis, turn.axis) > 1e-24)) return pair;
  const DirectionPair turned{turn(pair.wi), turn(pair.wo)};
  if (std::min(turned.wi.z, turned.wo.z) >= minWarpCosine) return turned;
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
