// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// Projected-deviation-vector (PDV) coordinates: the direction of light relative to the mirror direction R of the
/// viewer, both projected onto the unit disk. Tongbuasirilai et al. 2017, "Efficient BRDF Sampling Using Projected
/// Deviation Vector Parameterization", and 2019, "Compact and Intuitive Data-Driven BRDF Models"; Tongbuasirilai 2023,
/// "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", algorithms 2 and 3.
///   Dp = wi_xy - R_xy = wi_xy + wo_xy, with the viewer rotated to azimuth 0.
/// phi_R is omitted: isotropic materials do not depend on it.
struct ProjectedDeviation {
  double thetaR = 0;     ///< polar angle of the mirror direction, equal to that of wo, rad, [0, pi/2]
  double deviation = 0;  ///< |Dp|, [0, 1 + sin thetaR]
  /// Azimuth of Dp, rad, (-pi, pi]: 0 points from the mirror direction toward the viewer, pi toward the horizon behind
  /// the mirror direction. 0 if Dp = 0.
  double phi = 0;
};

/// Coordinates of any two directions above the horizon. theta_R and |Dp| are accurate to rounding, phi to rounding /
/// |Dp|. O(1).
ProjectedDeviation toProjectedDeviation(const Direction& wi, const Direction& wo);

/// Directions of coordinates, with the viewer at azimuth 0. For a fixed viewer the solid angle of the light per unit of
/// |Dp| and radian of phi is |Dp| / cos theta_i, sr. (Eq. 4.32 of Tongbuasirilai 2023 is its inverse, in a form that
/// cancels at the mirror direction.)
struct ProjectedDirections {
  DirectionPair pair;
  bool valid = true;  ///< false if the point is outside the unit disk, where no direction of light exists
};
/// Points up to 1e-12 outside the disk count as on the horizon. O(1).
ProjectedDirections fromProjectedDeviation(const ProjectedDeviation& coordinates);

/// The largest |phi|, rad, at which a deviation lies on the disk: pi for deviations up to 1 - sin theta_R, decreasing
/// to 0 at 1 + sin theta_R and beyond. Never NaN. O(1).
double azimuthLimit(double deviation, double sinThetaR);

}  // namespace gonio
