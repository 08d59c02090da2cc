// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

namespace gonio {

/// A quadrature rule with ascending nodes: the integral of f is approximately the sum of weights[i] f(nodes[i]).
struct QuadratureRule {
  std::vector<double> nodes, weights;

  template <typename Function>
  double integrate(Function f) const {
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += weights[i] * f(nodes[i]);
    return sum;
  }
};

/// Gauss-Legendre rule with n >= 1 nodes on [a, b]: exact for polynomials of degree 2n - 1. O(n^2); for many intervals
/// compute the rule once and scale it.
QuadratureRule gaussLegendre(int n, double a = -1, double b = 1);

/// Gauss-Legendre with n nodes on each of `panels` equal parts of [a, b]: for integrands with a narrow peak or kink.
QuadratureRule compositeGaussLegendre(int n, int panels, double a, double b);

}  // namespace gonio
