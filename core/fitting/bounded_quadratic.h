// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio::fitting {

using LinearVector = Eigen::VectorXd;
using LinearMatrix = Eigen::MatrixXd;

/// Minimises x^T N x / 2 - b^T x subject to lower <= x <= upper, where lower <= 0 <= upper. `normal` is symmetric and
/// positive semi-definite; a variable with a zero row becomes 0, and for linearly dependent variables any solution may
/// be returned. Up to four variables: the best of all active sets, exact, O(3^n). More: the active-set method of Stark
/// and Parker 1995, "Bounded-Variable Least-Squares: an Algorithm and Applications", from the unconstrained minimum;
/// O(n^3) per change of the set.
LinearVector solveBounded(const LinearMatrix& normal, const LinearVector& rightSide, const LinearVector& lower,
                          const LinearVector& upper);

}  // namespace gonio::fitting
