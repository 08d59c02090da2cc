// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/types.h"

/// Parts of the model of He, Torrance, Sillion and Greenberg 1991 that are not closed forms.
namespace gonio::models {

/// ln of the term of order m of heSeries(), for any real m >= 1: ln(g^m exp(-g - a / m) / (m! m)), by Stirling's series
/// (error below 1e-9 for m >= 10).
inline double heLogTerm(double g, double a, double m) {
  const double u = m / g - 1;
  return -g * ((1 + u) * std::log1p(u) - u) - 0.5 * std::log(2 * pi * m) - 1 / (12 * m) + 1 / (360 * m * m * m) -
         std::log(m) - a / m;
}

/// The order m >= 1 of the largest term, to a few percent of the width of the terms, by Newton steps in ln m.
inline double heLargestOrder(double g, double a) {
  double m = std::max(1.0, std::max(g, std::sqrt(a)));
  for (int step = 0; step < 8; ++step) {
    const double slope = std::log(g / (m + 0.5)) - 1 / m + a / (m * m);
    const double curvature = 1 / (m + 0.5) - 1 / (m * m) + 2 * a / (m * m * m);
    const double change = slope / (m * std::max(curvature, 0.3 / m));
    m = std::max(1.0, m * std::exp(std::clamp(change, -1.0, 1.0)));
  }
  return m;
}

/// sum over m >= 1 of g^m exp(-g - a / m) / (m! m): eq. 78 of the paper without its constant, g > 0, a >= 0. Up to an
/// order of 25 term by term; beyond, the sum equals the integral over m, computed by the trapezoidal rule with steps of
/// half the width of the terms. Relative error below 1e-7. About 0.2 us.
inline double heSeries(double g, double a) {
  constexpr double directOrder = 25, smallest = 1e-12;
  const double order = heLargestOrder(g, a);
  if (order <= directOrder) {
    double power = std::exp(-g), sum = 0;
    for (int m = 1; m <= 100; ++m) {
      power *= g / m;
      const double term = power / m * std::exp(-a / m);
      sum += term;
      if (m > order && term <= smallest * sum) break;
    }
    return sum;
  }
  const double width = 1 / std::sqrt(1 / (order + 0.5) - 1 / (order * order) + 2 * a / (order * order * order));
  constexpr int side = 14;
  const double step = width / 2;
  double sum = 0;
  for (int n = -side; n <= side; ++n)
    if (const double m = order + n * step; m >= 1) sum += std::exp(heLogTerm(g, a, m));
  return sum * step;
}

/// (sigma / sigma_0)^2, the part of the mean square height that light and viewer see (eq. 80, 81): 1 / (1 + t^2) with
/// t exp(t^2 / 2) = c. @param c (K_i + K_r) / sqrt(8 pi) >= 0. By Newton's method for ln t^2.
inline double heVisibleRoughness(double c) {
  if (!(c > 1e-8)) return 1;
  const double right = 2 * std::log(c);
  double y = right > 1 ? std::log(right) : right;  // t^2 = exp(y): y + exp(y) = right
  for (int step = 0; step < 8; ++step) {
    const double square = std::exp(y);
    y -= (y + square - right) / (1 + square);
  }
  return 1 / (1 + std::exp(y));
}

}  // namespace gonio::models
