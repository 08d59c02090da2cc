// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "core/brdf/brdf.h"
#include "core/math/types.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/half_vector_densities.h"

/// What the formulas of shading models consist of: lobes, Fresnel terms, albedos of layers, and the formula as a BRDF.
namespace gonio::exports {

/// Symmetries of a formula, and the rotation of its axes.
struct FormulaTraits {
  bool isotropic = true;
  bool reciprocal = true;
  double rotation = 0;  ///< angle of the formula's x axis from the tangent, rad, counter-clockwise
};

/// A target's own formula as a BRDF, 1/sr, without the cosine. `Formula` is callable as Rgb(const
/// models::SurfaceGeometry&), with directions in the frame of the formula's x axis; wi is the light, wo the viewer.
template <typename Formula>
class FormulaBrdf final : public Brdf {
 public:
  FormulaBrdf(Formula formula, const FormulaTraits& traits)
      : formula_(std::move(formula)), traits_(traits), toGrain_(-traits.rotation) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const DirectionPair pair = traits_.isotropic ? pairs[i] : toGrain_(pairs[i]);
      values[i] = models::isAboveSurface(pair) ? formula_(models::surfaceGeometry(pair)) : Rgb(0);
    }
  }
  bool isIsotropic() const override { return traits_.isotropic; }
  bool isReciprocal() const override { return traits_.reciprocal; }

 private:
  Formula formula_;
  FormulaTraits traits_;
  AzimuthRotation toGrain_;
};

template <typename Formula>
std::unique_ptr<const Brdf> makeFormulaBrdf(Formula formula, const FormulaTraits& traits = {}) {
  return std::make_unique<const FormulaBrdf<Formula>>(std::move(formula), traits);
}

/// GGX alpha along the formula's x and y axis, > 0.
struct GgxAlpha {
  double x, y;

  explicit GgxAlpha(double alpha) : x(alpha), y(alpha) {}
  GgxAlpha(double alphaX, double alphaY) : x(alphaX), y(alphaY) {}
  bool isotropic() const { return x == y; }
  /// The isotropic alpha with about the same peak.
  double mean() const { return std::sqrt(x * y); }
};

/// D G_2 / (4 cos theta_i cos theta_o), 1/sr, with the height-correlated Smith term (Heitz 2014, "Understanding the
/// Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 99), without the Fresnel term. Finite at the horizon.
/// O(1).
/// @param masking alpha of G_2, where it differs from that of D.
inline double correlatedGgx(const models::SurfaceGeometry& g, const GgxAlpha& alpha, const GgxAlpha& masking) {
  const double i = ggxCosineOverG1(g.wi, masking.x, masking.y), o = ggxCosineOverG1(g.wo, masking.x, masking.y);
  return 0.25 * ggxDensity(g.h, alpha.x, alpha.y) / (o * g.cosI + i * g.cosO - g.cosI * g.cosO);
}
inline double correlatedGgx(const models::SurfaceGeometry& g, const GgxAlpha& alpha) {
  return correlatedGgx(g, alpha, alpha);
}
/// The same with the separable term G_1(i) G_1(o) (Walter et al. 2007, "Microfacet Models for Refraction through Rough
/// Surfaces", eq. 23 and 34).
inline double separableGgx(const models::SurfaceGeometry& g, const GgxAlpha& alpha) {
  const double i = ggxCosineOverG1(g.wi, alpha.x, alpha.y), o = ggxCosineOverG1(g.wo, alpha.x, alpha.y);
  return 0.25 * ggxDensity(g.h, alpha.x, alpha.y) / (i * o);
}

/// (1 - cosine)^5 of Schlick's approximation (Schlick 1994, "An Inexpensive BRDF Model for Physically-based
/// Rendering").
inline double schlickWeight(double cosine) {
  const double m = 1 - cosine, m2 = m * m;
  return m2 * m2 * m;
}

/// Schlick's term from f0 to f90, modified so that at 82 degrees it has `tint82` times Schlick's value (Hoffman 2023,
/// "Generalization of Adobe's Fresnel Model"); tint82 = 1 gives Schlick's term.
inline Rgb tintedSchlick(double cosine, const Rgb& f0, const Rgb& f90, const Rgb& tint82) {
  constexpr double c = 1.0 / 7, rest = 1 - c, rest5 = rest * rest * rest * rest * rest;
  const double s = schlickWeight(cosine), m = 1 - cosine;
  const Rgb dip = glm::mix(f0, f90, rest5) * (Rgb(1) - tint82) / (c * rest5 * rest);
  return glm::mix(f0, f90, s) - dip * (cosine * s * m);
}

// Directional albedos with which shaders attenuate the layers below a lobe and compensate for multiple scattering.

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
