// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/math/types.h"

namespace gonio::acquisition {

/// An interval of angles with its ends, rad.
struct AngleRange {
  double lowest = 0, highest = 0;

  bool operator==(const AngleRange&) const = default;
};

/// Pairs that a rig cannot reach: those whose three angles all lie in these ranges.
struct ForbiddenRegion {
  AngleRange thetaI{0, halfPi};         ///< polar angle of the light
  AngleRange thetaO{0, halfPi};         ///< polar angle of the viewer
  AngleRange azimuthDifference{0, pi};  ///< |phi_i - phi_o| in [0, pi]; pi is the side of the mirror direction

  bool operator==(const ForbiddenRegion&) const = default;
};

/// What a measuring rig can see: both directions above the horizon and their polar angles small enough, its two arms
/// far enough apart (one stands before the other), and outside all boxes. Limits belong to what they bound, to 1e-9
/// rad: nodes of a grid lie on them but for rounding.
struct MeasurableDirections {
  double largestPolarAngle = radians(85);  ///< of both directions, rad, [0, pi/2]
  double smallestSeparation = 0;           ///< angle between light and viewer, rad, [0, pi]
  std::vector<ForbiddenRegion> forbidden;

  bool operator==(const MeasurableDirections&) const = default;

  /// @throws Error which limit is not a number, out of its range, or lower than its counterpart.
  void check() const;
  /// Whether the pair can be measured. Where a direction is the normal its azimuth is anything: a box forbids the pair
  /// only if it spans all differences. O(boxes).
  bool allows(const DirectionPair& pair) const;
};

}  // namespace gonio::acquisition
