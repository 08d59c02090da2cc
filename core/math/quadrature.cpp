// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/quadrature.h"

#include <cassert>
#include <cmath>

#include "core/math/types.h"

namespace gonio {

namespace {

struct Legendre {
  double value, derivative;
};

/// P_n and P_n' at |x| < 1 by the three-term recurrence.
Legendre legendre(int n, double x) {
  double previous = 0, current = 1;
  for (int k = 0; k < n; ++k) {
    const double next = ((2 * k + 1) * x * current - k * previous) / (k + 1);
    previous = current;
    current = next;
  }
  return {current, n * (previous - x * current) / (1 - x * x)};
}

}  // namespace

QuadratureRule gaussLegendre(int n, double a, double b) {
  assert(n >= 1);
  constexpr int maxSteps = 20;
  QuadratureRule rule{std::vector<double>(n), std::vector<double>(n)};
  const double centre = 0.5 * (a + b), halfWidth = 0.5 * (b - a);
  for (int i = 0; i < n; ++i) {
    // Newton from Tricomi's estimate of the i-th root; quadratic, so a few steps reach the last digit.
    double x = -std::cos(pi * (i + 0.75) / (n + 0.5));
    Legendre p = legendre(n, x);
    for (int step = 0; step < maxSteps && std::abs(p.value) > 1e-16 * std::abs(p.derivative); ++step) {
      x -= p.value / p.derivative;
      p = legendre(n, x);
    }
    rule.nodes[i] = centre + halfWidth * x;
    rule.weights[i] = halfWidth * 2 / ((1 - x * x) * p.derivative * p.derivative);
  }
  return rule;
}

QuadratureRule compositeGaussLegendre(int n, int panels, double a, double b) {
  assert(panels >= 1);
  const QuadratureRule unit = gaussLegendre(n, 0, 1);
  const double width = (b - a) / panels;
  QuadratureRule rule;
  rule.nodes.reserve(std::size_t(n) * panels);
  rule.weights.reserve(std::size_t(n) * panels);
  for (int panel = 0; panel < panels; ++panel)
    for (int i = 0; i < n; ++i) {
      rule.nodes.push_back(a + width * (panel + unit.nodes[i]));
      rule.weights.push_back(width * unit.weights[i]);
    }
  return rule;
}

}  // namespace gonio
