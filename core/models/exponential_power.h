// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/models/surface_geometry.h"

namespace gonio::models {

/// Facets whose slope r = tan theta_h has the density p / (pi beta^2 Gamma(1/p)) exp(-(r / beta)^(2p)): the exponential
/// power distribution of Holzschuch and Pacanowski 2017 (A Two-Scale Microfacet Reflectance Model Combining Reflection
/// and Diffraction, section 4.3), Beckmann's with p = 1. Its masking is Smith's, which has no closed form but depends
/// on p and tan theta / mean slope only: a table of p, made once, gives one of the angle. Constructing one takes some
/// microseconds.
class ExponentialPowerDistribution {
 public:
  /// The hard range of p: what the table holds.
  static constexpr double minPower = 0.05, maxPower = 5;
  static constexpr std::size_t maskingNodes = 48;

  /// @param beta width, > 0; @param p power, [minPower, maxPower].
  ExponentialPowerDistribution(double beta, double p);

  /// D, 1/sr: the integral of D cos theta_h over the hemisphere is 1. O(1).
  double density(double sin2H, double cosH) const;
  /// cos theta Lambda(theta), Smith's Lambda by cubic interpolation: G1 = 1 / (1 + Lambda), right to 1e-4. O(1).
  double foldedLambda(double cosTheta, double sinTheta) const;

  /// ln D at the pole.
  double logPeak() const { return logPeak_; }
  /// E[r^2] of the slope r.
  double meanSquareSlope() const { return meanSquareSlope_; }
  /// E[max(0, x)] of the slope x along any azimuth.
  double meanSlope() const { return meanSlope_; }
  /// Over s = cos theta / (cos theta + maskingScale meanSlope sin theta) at equal steps from 0 to 1:
  /// E[max(0, x - cot theta)] / E[max(0, x)].
  const std::array<double, maskingNodes>& masking() const { return masking_; }
  static constexpr double maskingScale = 2;

 private:
  double inverseBeta2_, power_, logPeak_, meanSlope_, meanSquareSlope_;
  std::array<double, maskingNodes> masking_;
};

/// Smith's masking of both directions over the product of the cosines, with the correlation of azimuths apart by phi
/// of van Ginneken, Stavridi and Koenderink 1998: 1 / (1 + max(Lambda) + lambda min(Lambda)), lambda = 4.41 phi /
/// (4.41 phi + 1).
double foldedSmithMasking(const SurfaceGeometry& g, const ExponentialPowerDistribution& facets);

}  // namespace gonio::models
