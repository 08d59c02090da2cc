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
  const double contrast = (eta - 1) * (eta + 1) - k * k, product = 2 * eta * k;
  // (a + i b)^2 = index^2 - sin^2; the smaller of a^2 and b^2 by their product, where the difference would cancel.
  const double difference = contrast + cos2, modulus = std::sqrt(difference * difference + product * product);
  const double larger = (modulus + std::abs(difference)) / 2;
  const double smaller = larger > 0 ? product * product / (4 * larger) : 0;
  const double a = std::sqrt(difference > 0 ? larger : smaller), b2 = difference > 0 ? smaller : larger;
  const double sum = a + c;
  if (!(sum > 0)) return 1;  // total reflection, and index 1 at grazing angle: the limit of all others
  // a - c without cancellation for an index near 1.
  const double excess = contrast + (contrast * (contrast + 2 * cos2) + product * product) / (modulus + cos2);
  const double apart = excess / (2 * sum);
  const double perpendicular = (apart * apart + b2) / (sum * sum + b2);
  const double across = a * c - sin2, along = a * c + sin2;
  const double ratio = (across * across + b2 * cos2) / (along * along + b2 * cos2);
  return std::min(1.0, 0.5 * perpendicular * (1 + ratio));
}

ComplexIndex indexFromEdgeTint(double f0, double edgeTint) {
  const double root = std::sqrt(std::max(0.0, f0)), g = edgeTint;
  const double highest = (1 + root) / (1 - root), lowest = (1 - f0) / (1 + f0);
  // The paper's k^2 in factors that do not cancel: (highest - eta)(eta - 1 / highest).
  const double below = g * 2 * root * (1 + root) / ((1 - root) * (1 + f0));
  const double above = (1 - g) * 4 * root / (1 - f0) + g * 2 * root * (1 - root) / ((1 + f0) * (1 + root));
  return {g * lowest + (1 - g) * highest, std::sqrt(below * above)};
}

double fresnelTransmittance(double cosD, double eta) {
  if (std::isinf(eta)) return 0;
  const double c = std::clamp(cosD, 0.0, 1.0);
  const double squaredG = (eta - 1) * (eta + 1) + c * c;
  if (squaredG < 0 || c == 0) return eta == 1 ? 1 : 0;
  const double g = std::sqrt(squaredG);  // eta times the cosine inside
  const double s = g + c, p = g / eta + c * eta;
  return std::min(1.0, 2 * c * g * (1 / (s * s) + 1 / (p * p)));
}

double normalReflectanceFromIndex(double eta) {
  const double ratio = (eta - 1) / (eta + 1);
  return ratio * ratio;
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
