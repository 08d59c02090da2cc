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

double indexFromNormalReflectance(double f0) {
  if (f0 >= 1) return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(std::max(0.0, f0));
  return (1 + root) / (1 - root);
}

}  // namespace gonio::models
