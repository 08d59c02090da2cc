// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string_view>

#include "core/models/formula.h"

/// Fresnel terms; their formulas are in fresnel.glsl.
namespace gonio::models {

namespace glsl {
#include "core/models/fresnel.glsl"
}
using glsl::fresnelDielectric, glsl::fresnelSchlick, glsl::fresnelTransmittance;

/// glsl::fresnelOfContrast() of the complex index eta + i k; k = 0 is a dielectric. O(1).
[[gnu::always_inline]] inline double fresnelConductor(double cosD, double eta, double k) {
  return glsl::fresnelOfContrast(cosD, (eta - 1) * (eta + 1) - k * k, 2 * eta * k);
}

struct ComplexIndex {
  double eta, k;
};
/// The index of a metal with reflectance f0 at normal incidence, in [0, 1), and edge tint in [0, 1]: Gulbrandsen 2014,
/// "Artist Friendly Metallic Fresnel". Edge tint 0 gives a dielectric (k = 0), 1 the earliest rise toward grazing
/// angles.
ComplexIndex indexFromEdgeTint(double f0, double edgeTint);

/// Reflectance at normal incidence for the index eta > 0: ((eta - 1) / (eta + 1))^2.
double normalReflectanceFromIndex(double eta);

/// Index of refraction for the reflectance f0 in [0, 1) at normal incidence; f0 >= 1 gives infinity.
double indexFromNormalReflectance(double f0);

/// Fresnel terms of models, in the order of `fresnelChoices`; fresnelParameter() in core/models/common_parameters.h is
/// the parameter.
enum class FresnelChoice { dielectric, conductor, schlick };
inline constexpr std::string_view fresnelChoices[] = {"dielectric", "conductor", "schlick"};

/// A Fresnel term with precomputed values that do not depend on the angle. For f0 >= 1 all terms are 1.
struct Fresnel : glsl::FresnelTerm {
  /// @param f0 reflectance at normal incidence, [0, 1]. @param edgeTint for a conductor, [0, 1].
  Fresnel(FresnelChoice choice, double f0, double edgeTint);
  /// @param cosD cosine of the angle to the (micro)facet normal, [0, 1].
  [[gnu::always_inline]] double operator()(double cosD) const { return glsl::fresnel(*this, cosD); }
};

}  // namespace gonio::models
