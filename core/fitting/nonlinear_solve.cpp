// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/nonlinear_solve.h"

#include <ceres/ceres.h>

#include <algorithm>

namespace gonio::fitting {

namespace {

class ProjectedCost final : public ceres::CostFunction {
 public:
  explicit ProjectedCost(ProjectedProblem& problem) : problem_(problem) {
    set_num_residuals(problem.residualCount());
    mutable_parameter_block_sizes()->push_back(problem.unknownCount());
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const std::span<const double> units(parameters[0], std::size_t(problem_.unknownCount()));
    // Ceres asks for the Jacobian at the point it evaluated last: the linear parameters are known there.
    if (!std::equal(units.begin(), units.end(), last_.begin(), last_.end())) {
      problem_.cost(units);
      last_.assign(units.begin(), units.end());
    }
    problem_.residuals(residuals);
    if (jacobians && jacobians[0]) problem_.jacobian(jacobians[0]);
    return true;
  }

 private:
  ProjectedProblem& problem_;
  mutable std::vector<double> last_;
};

class Watcher final : public ceres::IterationCallback {
 public:
  Watcher(const std::stop_token& stop, const std::function<void()>& iterationDone)
      : stop_(stop), iterationDone_(iterationDone) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    if (iterationDone_) iterationDone_();
    return stop_.stop_requested() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::stop_token& stop_;
  const std::function<void()>& iterationDone_;
};

}  // namespace

void minimise(ProjectedProblem& problem, std::vector<double> start, const SolveOptions& options,
              const std::stop_token& stop, const std::function<void()>& iterationDone) {
  if (problem.unknownCount() == 0) {
    problem.cost({});
    return;
  }
  ProjectedCost cost(problem);
  Watcher watcher(stop, iterationDone);
  ceres::Problem::Options problemOptions;
  problemOptions.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem ceresProblem(problemOptions);
  for (int k = 0; k < problem.unknownCount(); ++k)
    start[k] = std::clamp(start[k], problem.scale(k).minimum(), problem.scale(k).maximum());
  ceresProblem.AddResidualBlock(&cost, nullptr, start.data());
  for (int k = 0; k < problem.unknownCount(); ++k) {
    ceresProblem.SetParameterLowerBound(start.data(), k, problem.scale(k).minimum());
    ceresProblem.SetParameterUpperBound(start.data(), k, problem.scale(k).maximum());
  }
  ceres::Solver::Options solverOptions;
  solverOptions.linear_solver_type = ceres::DENSE_QR;
  solverOptions.dense_linear_algebra_library_type = ceres::EIGEN;
  solverOptions.num_threads = 1;
  solverOptions.max_num_iterations = options.maxIterations;
  solverOptions.function_tolerance = options.functionTolerance;
  solverOptions.parameter_tolerance = 1e-9;
  solverOptions.gradient_tolerance = 0;
  solverOptions.logging_type = ceres::SILENT;
  solverOptions.callbacks = {&watcher};
  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions, &ceresProblem, &summary);
}

}  // namespace gonio::fitting
