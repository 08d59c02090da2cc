// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/special_functions.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/math/quadrature.h"

namespace gonio {

double logGamma(double x) {
#if defined(__GLIBC__) || defined(__APPLE__)
  int sign;
  return ::lgamma_r(x, &sign);
#else
  return std::lgamma(x);
#endif
}

double logUpperIncompleteGamma(double s, double x) {
  assert(x > 0 && std::isfinite(s) && std::isfinite(x));
  static const QuadratureRule rule = gaussLegendre(16, 0, 1);
  // With t = x e^v: Gamma(s, x) = x^s e^-x times the integral over v > 0 of exp(s v - x (e^v - 1)).
  // Beyond t = x + tail the integrand has fallen below the last digit of the sum.
  const double tail = 60 + 8 * std::max(0.0, s);
  const double end = std::log1p(tail / x);
  const int panels = int(std::ceil(end * std::max(1.0, std::sqrt(x))));
  const double width = end / panels;
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel)
    sum += width * rule.integrate([&](double u) {
      const double v = width * (panel + u);
      return std::exp(s * v - x * std::expm1(v));
    });
  return s * std::log(x) - x + std::log(sum);
}

}  // namespace gonio
