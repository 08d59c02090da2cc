// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

/// The weights of four neighbours at `part` of the way between the middle two: Catmull and Rom.
inline std::array<double, 4> cubicWeights(double part) {
  const double t = part, t2 = t * t, t3 = t2 * t;
  return {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2, (t3 - t2) / 2};
}

/// Sum over four nodes about `position`; `at` gives the value of a node, the outermost ones repeated.
template <typename At>
double cubicInterpolation(double position, std::size_t count, At at) {
  // Indices of 32 bits: vector instructions convert to them.
  const int last = int(count) - 1, left = std::min(int(position), last - 1);
  const std::array<double, 4> weights = cubicWeights(position - double(left));
  return weights[0] * at(std::max(left - 1, 0)) + weights[1] * at(left) + weights[2] * at(left + 1) +
         weights[3] * at(std::min(left + 2, last));
}

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

inline double ExponentialPowerDistribution::density(double sin2H, double cosH) const {
  const double cos2H = cosH * cosH;
  const double logSquare = fastLog(std::max(sin2H / cos2H * inverseBeta2_, 1e-300));
  return fastExp(logPeak_ - fastExp(std::min(power_ * logSquare, 700.0)) - 2 * fastLog(cos2H));
}

inline double ExponentialPowerDistribution::cosLambda(double cosTheta, double sinTheta) const {
  const double slope = meanSlope_ * sinTheta, s = cosTheta / (cosTheta + maskingScale * slope);
  return slope *
         cubicInterpolation(s * (maskingNodes - 1), maskingNodes, [this](int n) { return masking_[std::size_t(n)]; });
}

/// Smith's masking of both directions divided by the product of the cosines. The masking is 1 / (1 + max(Lambda) +
/// lambda min(Lambda)), lambda = 4.41 phi / (4.41 phi + 1), where phi is the difference of the azimuths: the
/// correlation of van Ginneken, Stavridi and Koenderink 1998.
inline double smithMaskingOverCosines(const SurfaceGeometry& g, const ExponentialPowerDistribution& facets) {
  const double sinI = std::sqrt(g.wi.x * g.wi.x + g.wi.y * g.wi.y), sinO = std::sqrt(g.wo.x * g.wo.x + g.wo.y * g.wo.y);
  const double lambdaI = facets.cosLambda(g.cosI, sinI) * g.cosO;
  const double lambdaO = facets.cosLambda(g.cosO, sinO) * g.cosI;
  const double phi = fastAtan2(std::abs(g.wi.x * g.wo.y - g.wi.y * g.wo.x), g.wi.x * g.wo.x + g.wi.y * g.wo.y);
  const double correlation = 4.41 * phi / (4.41 * phi + 1);
  return 1 / (g.cosI * g.cosO + std::max(lambdaI, lambdaO) + correlation * std::min(lambdaI, lambdaO));
}

}  // namespace gonio::models
