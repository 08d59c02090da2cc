// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

namespace gonio::fitting {

/// Numbers that a search finds, each within its bounds.
struct BoundedVariables {
  std::vector<double> start, lowest, highest;  ///< of one size; lowest <= highest
};

/// Fills `residuals` at the numbers `x`. Called by one thread.
using ResidualFunction = std::function<void(std::span<const double> x, std::span<double> residuals)>;

/// A local minimum of the sum of the squared residuals within the bounds, by the method of Levenberg (1944) and
/// Marquardt (1963) with forward differences; each step is the exact minimum of the damped problem within the bounds
/// (solveBounded()); never worse than the start. For some ten numbers of a size near 1, with bounds apart by more than
/// 1e-5: an iteration calls the function once for each and a few times more. Deterministic. A stop request ends it
/// early with the best so far.
std::vector<double> boundedLeastSquares(const ResidualFunction& function, std::size_t residualCount,
                                        const BoundedVariables& variables, int maxIterations,
                                        const std::stop_token& stop = {});

}  // namespace gonio::fitting
