// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/math/types.h"

namespace gonio::editing {

/// The pair of directions whose half vector has slopes h_x / h_z and h_y / h_z that are `scale` times as large: both
/// directions are turned by the shortest rotation from the one half vector to the other, which keeps theta_d. With
/// equal scales it lies in the plane of the normal and the half vector, and keeps phi_d too. A rotation that would
/// bring a direction below the horizon ends just above it. Identical for a scale of 1, and where the half vector is the
/// normal.
/// @param pair with both directions above the horizon. @param scale > 0.
DirectionPair withScaledHalfSlopes(const DirectionPair& pair, const glm::dvec2& scale);

/// From a place in the profile of an edited lobe to the same place in that of the fitted one.
struct LobeWarp {
  glm::dvec2 scale{1};            ///< alpha / alpha' along the grain and across it
  double edited = 0, fitted = 0;  ///< rotations of the grains from the tangent, rad

  bool operator==(const LobeWarp&) const = default;
  bool isIdentity() const { return scale == glm::dvec2(1) && edited == fitted; }
};

/// @param moved gets where the unedited lobe had the pairs: each turned with the grain, and withScaledHalfSlopes()
/// along the fitted one.
void warp(const LobeWarp& warp, std::span<const DirectionPair> pairs, std::span<DirectionPair> moved);

}  // namespace gonio::editing
