// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// Half-out coordinates: the half vector as seen from the azimuth of the viewer. Lawrence et al. 2004, "Efficient BRDF
/// Importance Sampling Using a Factored Representation". phi_o is left out: isotropic materials do not depend on it.
struct HalfOut {
  double thetaO = 0;  ///< polar angle of wo, rad, [0, pi/2]
  double thetaH = 0;  ///< polar angle of the half vector, rad, [0, pi/2]
  double phiH = 0;    ///< azimuth of the half vector less that of wo, rad, (-pi, pi]; 0 where either has none
  bool valid = true;  ///< false when wi = -wo: no half vector exists
};

/// Exact to rounding, at the poles too. O(1).
HalfOut toHalfOut(const Direction& wi, const Direction& wo);

/// Directions of coordinates: the viewer has azimuth 0, wi = 2 (wo . h) h - wo.
struct HalfOutDirections {
  DirectionPair pair;
  bool valid = true;  ///< false where wi is below the horizon (beyond 1e-12) or the half vector turned from the viewer
};
HalfOutDirections fromHalfOut(const HalfOut& coordinates);

/// Solid angle of the light per solid angle of the half vector, for a fixed viewer: 4 (wo . h).
inline double halfOutMeasure(double cosD) { return 4 * cosD; }

}  // namespace gonio
