// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// Half-out coordinates: the polar angles of viewer and half vector, and the half vector's azimuth relative to the
/// viewer. Lawrence et al. 2004, "Efficient BRDF Importance Sampling Using a Factored Representation". phi_o is
/// omitted: isotropic materials do not depend on it.
struct HalfOut {
  double thetaO = 0;  ///< polar angle of wo, rad, [0, pi/2]
  double thetaH = 0;  ///< polar angle of the half vector, rad, [0, pi/2]
  double phiH = 0;    ///< azimuth of the half vector minus that of wo, rad, (-pi, pi]; 0 if either is at the pole
  bool valid = true;  ///< false when wi = -wo: no half vector exists
};

/// Accurate to rounding, also at the poles. O(1).
HalfOut toHalfOut(const Direction& wi, const Direction& wo);

/// Directions of coordinates: the viewer has azimuth 0, wi = 2 (wo . h) h - wo.
struct HalfOutDirections {
  DirectionPair pair;
  bool valid = true;  ///< false if wi is below the horizon (tolerance 1e-12) or the half vector faces away from the
                      ///< viewer
};
HalfOutDirections fromHalfOut(const HalfOut& coordinates);

/// Solid angle of the light per solid angle of the half vector, for a fixed viewer: 4 (wo . h). @param cosD wo . h.
inline double halfOutJacobian(double cosD) { return 4 * cosD; }

}  // namespace gonio
