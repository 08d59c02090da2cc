// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string_view>

namespace gonio::models {

/// Unpolarised Fresnel reflectance of a dielectric in the form of Cook and Torrance (1982).
/// @param cosD cosine of the angle to the (micro)facet normal, [0, 1]. @param eta relative index, > 0. eta = 1 gives 0;
/// total reflection (eta < 1) and grazing incidence give 1. O(1).
double fresnelDielectric(double cosD, double eta);

/// f0 + (1 - f0)(1 - cosD)^5: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
double fresnelSchlick(double cosD, double f0);

/// Unpolarised Fresnel reflectance of a conductor with the complex index eta + i k (Born and Wolf, Principles of
/// Optics, section 14.2). k = 0 is a dielectric. @param cosD as above. @param eta, k >= 0. O(1).
double fresnelConductor(double cosD, double eta, double k);

struct ComplexIndex {
  double eta, k;
};
/// The index of a metal with reflectance f0 at normal incidence, in [0, 1), and edge tint in [0, 1]: Gulbrandsen 2014,
/// "Artist Friendly Metallic Fresnel". Edge tint 0 gives a dielectric (k = 0), 1 the earliest rise toward grazing
/// angles.
ComplexIndex indexFromEdgeTint(double f0, double edgeTint);

/// Fraction transmitted into the dielectric, 1 - fresnelDielectric(cosD, eta), without cancellation toward grazing
/// angles.
double fresnelTransmittance(double cosD, double eta);

/// Reflectance at normal incidence for the index eta > 0: ((eta - 1) / (eta + 1))^2.
double normalReflectanceFromIndex(double eta);

/// Index of refraction for the reflectance f0 in [0, 1) at normal incidence; f0 >= 1 gives infinity.
double indexFromNormalReflectance(double f0);

/// Fresnel terms of models, in the order of `fresnelChoices`; fresnelParameter() in core/models/common_parameters.h is
/// the parameter.
enum class FresnelChoice { dielectric, conductor, schlick };
inline constexpr std::string_view fresnelChoices[] = {"dielectric", "conductor", "schlick"};

/// A Fresnel term with precomputed values that do not depend on the angle. For f0 >= 1 all terms are 1.
class Fresnel {
 public:
  /// @param f0 reflectance at normal incidence, [0, 1]. @param edgeTint for a conductor, [0, 1].
  Fresnel(FresnelChoice choice, double f0, double edgeTint);
  /// @param cosD cosine of the angle to the (micro)facet normal, [0, 1].
  double operator()(double cosD) const;

 private:
  FresnelChoice choice_;
  double f0_;
  ComplexIndex index_;
};

}  // namespace gonio::models
