// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/plotted_values.h"

namespace gonio::plots {

/// Values of a BRDF over one angle.
struct Curve {
  std::vector<double> angles;  ///< rad, ascending
  PlottedValues points;        ///< one per angle
};

enum class SectionAxis { thetaH, thetaD, thetaO };

/// The definition of a section: the varying angle, and the fixed ones.
struct Section {
  SectionAxis axis = SectionAxis::thetaO;
  /// For SectionAxis::thetaO: the light has this polar angle and azimuth pi; the viewer has the signed polar angle
  /// theta_o in the plane of azimuth `planeAzimuth` (0: plane of incidence). There theta_o = theta_i is the mirror
  /// direction and theta_o = -theta_i is retro-reflection. Rad.
  double thetaI = radians(45), planeAzimuth = 0;
  /// Fixed angles, rad. For SectionAxis::thetaH: thetaD and phiD; for SectionAxis::thetaD: thetaH and phiD. With thetaH
  /// = 0, theta_d is the angle of incidence of mirror reflection.
  double thetaH = 0, thetaD = radians(45), phiD = halfPi;
  CosineFactor cosine = CosineFactor::none;
  int count = 721;
};

/// The curve of a section: theta_h and theta_d over [0, pi/2 - horizonMargin], theta_o over
/// [-pi/2 + horizonMargin, pi/2 - horizonMargin]; nodes are dense where a highlight is expected. Under 1 ms for models.
/// @param coverage as in evaluatePlotted().
Curve sectionCurve(const Brdf& brdf, const Section& section, const TabulatedBrdf* coverage = nullptr);

/// The value of a channel, linear between the nodes of a curve; NaN outside them and next to a point that is not known.
double valueAt(const Curve& curve, double angle, Channel channel);

/// The lobe in the plane of incidence: the section over theta_o at planeAzimuth = 0.
Curve polarLobe(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage = nullptr);

}  // namespace gonio::plots
