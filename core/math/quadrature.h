// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

namespace gonio {

/// Nodes, ascending, and weights of a rule: the integral of f is about sum of weights[i] f(nodes[i]).
struct QuadratureRule {
  std::vector<double> nodes, weights;

  template <typename Function>
  double integrate(Function f) const {
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += weights[i] * f(nodes[i]);
    return sum;
  }
};

/// Gauss-Legendre rule with n >= 1 nodes on [a, b]: exact for polynomials of degree 2n - 1. O(n^2); keep the rule
/// rather than the interval when many intervals follow each other.
QuadratureRule gaussLegendre(int n, double a = -1, double b = 1);

/// Gauss-Legendre with n nodes on each of `panels` equal parts of [a, b]: for integrands with a narrow peak or a kink.
QuadratureRule compositeGaussLegendre(int n, int panels, double a, double b);

}  // namespace gonio
