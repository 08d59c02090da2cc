// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

/// Directional albedos with which shaders attenuate the layers below a lobe and compensate for multiple scattering.
namespace gonio::exports {

/// Directional albedo of a GGX lobe with the height-correlated Smith term and a generalised Schlick term. The albedo is
/// F_0 times `normal` plus F_90 times `edge`.
struct GgxAlbedo {
  double normal, edge;

  double at(double f0, double f90 = 1) const { return f0 * normal + f90 * edge; }
};

/// @param cosine of the viewer's polar angle, [0, 1]. @param alpha GGX alpha, [0, 1]. O(1): linear in a table of 64
/// cosines by 48 alphas, which is computed at the first call (0.1 s).
GgxAlbedo ggxAlbedo(double cosine, double alpha);

/// The factor 1 + F (1 - E) / E that compensates a lobe for multiple scattering, with F = `fresnel` and E the albedo
/// for F = 1. Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models", eq. 16.
double scatteringCompensation(const GgxAlbedo& albedo, double fresnel);

/// Distribution of the fibres' normals, 1/sr: Estévez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF",
/// eq. 2. @param sin2H squared sine of theta_h. @param alpha > 0.
double charlieDensity(double sin2H, double alpha);
/// Directional albedo of charlieDensity() / (4 (cos theta_i + cos theta_o - cos theta_i cos theta_o)), the term of
/// Neubelt and Pettineo 2013, "Crafting a Next-Gen Material Pipeline for The Order: 1886"; at most 1. Parameters and
/// cost as ggxAlbedo().
double charlieAlbedo(double cosine, double alpha);

}  // namespace gonio::exports
