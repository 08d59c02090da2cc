// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>

#include "core/math/fast_functions.h"

/// Parts of the SGD model: Bagher, Soler and Holzschuch 2012, "Accurate Fitting of Measured Reflectances using a
/// Shifted Gamma Micro-facet Distribution".
namespace gonio::models {

/// ln K, K = 1 / (alpha Gamma(1 - p, alpha)), the factor with which D cos theta_h integrates to 1 over the hemisphere.
/// alpha > 0.
double sgdLogNormalisation(double alpha, double p);

/// G1 = 1 - lambda (exp(c (theta - theta0)^k) - 1), clamped to [0, 1], at the polar angle theta (rad); exactly 1 for
/// theta <= theta0 (rad). @param logC ln c, because c is up to 1e109 in
/// published fits and c (theta - theta0)^k would overflow.
[[gnu::always_inline]] inline double sgdMasking(double theta, double lambda, double logC, double k, double theta0) {
  constexpr double maxExponent = 700;  // exp() of it is finite
  const double beyond = theta - theta0;
  const double growth = fastExp(std::min(maxExponent, logC + k * fastLog(std::max(beyond, 1e-300))));
  const double masked = std::clamp(1 - lambda * fastExpm1(std::min(maxExponent, growth)), 0.0, 1.0);
  return beyond > 0 ? masked : 1.0;
}

}  // namespace gonio::models
