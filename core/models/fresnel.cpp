// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio::models {

double fresnelDielectric(double cosD, double eta) {
  if (std::isinf(eta)) return 1;
  if (eta == 1) return 0;
  const double c = std::clamp(cosD, 0.0, 1.0);
  const double contrast = (eta - 1) * (eta + 1);
  const double squaredG = contrast + c * c;
  if (squaredG < 0 || c == 0) return 1;
  const double g = std::sqrt(squaredG);
  const double sum = g + c;
  const double difference = contrast / sum;  // g - c without cancellation for an index near 1
  const double ratio = difference / sum;
  const double polarised = (c * sum - 1) / (c * difference + 1);
  return std::min(1.0, 0.5 * ratio * ratio * (1 + polarised * polarised));
}

double fresnelSchlick(double cosD, double f0) {
  const double m = std::clamp(1 - cosD, 0.0, 1.0);
  const double m2 = m * m;
  return f0 + (1 - f0) * (m2 * m2 * m);
}

double fresnelConductor(double cosD, double eta, double k) {
  const double c = std::clamp(cosD, 0.0, 1.0), cos2 = c * c, sin2 = 1 - cos2;
  const double difference = eta * eta - k * k - sin2;
  const double modulus = std::hypot(difference, 2 * eta * k);  // |index^2 - sin^2|
  const double root = 2 * c * std::sqrt(std::max(0.0, (modulus + difference) / 2));
  const double sum = modulus + cos2;
  if (!(sum + root > 0)) return 1;  // index 1 at grazing angle: the limit of all others
  const double perpendicular = std::max(0.0, sum - root) / (sum + root);
  const double across = cos2 * modulus + sin2 * sin2, along = root * sin2;
  const double ratio = across + along > 0 ? std::max(0.0, across - along) / (across + along) : 1;
  return std::min(1.0, 0.5 * perpendicular * (1 + ratio));
}

ComplexIndex indexFromEdgeTint(double f0, double edgeTint) {
  const double root = std::sqrt(std::max(0.0, f0));
  const double eta = edgeTint * (1 - f0) / (1 + f0) + (1 - edgeTint) * (1 + root) / (1 - root);
  const double k2 = ((eta + 1) * (eta + 1) * f0 - (eta - 1) * (eta - 1)) / (1 - f0);
  return {eta, std::sqrt(std::max(0.0, k2))};
}

double indexFromNormalReflectance(double f0) {
  if (f0 >= 1) return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(std::max(0.0, f0));
  return (1 + root) / (1 - root);
}

Fresnel::Fresnel(FresnelChoice choice, double f0, double edgeTint) : choice_(choice), f0_(f0), index_{1, 0} {
  if (f0 >= 1) return;
  if (choice == FresnelChoice::dielectric) index_.eta = indexFromNormalReflectance(f0);
  if (choice == FresnelChoice::conductor) index_ = indexFromEdgeTint(f0, edgeTint);
}

double Fresnel::operator()(double cosD) const {
  if (f0_ >= 1) return 1;
  switch (choice_) {
    case FresnelChoice::conductor:
      // Exactly a dielectric where it is one: that form does not cancel.
      return index_.k > 0 ? fresnelConductor(cosD, index_.eta, index_.k) : fresnelDielectric(cosD, index_.eta);
    case FresnelChoice::schlick:
      return fresnelSchlick(cosD, f0_);
    default:
      return fresnelDielectric(cosD, index_.eta);
  }
}

}  // namespace gonio::models
