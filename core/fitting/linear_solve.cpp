// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/linear_solve.h"

#include <cmath>

namespace gonio::fitting {

namespace {

constexpr int maxSteps = 50;
constexpr int maxHalvings = 12;
constexpr double stepTolerance = 1e-9;  ///< of each parameter, relative: Gauss-Newton's next error is its square

/// Gauss-Newton's bounded linear problem: the basis columns times `slopes` against `target`.
LinearVector solveNormalEquations(const ChannelProblem& problem, std::span<const double> slopes,
                                  std::span<const double> target) {
  const Eigen::Index cells = Eigen::Index(slopes.size()), count = Eigen::Index(problem.bases.size());
  const Eigen::Map<const Eigen::ArrayXd> rowWeights(slopes.data(), cells);
  LinearMatrix columns(cells, count);
  for (Eigen::Index j = 0; j < count; ++j)
    columns.col(j) = rowWeights * Eigen::Map<const Eigen::ArrayXd>(problem.bases[std::size_t(j)].data(), cells);
  LinearMatrix half = LinearMatrix::Zero(count, count);
  half.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  const LinearMatrix normal = half.selfadjointView<Eigen::Lower>();
  const LinearVector right = columns.transpose() * Eigen::Map<const Eigen::VectorXd>(target.data(), cells);
  return solveBounded(normal, right, problem.lower, problem.upper);
}

/// The model, the residuals and the cost at the solution's parameters.
void evaluate(const ChannelProblem& problem, ChannelSolution& solution) {
  solution.model = problem.model(solution.parameters);
  std::vector<double>& residuals = solution.residuals;
  residuals.resize(problem.size());
  problem.metric.visitTransform([&](const auto& transform) {
    for (std::size_t i = 0; i < residuals.size(); ++i)
      residuals[i] = transform(solution.model[i] * problem.factor[i]) - problem.transformed[i];
  });
  solution.cost = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    residuals[i] = problem.rootWeight[i] * problem.metric.shape(residuals[i]);
    solution.cost += residuals[i] * residuals[i];
  }
}

/// The linear problem with the transform replaced by its tangent at the measurement.
LinearVector startParameters(const ChannelProblem& problem) {
  std::vector<double> target(problem.size());
  for (std::size_t i = 0; i < target.size(); ++i) target[i] = problem.startWeight[i] * problem.values[i];
  return solveNormalEquations(problem, problem.startWeight, target);
}

/// Where one Gauss-Newton step (reweighted for the means of |d|^p) would go.
LinearVector gaussNewtonTarget(const ChannelProblem& problem, const ChannelSolution& at) {
  std::vector<double> slopes(problem.size()), target(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const double x = at.model[i] * problem.factor[i];
    double weight = problem.rootWeight[i];
    if (problem.metric.isReweighted())
      weight *= problem.metric.reweight(problem.metric.transform(x) - problem.transformed[i]);
    slopes[i] = weight * problem.metric.slope(x) * problem.factor[i];
    target[i] = slopes[i] * at.model[i] - at.residuals[i];
  }
  return solveNormalEquations(problem, slopes, target);
}

}  // namespace

std::vector<double> ChannelProblem::model(const LinearVector& p) const {
  std::vector<double> sums(size(), 0.0);
  for (std::size_t j = 0; j < bases.size(); ++j) {
    const double fraction = p[Eigen::Index(j)];
    if (fraction == 0) continue;
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += fraction * bases[j][i];
  }
  return sums;
}

ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess) {
  ChannelSolution best, trial;
  best.parameters = startParameters(problem);
  evaluate(problem, best);
  if (guess.size() == best.parameters.size()) {
    trial.parameters = guess;
    evaluate(problem, trial);
    if (trial.cost < best.cost) std::swap(best, trial);
  }
  for (int step = 0; step < maxSteps && best.parameters.size() > 0; ++step) {
    const LinearVector from = best.parameters, to = gaussNewtonTarget(problem, best);
    if (((to - from).array().abs() <= stepTolerance * to.array().abs()).all()) break;
    const double costBefore = best.cost;
    double fraction = 1;
    for (int halving = 0; halving <= maxHalvings; ++halving, fraction /= 2) {
      trial.parameters = from + fraction * (to - from);
      evaluate(problem, trial);
      if (trial.cost < best.cost) break;
    }
    if (!(trial.cost < best.cost)) break;
    std::swap(best, trial);
    if (best.cost >= (1 - problem.costTolerance) * costBefore) break;
  }
  return best;
}

}  // namespace gonio::fitting
