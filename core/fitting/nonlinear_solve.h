// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <stop_token>

#include "core/fitting/projected_problem.h"

namespace gonio::fitting {

struct SolveOptions {
  int maxIterations = 30;
  double functionTolerance = 1e-6;  ///< relative change of the cost at which the search stops
};

/// Minimises the problem's cost from `start` (in units of UnitScale) within the hard ranges, by Ceres' trust-region
/// Levenberg-Marquardt method. The result is problem.bestParameters(), never worse than the start. A stop request ends
/// it early. @param iterationDone called after each iteration.
void minimise(ProjectedProblem& problem, std::vector<double> start, const SolveOptions& options,
              const std::stop_token& stop, const std::function<void()>& iterationDone = {});

}  // namespace gonio::fitting
