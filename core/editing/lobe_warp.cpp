// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/lobe_warp.h"

#include <algorithm>
#include <cmath>

namespace gonio::editing {

namespace {

/// Where a turn ends: 89.4 degrees from the normal, within the nodes of every measurement.
constexpr double lastAngle = halfPi - 0.01;

}  // namespace

DirectionPair withScaledHalfTangent(const DirectionPair& pair, double scale) {
  const Direction sum = pair.wi + pair.wo;
  const double across = std::hypot(sum.x, sum.y);
  if (scale == 1 || !(across > 1e-12) || !(sum.z > 0)) return pair;
  const double x = sum.x / across, y = sum.y / across;
  double turn = std::atan2(scale * across, sum.z) - std::atan2(across, sum.z);
  for (const Direction& w : {pair.wi, pair.wo})
    turn = std::min(turn, std::max(0.0, lastAngle - std::atan2(w.x * x + w.y * y, w.z)));
  const double cosine = std::cos(turn), sine = std::sin(turn);
  const auto turned = [&](const Direction& w) {
    const double along = w.x * x + w.y * y, moved = along * cosine + w.z * sine;
    return Direction{w.x + (moved - along) * x, w.y + (moved - along) * y, w.z * cosine - along * sine};
  };
  return {turned(pair.wi), turned(pair.wo)};
}

}  // namespace gonio::editing
