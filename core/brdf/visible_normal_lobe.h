// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/direction_sample.h"

/// Lobes (core/brdf/lobe_mixture.h) that reflect the viewer about visible normals, with density of normals D(h) G1(wo)
/// max(0, h . wo) / cos theta_o (Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the
/// Distribution of Visible Normals"). alphaX and alphaY are the roughness along x and y.
namespace gonio {

/// Visible normals of the GGX distribution. Heitz 2018, "Sampling the GGX Distribution of Visible Normals".
struct VisibleNormalLobe {
  double alphaX, alphaY;

  explicit VisibleNormalLobe(double alpha) : VisibleNormalLobe(alpha, alpha) {}
  VisibleNormalLobe(double x, double y) : alphaX(x), alphaY(y) {}

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  /// D(h) G1(wo) / (4 cos theta_o), 1/sr, computed as D(h) / (4 ggxCosineOverG1(wo)), so that it is finite for a viewer
  /// on the horizon.
  double density(const Direction& w, const Direction& wo) const;
};

/// Visible normals of Beckmann's distribution, sampled by inverting the cumulative distribution of the slopes (some
/// evaluations of erf).
struct BeckmannVisibleLobe {
  double alphaX, alphaY;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;
};

/// exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (pi alpha_x alpha_y h_z^4), 1/sr: Beckmann's distribution.
/// O(1).
double beckmannDensity(const Direction& half, double alphaX, double alphaY);
/// cos theta (1 + Lambda(w)) for Smith's masking of Beckmann's distribution, finite at the horizon (Heitz 2014,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", with anisotropic roughness). O(1).
double beckmannCosineOverG1(const Direction& w, double alphaX, double alphaY);
/// As beckmannDensity(), for the GGX distribution: D(h), 1/sr. O(1).
inline double ggxDensity(const Direction& half, double alphaX, double alphaY) {
  const double product = alphaX * alphaY;
  const double slope =
      half.x * half.x * (alphaY / alphaX) + half.y * half.y * (alphaX / alphaY) + product * half.z * half.z;
  return product / (pi * slope * slope);
}
/// As beckmannCosineOverG1(), for the GGX distribution. O(1).
inline double ggxCosineOverG1(const Direction& w, double alphaX, double alphaY) {
  const double x = alphaX * w.x, y = alphaY * w.y;
  return (w.z + std::sqrt(x * x + y * y + w.z * w.z)) / 2;
}

}  // namespace gonio
