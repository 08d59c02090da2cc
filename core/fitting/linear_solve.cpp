// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/linear_solve.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace gonio::fitting {

namespace {

constexpr int maxSteps = 50;
constexpr int maxHalvings = 12;
constexpr double stepTolerance = 1e-9;   ///< of each parameter, relative: Gauss-Newton's next error is its square
constexpr double costTolerance = 1e-13;  ///< relative

enum class State { lower, free, upper };

double quadratic(const LinearMatrix& n, const LinearVector& b, const LinearVector& x) {
  return 0.5 * x.dot(n * x) - b.dot(x);
}

/// The minimum over the free variables with the others at their bounds; false where it leaves the bounds.
bool solveActiveSet(const LinearMatrix& n, const LinearVector& b, const LinearVector& upper,
                    std::span<const State> states, LinearVector& x) {
  std::array<Eigen::Index, maxLinearParameters> free;
  Eigen::Index count = 0;
  for (Eigen::Index j = 0; j < n.rows(); ++j) {
    x[j] = states[j] == State::upper ? upper[j] : 0;
    if (states[j] == State::free) free[count++] = j;
  }
  if (count == 0) return true;
  LinearMatrix reduced(count, count);
  LinearVector right(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    right[r] = b[free[r]];
    for (Eigen::Index j = 0; j < n.rows(); ++j)
      if (states[j] != State::free) right[r] -= n(free[r], j) * x[j];
    for (Eigen::Index c = 0; c < count; ++c) reduced(r, c) = n(free[r], free[c]);
  }
  const LinearVector solution = reduced.ldlt().solve(right);
  for (Eigen::Index r = 0; r < count; ++r) {
    if (!(solution[r] >= 0) || !(solution[r] <= upper[free[r]])) return false;
    x[free[r]] = solution[r];
  }
  return true;
}

/// Steps through all combinations of three states; false after the last.
bool nextStates(std::span<State> states) {
  for (State& state : states) {
    if (state != State::upper) {
      state = static_cast<State>(static_cast<int>(state) + 1);
      return true;
    }
    state = State::lower;
  }
  return false;
}

/// Gauss-Newton's normal equations: of the basis columns times `slopes`, for the parameters themselves.
struct NormalEquations {
  LinearMatrix matrix;
  LinearVector right;

  NormalEquations(const ChannelProblem& problem, std::span<const double> slopes, std::span<const double> target) {
    const Eigen::Index count = Eigen::Index(problem.bases.size());
    matrix = LinearMatrix::Zero(count, count);
    right = LinearVector::Zero(count);
    for (Eigen::Index a = 0; a < count; ++a) {
      const std::span<const double> basis = problem.bases[a];
      for (Eigen::Index b = 0; b <= a; ++b) {
        double sum = 0;
        for (std::size_t i = 0; i < slopes.size(); ++i) sum += slopes[i] * slopes[i] * basis[i] * problem.bases[b][i];
        matrix(a, b) = matrix(b, a) = sum;
      }
      for (std::size_t i = 0; i < slopes.size(); ++i) right[a] += slopes[i] * basis[i] * target[i];
    }
  }
};

double computeResiduals(const ChannelProblem& problem, const LinearVector& p, std::vector<double>& residuals) {
  residuals.resize(problem.size());
  double cost = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const double d = problem.metric.transform(problem.model(p, i) * problem.factor[i]) - problem.transformed[i];
    residuals[i] = problem.rootWeight[i] * problem.metric.shape(d);
    cost += residuals[i] * residuals[i];
  }
  return cost;
}

/// The linear problem with the transform replaced by its tangent at the measurement.
LinearVector startParameters(const ChannelProblem& problem) {
  std::vector<double> target(problem.size());
  for (std::size_t i = 0; i < target.size(); ++i) target[i] = problem.startWeight[i] * problem.values[i];
  const NormalEquations normal(problem, problem.startWeight, target);
  return solveBounded(normal.matrix, normal.right, problem.upper);
}

/// Where one Gauss-Newton step (reweighted for the mean of absolute values) would go.
LinearVector gaussNewtonTarget(const ChannelProblem& problem, const ChannelSolution& at) {
  std::vector<double> slopes(problem.size()), target(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const double model = problem.model(at.parameters, i);
    const double x = model * problem.factor[i];
    double weight = problem.rootWeight[i];
    if (problem.metric.isReweighted())
      weight *= problem.metric.reweight(problem.metric.transform(x) - problem.transformed[i]);
    slopes[i] = weight * problem.metric.slope(x) * problem.factor[i];
    target[i] = slopes[i] * model - at.residuals[i];
  }
  const NormalEquations normal(problem, slopes, target);
  return solveBounded(normal.matrix, normal.right, problem.upper);
}

}  // namespace

LinearVector solveBounded(const LinearMatrix& normal, const LinearVector& rightSide, const LinearVector& upper) {
  const Eigen::Index count = normal.rows();
  assert(count <= maxLinearParameters);
  // Unit diagonal: columns of highlights are a million times larger than diffuse ones.
  LinearVector scale(count);
  for (Eigen::Index j = 0; j < count; ++j) scale[j] = normal(j, j) > 0 ? 1 / std::sqrt(normal(j, j)) : 0;
  const LinearMatrix n = scale.asDiagonal() * normal * scale.asDiagonal();
  const LinearVector b = scale.cwiseProduct(rightSide);
  LinearVector bound(count);
  for (Eigen::Index j = 0; j < count; ++j) bound[j] = scale[j] > 0 ? upper[j] / scale[j] : 0;
  std::array<State, maxLinearParameters> states;
  states.fill(State::free);
  const std::span<State> active(states.data(), std::size_t(count));
  for (Eigen::Index j = 0; j < count; ++j)
    if (!(scale[j] > 0)) states[j] = State::lower;
  LinearVector best = LinearVector::Zero(count), x(count);
  // The free minimum, where it is inside, is the answer; else the best of all faces.
  if (!solveActiveSet(n, b, bound, active, best)) {
    best.setZero();
    double lowest = 0;
    states.fill(State::lower);
    while (nextStates(active)) {
      if (!solveActiveSet(n, b, bound, active, x)) continue;
      const double value = quadratic(n, b, x);
      if (value < lowest) {
        lowest = value;
        best = x;
      }
    }
  }
  LinearVector result(count);
  for (Eigen::Index j = 0; j < count; ++j)
    result[j] = best[j] == bound[j] && scale[j] > 0 ? upper[j] : std::min(scale[j] * best[j], upper[j]);
  return result;
}

ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess) {
  ChannelSolution best, trial;
  best.parameters = startParameters(problem);
  best.cost = computeResiduals(problem, best.parameters, best.residuals);
  if (guess.size() == best.parameters.size()) {
    trial.parameters = guess;
    trial.cost = computeResiduals(problem, guess, trial.residuals);
    if (trial.cost < best.cost) std::swap(best, trial);
  }
  for (int step = 0; step < maxSteps && best.parameters.size() > 0; ++step) {
    const LinearVector from = best.parameters, to = gaussNewtonTarget(problem, best);
    if (((to - from).array().abs() <= stepTolerance * to.array().abs()).all()) break;
    const double costBefore = best.cost;
    double share = 1;
    for (int halving = 0; halving <= maxHalvings; ++halving, share /= 2) {
      trial.parameters = from + share * (to - from);
      trial.cost = computeResiduals(problem, trial.parameters, trial.residuals);
      if (trial.cost < best.cost) break;
    }
    if (!(trial.cost < best.cost)) break;
    std::swap(best, trial);
    if (best.cost >= (1 - costTolerance) * costBefore) break;
  }
  return best;
}

}  // namespace gonio::fitting
