// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/direction_sample.h"

/// Lobes (core/brdf/lobe_mixture.h) of microfacets as the viewer sees them: the viewer reflected about visible normals,
/// D(h) G1(wo) max(0, h . wo) / cos theta_o (Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using
/// the Distribution of Visible Normals"). alphaX and alphaY are the widths of the slopes along x and y.
namespace gonio {

/// Of the GGX distribution. Heitz 2018, "Sampling the GGX Distribution of Visible Normals".
struct VisibleNormalLobe {
  double alphaX, alphaY;

  explicit VisibleNormalLobe(double alpha) : VisibleNormalLobe(alpha, alpha) {}
  VisibleNormalLobe(double x, double y) : alphaX(x), alphaY(y) {}

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  /// D(h) G1(wo) / (4 cos theta_o), without a division by the cosine.
  double density(const Direction& w, const Direction& wo) const;
};

/// Of Beckmann's distribution, whose slopes are Gaussian: the visible ones by inverting their distribution function, a
/// few error functions.
struct BeckmannVisibleLobe {
  double alphaX, alphaY;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;
};

/// exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (pi alpha_x alpha_y h_z^4), 1/sr: Beckmann's distribution.
/// O(1).
double beckmannDensity(const Direction& half, double alphaX, double alphaY);
/// cos theta (1 + Lambda) of Smith's masking of these slopes, finite at the horizon (Heitz 2014, "Understanding the
/// Masking-Shadowing Function in Microfacet-Based BRDFs", of anisotropic slopes). O(1).
double beckmannShadowedCosine(const Direction& w, double alphaX, double alphaY);
/// The same two of GGX.
double ggxDensity(const Direction& half, double alphaX, double alphaY);
double ggxShadowedCosine(const Direction& w, double alphaX, double alphaY);

}  // namespace gonio
