// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/math/types.h"

namespace gonio::editing {

/// Cosine of 85 degrees, the maximum polar angle of warped directions. Models are fitted up to this angle. Beyond it
/// the fit is an extrapolation, and its ratio to the measurement would show as a pattern in a highlight that gets much
/// narrower.
inline constexpr double minWarpCosine = 0.08715574274765817;

/// Scales the slopes h_x / h_z and h_y / h_z of a pair's half vector by `scale`: rotates both directions by the
/// shortest rotation from the old half vector to the new one, which leaves theta_d unchanged. With equal scales the
/// rotation is in the plane of the normal and the half vector and leaves phi_d unchanged too. A rotation that would
/// move a direction to less than 5 degrees above the horizon stops there (minWarpCosine). Returns the pair unchanged if
/// the scale is 1 or the half vector is the normal.
/// @param pair with both directions above the horizon. @param scale > 0.
DirectionPair withScaledHalfSlopes(const DirectionPair& pair, const glm::dvec2& scale);

/// The map from directions of an edited lobe to those of the fitted lobe at the same point of its profile.
struct LobeWarp {
  glm::dvec2 scale{1};            ///< alpha / alpha' along and across the grain
  double edited = 0, fitted = 0;  ///< rotations of the grain from the tangent in the edited and the fitted lobe, rad

  bool operator==(const LobeWarp&) const = default;
  bool isIdentity() const { return scale == glm::dvec2(1) && edited == fitted; }
};

/// Applies the map to pairs: rotates them into the edited grain's frame, scales with withScaledHalfSlopes(), and
/// rotates into the fitted grain's. @param moved receives one pair per input pair.
void warp(const LobeWarp& warp, std::span<const DirectionPair> pairs, std::span<DirectionPair> moved);

}  // namespace gonio::editing
