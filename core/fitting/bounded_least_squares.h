// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace gonio::fitting {

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
/// Deterministic. A stop request ends the search early with the best result so far.
std::vector<double> boundedLeastSquares(const ResidualFunction& function, std::size_t residualCount,
                                        const BoundedVariables& variables, int maxIterations,
                                        const std::stop_token& stop = {});

}  // namespace gonio::fitting
