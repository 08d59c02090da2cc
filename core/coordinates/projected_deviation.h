// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// Projected-deviation-vector (PDV) coordinates: the direction of light on the unit disk of projected directions, seen
/// from the mirror direction of the viewer. Tongbuasirilai et al. 2017 and 2019 (dissertation, algorithms 2 and 3).
///   Dp = wi_xy - R_xy = wi_xy + wo_xy, with the viewer turned to azimuth 0.
/// phi_R is left out: isotropic materials do not depend on it.
struct ProjectedDeviation {
  double thetaR = 0;     ///< polar angle of the mirror direction, which is that of wo, rad, [0, pi/2]
  double deviation = 0;  ///< |Dp|, [0, 1 + sin thetaR]
  /// Azimuth of Dp, rad, (-pi, pi]: 0 leads from the mirror direction toward the viewer, pi to the horizon behind the
  /// mirror direction. 0 where Dp = 0.
  double phi = 0;
};

/// Of any two directions above the horizon, exact to rounding: theta_R, |Dp| absolutely, phi to rounding / |Dp|. O(1).
ProjectedDeviation toProjectedDeviation(const Direction& wi, const Direction& wo);

/// Directions of coordinates: the viewer has azimuth 0, the light comes from the point of the disk. For a fixed viewer
/// the solid angle of the light per unit of |Dp| and radian of phi is |Dp| / cos theta_i, sr. (The dissertation's
/// eq. 4.32 is its inverse, exactly, in a form that cancels at the mirror direction.)
struct ProjectedDirections {
  DirectionPair pair;
  bool valid = true;  ///< false where the point lies outside of the unit disk: no direction of light is there
};
/// Up to 1e-12 outside of the disk counts as the horizon. O(1).
ProjectedDirections fromProjectedDeviation(const ProjectedDeviation& coordinates);

/// The largest |phi| at which a deviation is on the disk, rad, [0, pi]: pi up to 1 - sin theta_R, 0 at and beyond
/// 1 + sin theta_R, falling between. Never NaN. O(1).
double azimuthLimit(double deviation, double sinThetaR);

}  // namespace gonio
