// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/plotted_values.h"

namespace gonio::plots {

/// A line through a BRDF: values over one angle.
struct Curve {
  std::vector<double> angles;  ///< rad, ascending
  PlottedValues points;        ///< one per angle
};

enum class SectionAxis { thetaH, thetaD, thetaO };

/// What varies along a section, and where it lies.
struct Section {
  SectionAxis axis = SectionAxis::thetaO;
  /// Of theta_o: light at this polar angle and azimuth pi, viewer at signed polar angle theta_o in the plane of azimuth
  /// `planeAzimuth`: in the plane of incidence (0) theta_o = theta_i is the mirror direction, -theta_i looks back at
  /// the light.
  double thetaI = radians(45), planeAzimuth = 0;
  /// Of theta_h: theta_d and phi_d are fixed. Of theta_d: theta_h and phi_d are. With theta_h = 0, theta_d is the angle
  /// of incidence of a mirror.
  double thetaH = 0, thetaD = radians(45), phiD = halfPi;
  CosineFactor cosine = CosineFactor::none;
  int count = 721;
};

/// The section's curve: theta_h and theta_d over [0, pi/2], theta_o over [-pi/2, pi/2], all up to `horizonMargin`;
/// nodes are dense where a highlight may be. Under a ms for models.
Curve sectionCurve(const Brdf& brdf, const Section& section, const TabulatedBrdf* coverage = nullptr);

/// The value of a channel between the nodes of a curve, linear; NaN outside them and beside a point that is not known.
double valueAt(const Curve& curve, double angle, Channel channel);

/// The lobe in the plane of incidence: the section over theta_o at planeAzimuth = 0.
Curve polarLobe(const Brdf& brdf, double thetaI, CosineFactor cosine, const TabulatedBrdf* coverage = nullptr);

}  // namespace gonio::plots
