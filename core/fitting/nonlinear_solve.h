// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <stop_token>

#include "core/fitting/projected_problem.h"

namespace gonio::fitting {

struct SolveOptions {
  int maxIterations = 30;
  double functionTolerance = 1e-6;  ///< relative change of the cost at which it stops
};

/// Minimises the problem's cost from `start` (units) by a trust-region Levenberg-Marquardt method within the hard
/// ranges (Ceres). The result is problem.bestParameters(): never worse than the start. Stops early on request.
/// @param iterationDone called after each iteration.
void minimise(ProjectedProblem& problem, std::vector<double> start, const SolveOptions& options,
              const std::stop_token& stop, const std::function<void()>& iterationDone = {});

}  // namespace gonio::fitting
