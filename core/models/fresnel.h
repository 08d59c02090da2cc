// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

/// Fresnel terms. Those that depend on directions have no branches and are always inlined, so that loops over
/// directions are vectorised.
namespace gonio::models {

/// Unpolarised Fresnel reflectance of a dielectric in the form of Cook and Torrance (1982).
/// @param cosD cosine of the angle to the (micro)facet normal, [0, 1]. @param eta relative index, > 0. eta = 1 gives 0;
/// total reflection (eta < 1) and grazing incidence give 1. O(1).
[[gnu::always_inline]] inline double fresnelDielectric(double cosD, double eta) {
  const double c = std::min(std::max(cosD, 0.0), 1.0);
  const double contrast = (eta - 1) * (eta + 1);
  const double squaredG = contrast + c * c, g = std::sqrt(std::max(squaredG, 0.0));
  const double sum = g + c;
  const double difference = contrast / sum;  // g - c without cancellation for an index near 1
  const double ratio = difference / sum;
  const double polarised = (c * sum - 1) / (c * difference + 1);
  const double partial = std::min(1.0, 0.5 * ratio * ratio * (1 + polarised * polarised));
  const double below = squaredG < 0 ? 1.0 : partial, value = cosD > 0 ? below : 1.0;
  const double limit = eta == 1 ? 0.0 : 1.0;
  const bool isLimit = (eta == 1) | (eta == std::numeric_limits<double>::infinity());
  return isLimit ? limit : value;
}

/// f0 + (1 - f0)(1 - cosD)^5: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
[[gnu::always_inline]] inline double fresnelSchlick(double cosD, double f0) {
  const double m = 1 - cosD;
  const double m2 = m * m;
  return f0 + (1 - f0) * (m2 * m2 * m);
}

/// Unpolarised Fresnel reflectance of a conductor with the complex index eta + i k (Born and Wolf, Principles of
/// Optics, section 14.2). k = 0 is a dielectric. @param cosD as above. @param eta, k >= 0. O(1).
[[gnu::always_inline]] inline double fresnelConductor(double cosD, double eta, double k) {
  const double c = cosD, cos2 = c * c, sin2 = 1 - cos2;
  const double contrast = (eta - 1) * (eta + 1) - k * k, product = 2 * eta * k;
  // (a + i b)^2 = index^2 - sin^2; the smaller of a^2 and b^2 by their product, where the difference would cancel.
  const double difference = contrast + cos2, modulus = std::sqrt(difference * difference + product * product);
  const double larger = (modulus + std::abs(difference)) / 2;
  const double quotient = product * product / (4 * larger), smaller = larger > 0 ? quotient : 0.0;
  const double a2 = difference > 0 ? larger : smaller, b2 = difference > 0 ? smaller : larger;
  const double a = std::sqrt(a2), sum = a + c;
  // a - c without cancellation for an index near 1.
  const double excess = contrast + (contrast * (contrast + 2 * cos2) + product * product) / (modulus + cos2);
  const double apart = excess / (2 * sum);
  const double perpendicular = (apart * apart + b2) / (sum * sum + b2);
  const double across = a * c - sin2, along = a * c + sin2;
  const double ratio = (across * across + b2 * cos2) / (along * along + b2 * cos2);
  const double partial = std::min(1.0, 0.5 * perpendicular * (1 + ratio));
  return sum > 0 ? partial : 1.0;  // total reflection, and index 1 at grazing angle: the limit of all others
}

struct ComplexIndex {
  double eta, k;
};
/// The index of a metal with reflectance f0 at normal incidence, in [0, 1), and edge tint in [0, 1]: Gulbrandsen 2014,
/// "Artist Friendly Metallic Fresnel". Edge tint 0 gives a dielectric (k = 0), 1 the earliest rise toward grazing
/// angles.
ComplexIndex indexFromEdgeTint(double f0, double edgeTint);

/// Fraction transmitted into the dielectric, 1 - fresnelDielectric(cosD, eta), without cancellation toward grazing
/// angles.
[[gnu::always_inline]] inline double fresnelTransmittance(double cosD, double eta) {
  const double c = std::min(std::max(cosD, 0.0), 1.0);
  const double squaredG = (eta - 1) * (eta + 1) + c * c;
  const double g = std::sqrt(std::max(squaredG, 0.0));  // eta times the cosine inside
  const double s = g + c, p = g / eta + c * eta;
  const double partial = std::min(1.0, 2 * c * g * (1 / (s * s) + 1 / (p * p)));
  const double limit = eta == 1 ? 1.0 : 0.0;
  const double below = squaredG < 0 ? 0.0 : partial, value = cosD > 0 ? below : limit;
  return eta == std::numeric_limits<double>::infinity() ? 0.0 : value;
}

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
  [[gnu::always_inline]] double operator()(double cosD) const {
    return constant_ + exactShare_ * fresnelConductor(cosD, index_.eta, index_.k) +
           schlickShare_ * fresnelSchlick(cosD, f0_);
  }

 private:
  double f0_;
  ComplexIndex index_{1, 0};
  double constant_ = 0, exactShare_ = 0, schlickShare_ = 0;  ///< 0 or 1: sums instead of branches
};

}  // namespace gonio::models
