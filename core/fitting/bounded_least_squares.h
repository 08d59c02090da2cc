// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

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

/// Variables of a search, with bounds.
struct BoundedVariables {
  std::vector<double> start, minimum, maximum;  ///< of equal size; minimum <= maximum
};

/// Computes the residuals at `x`. Called from one thread at a time.
using ResidualFunction = std::function<void(std::span<const double> x, std::span<double> residuals)>;

/// A local minimum of the sum of squared residuals within the bounds, by the method of Levenberg (1944) and Marquardt
/// (1963) with forward differences. Each step is the exact minimum of the damped problem within the bounds
/// (solveBounded()). The result is never worse than the start. Designed for about ten variables of magnitude near 1
/// with bounds more than 1e-5 apart; an iteration calls the function once per variable and a few times more.
/// Deterministic. A stop request ends the search early with the best result so far. Not by Ceres, which takes three to
/// ten times as long for fits that end at bounds, as most fits of shaders do, and ends at larger residuals.
std::vector<double> boundedLeastSquares(const ResidualFunction& function, std::size_t residualCount,
                                        const BoundedVariables& variables, int maxIterations,
                                        const std::stop_token& stop = {});

}  // namespace gonio::fitting
