// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/bounded_least_squares.h"

#include <ceres/ceres.h>

#include <algorithm>

namespace gonio::fitting {

namespace {

class DifferencedCost final : public ceres::CostFunction {
 public:
  DifferencedCost(const ResidualFunction& function, std::size_t residualCount, const BoundedVariables& bounds)
      : function_(function), bounds_(bounds) {
    set_num_residuals(int(residualCount));
    mutable_parameter_block_sizes()->push_back(int(bounds.start.size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const auto count = std::size_t(num_residuals()), unknowns = bounds_.start.size();
    const std::span<const double> x(parameters[0], unknowns);
    function_(x, {residuals, count});
    if (!jacobians || !jacobians[0]) return true;
    std::vector<double> moved(x.begin(), x.end()), changed(count);
    for (std::size_t k = 0; k < unknowns; ++k) {
      // Toward the inside: the function is not asked beyond the bounds.
      const double step = x[k] + differenceStep > bounds_.highest[k] ? -differenceStep : differenceStep;
      moved[k] = x[k] + step;
      function_(moved, changed);
      moved[k] = x[k];
      for (std::size_t i = 0; i < count; ++i) jacobians[0][i * unknowns + k] = (changed[i] - residuals[i]) / step;
    }
    return true;
  }

 private:
  static constexpr double differenceStep = 1e-5;

  const ResidualFunction& function_;
  const BoundedVariables& bounds_;
};

class StopWatcher final : public ceres::IterationCallback {
 public:
  explicit StopWatcher(const std::stop_token& stop) : stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return stop_.stop_requested() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::stop_token& stop_;
};

}  // namespace

std::vector<double> boundedLeastSquares(const ResidualFunction& function, std::size_t residualCount,
                                        BoundedVariables variables, int maxIterations, const std::stop_token& stop) {
  std::vector<double> x = variables.start;
  if (x.empty()) return x;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = std::clamp(x[k], variables.lowest[k], variables.highest[k]);
  DifferencedCost cost(function, residualCount, variables);
  StopWatcher watcher(stop);
  ceres::Problem::Options problemOptions;
  problemOptions.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problemOptions);
  problem.AddResidualBlock(&cost, nullptr, x.data());
  for (std::size_t k = 0; k < x.size(); ++k) {
    problem.SetParameterLowerBound(x.data(), int(k), variables.lowest[k]);
    problem.SetParameterUpperBound(x.data(), int(k), variables.highest[k]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.dense_linear_algebra_library_type = ceres::EIGEN;
  options.num_threads = 1;
  options.max_num_iterations = maxIterations;
  options.function_tolerance = 1e-5;
  options.parameter_tolerance = 1e-7;
  options.gradient_tolerance = 0;
  options.logging_type = ceres::SILENT;
  options.callbacks = {&watcher};
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return x;
}

}  // namespace gonio::fitting
