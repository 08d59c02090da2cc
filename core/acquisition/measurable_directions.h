// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/math/types.h"

namespace gonio::acquisition {

/// A closed interval of angles, rad.
struct AngleRange {
  double lowest = 0, highest = 0;

  bool operator==(const AngleRange&) const = default;
};

/// Direction pairs that a rig cannot reach: those with all three angles in these ranges.
struct ForbiddenRegion {
  AngleRange thetaI{0, halfPi};         ///< polar angle of the light
  AngleRange thetaO{0, halfPi};         ///< polar angle of the viewer
  AngleRange azimuthDifference{0, pi};  ///< |phi_i - phi_o| in [0, pi]; pi is the side of the mirror direction

  bool operator==(const ForbiddenRegion&) const = default;
};

/// The direction pairs that a measuring rig can reach: both directions above the horizon and within a maximum polar
/// angle, light and viewer far enough apart (otherwise one arm occludes the other), and the pair outside all forbidden
/// regions. Limits are inclusive, with a tolerance of 1e-9 rad because nodes of a grid lie on them up to rounding.
struct MeasurableDirections {
  double maxPolarAngle = radians(85);  ///< of both directions, rad, [0, pi/2]
  double minSeparation = 0;            ///< angle between light and viewer, rad, [0, pi]
  std::vector<ForbiddenRegion> forbidden;

  bool operator==(const MeasurableDirections&) const = default;

  /// @throws Error that names a limit that is not a number or out of range, or a range with its ends swapped.
  void check() const;
  /// Whether the pair can be measured. If a direction is the normal, its azimuth is undefined: a region then forbids
  /// the pair only if it spans all azimuth differences. O(regions).
  bool allows(const DirectionPair& pair) const;
};

}  // namespace gonio::acquisition
