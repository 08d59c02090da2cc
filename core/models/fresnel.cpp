// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio::models {

ComplexIndex indexFromEdgeTint(double f0, double edgeTint) {
  const double root = std::sqrt(std::max(0.0, f0)), g = edgeTint;
  const double highest = (1 + root) / (1 - root), lowest = (1 - f0) / (1 + f0);
  // The paper's k^2 in factors that do not cancel: (highest - eta)(eta - 1 / highest).
  const double below = g * 2 * root * (1 + root) / ((1 - root) * (1 + f0));
  const double above = (1 - g) * 4 * root / (1 - f0) + g * 2 * root * (1 - root) / ((1 + f0) * (1 + root));
  return {g * lowest + (1 - g) * highest, std::sqrt(below * above)};
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

Fresnel::Fresnel(FresnelChoice choice, double f0, double edgeTint) : FresnelTerm{} {
  if (f0 >= 1) {
    constant = 1;
  } else if (choice == FresnelChoice::schlick) {
    constant = f0;
    risingFraction = 1 - f0;
  } else {
    const ComplexIndex index = choice == FresnelChoice::conductor ? indexFromEdgeTint(f0, edgeTint)
                                                                  : ComplexIndex{indexFromNormalReflectance(f0), 0};
    contrast = (index.eta - 1) * (index.eta + 1) - index.k * index.k;
    product = 2 * index.eta * index.k;
    exactFraction = contrast != 0 || product != 0 ? 1 : 0;
  }
}

}  // namespace gonio::models
