// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/models/surface_geometry.h"

namespace gonio::models {

/// Microfacets with slope r = tan theta_h and density p / (pi beta^2 Gamma(1/p)) exp(-(r / beta)^(2p)): the exponential
/// power distribution of Holzschuch and Pacanowski 2017 (A Two-Scale Microfacet Reflectance Model Combining Reflection
/// and Diffraction, section 4.3), which is Beckmann's for p = 1. Smith's masking has no closed form, but depends only
/// on p and cot theta / mean slope. A table of the masking at fixed values of p and of cot theta / mean slope is
/// computed once; the constructor interpolates it over p, which takes a few microseconds.
class ExponentialPowerDistribution {
 public:
  /// The range of p in the table.
  static constexpr double minPower = 0.05, maxPower = 5;
  static constexpr std::size_t maskingNodes = 48;

  /// @param beta width, > 0. @param p power, [minPower, maxPower].
  ExponentialPowerDistribution(double beta, double p);

  /// D, 1/sr: D cos theta_h integrates to 1 over the hemisphere. O(1).
  double density(double sin2H, double cosH) const;
  /// cos theta Lambda(theta), with Smith's Lambda by cubic interpolation; G1 = 1 / (1 + Lambda) is accurate to 1e-4.
  /// O(1).
  double cosLambda(double cosTheta, double sinTheta) const;

  /// ln D at the pole.
  double logPeak() const { return logPeak_; }
  /// E[r^2] of the slope r.
  double meanSquareSlope() const { return meanSquareSlope_; }
  /// E[max(0, x)] of the slope x along any azimuth.
  double meanSlope() const { return meanSlope_; }
  /// E[max(0, x - cot theta)] / E[max(0, x)] at maskingNodes equally spaced values of s = cos theta / (cos theta +
  /// maskingScale meanSlope sin theta) from 0 to 1.
  const std::array<double, maskingNodes>& masking() const { return masking_; }
  static constexpr double maskingScale = 2;

 private:
  double inverseBeta2_, power_, logPeak_, meanSlope_, meanSquareSlope_;
  std::array<double, maskingNodes> masking_;
};

/// Smith's masking of both directions divided by the product of the cosines. The masking is 1 / (1 + max(Lambda) +
/// lambda min(Lambda)), lambda = 4.41 phi / (4.41 phi + 1), where phi is the difference of the azimuths: the
/// correlation of van Ginneken, Stavridi and Koenderink 1998.
double smithMaskingOverCosines(const SurfaceGeometry& g, const ExponentialPowerDistribution& facets);

}  // namespace gonio::models
