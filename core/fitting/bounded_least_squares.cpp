// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/bounded_least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace gonio::fitting {

namespace {

/// Up to here all active sets are tried.
constexpr int fewVariables = 4;
/// A bound is left only for a slope that rounding does not explain; the variables have unit curvature.
constexpr double slopeTolerance = 1e-12;

enum class State { lower, free, upper };
using States = std::vector<State>;

/// The problem in variables of unit curvature: columns of highlights are a million times larger than diffuse ones.
/// @tparam maxVariables known beforehand, so that nothing is allocated; Eigen::Dynamic: any number.
template <int maxVariables>
struct Problem {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, maxVariables, maxVariables>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, maxVariables, 1>;
  using Indices = Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1, 0, maxVariables, 1>;

  Matrix n;
  Vector b, lower, upper;
  std::vector<bool> isSeen;

  double value(const Vector& x) const { return 0.5 * x.dot(n * x) - b.dot(x); }
  bool isInside(const Vector& x) const { return ((x.array() >= lower.array()) && (x.array() <= upper.array())).all(); }

  /// The minimum over the free variables with the others at their bounds; it may lie outside the bounds.
  Vector minimumOf(const States& states) const {
    Indices free(b.size());
    Eigen::Index freeCount = 0;
    Vector x = Vector::Zero(b.size());
    for (Eigen::Index j = 0; j < b.size(); ++j) {
      if (states[std::size_t(j)] == State::free)
        free[freeCount++] = j;
      else
        x[j] = states[std::size_t(j)] == State::upper ? upper[j] : lower[j];
    }
    if (freeCount == 0) return x;
    free.conservativeResize(freeCount);
    const Matrix reduced = n(free, free);
    const Vector right = b(free) - n(free, Eigen::all) * x;
    const Vector solution = reduced.ldlt().solve(right);
    x(free) = solution;
    return x;
  }
};

/// Steps through all combinations of three states of the variables that are seen; false after the last.
template <int maxVariables>
bool nextStates(const Problem<maxVariables>& problem, States& states) {
  for (std::size_t j = 0; j < states.size(); ++j) {
    if (!problem.isSeen[j]) continue;
    if (states[j] != State::upper) {
      states[j] = static_cast<State>(static_cast<int>(states[j]) + 1);
      return true;
    }
    states[j] = State::lower;
  }
  return false;
}

/// Variables that are not seen have both bounds at 0.
template <int maxVariables>
States allAt(const Problem<maxVariables>& problem, State state) {
  States states(problem.isSeen.size(), state);
  for (std::size_t j = 0; j < states.size(); ++j)
    if (!problem.isSeen[j]) states[j] = State::lower;
  return states;
}

template <int maxVariables>
auto bestOfAllSets(const Problem<maxVariables>& problem) {
  using Vector = typename Problem<maxVariables>::Vector;
  Vector best = Vector::Zero(problem.b.size());
  double lowest = 0;
  States states = allAt(problem, State::lower);
  do {
    const Vector x = problem.minimumOf(states);
    if (!problem.isInside(x)) continue;
    const double value = problem.value(x);
    if (value < lowest) {
      lowest = value;
      best = x;
    }
  } while (nextStates(problem, states));
  return best;
}

using AnyProblem = Problem<Eigen::Dynamic>;

class ActiveSet {
 public:
  /// @param start its part outside the bounds is moved to them.
  ActiveSet(const AnyProblem& problem, const LinearVector& start) : p_(problem), states_(allAt(problem, State::free)) {
    x_ = start.allFinite() ? start : LinearVector::Zero(start.size());
    x_ = x_.cwiseMax(p_.lower).cwiseMin(p_.upper);
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      if (x_[j] <= p_.lower[j])
        state(j) = State::lower;
      else if (x_[j] >= p_.upper[j])
        state(j) = State::upper;
    }
  }

  LinearVector solve() {
    settle();
    // Each turn lowers the value, so no set comes twice; rounding is what the limit is for.
    for (Eigen::Index turn = 0; turn < 10 * x_.size(); ++turn) {
      const Eigen::Index j = steepest();
      if (j < 0) break;
      const LinearVector before = x_;
      const States statesBefore = states_;
      state(j) = State::free;
      settle();
      if (p_.value(x_) < p_.value(before)) continue;
      x_ = before;
      states_ = statesBefore;
      break;
    }
    return x_;
  }

 private:
  State& state(Eigen::Index j) { return states_[std::size_t(j)]; }

  /// Goes to the minimum over the free variables; each that meets its bound on the way stays there.
  void settle() {
    for (Eigen::Index step = 0; step <= x_.size(); ++step) {
      const LinearVector target = p_.minimumOf(states_);
      if (!target.allFinite()) break;
      double fraction = 1;
      Eigen::Index blocking = -1;
      for (Eigen::Index j = 0; j < x_.size(); ++j) {
        if (state(j) != State::free) continue;
        const double bound = target[j] < p_.lower[j] ? p_.lower[j] : p_.upper[j];
        if (target[j] >= p_.lower[j] && target[j] <= p_.upper[j]) continue;
        const double reach = (bound - x_[j]) / (target[j] - x_[j]);
        if (reach < fraction || blocking < 0) {
          fraction = std::clamp(reach, 0.0, 1.0);
          blocking = j;
        }
      }
      x_ += fraction * (target - x_);
      if (blocking < 0) break;
      state(blocking) = target[blocking] < p_.lower[blocking] ? State::lower : State::upper;
      x_[blocking] = state(blocking) == State::lower ? p_.lower[blocking] : p_.upper[blocking];
    }
    x_ = x_.cwiseMax(p_.lower).cwiseMin(p_.upper);
  }

  /// The variable at a bound along which the value falls most steeply inward, or -1.
  Eigen::Index steepest() const {
    const LinearVector slope = p_.b - p_.n * x_;
    Eigen::Index best = -1;
    double most = slopeTolerance * (1 + p_.b.cwiseAbs().maxCoeff());
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      const State s = states_[std::size_t(j)];
      if (s == State::free || !p_.isSeen[std::size_t(j)]) continue;
      const double inward = s == State::lower ? slope[j] : -slope[j];
      if (inward > most) {
        most = inward;
        best = j;
      }
    }
    return best;
  }

  const AnyProblem& p_;
  States states_;
  LinearVector x_;
};

template <int maxVariables>
LinearVector solveProblem(const LinearMatrix& normal, const LinearVector& rightSide, const LinearVector& lower,
                          const LinearVector& upper) {
  using Vector = typename Problem<maxVariables>::Vector;
  const Eigen::Index count = normal.rows();
  Vector scale = Vector::Zero(count);
  Problem<maxVariables> problem;
  problem.isSeen.resize(std::size_t(count));
  problem.lower = problem.upper = Vector::Zero(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    problem.isSeen[std::size_t(j)] = normal(j, j) > 0;
    if (!problem.isSeen[std::size_t(j)]) continue;
    scale[j] = 1 / std::sqrt(normal(j, j));
    problem.lower[j] = lower[j] / scale[j];
    problem.upper[j] = upper[j] / scale[j];
  }
  problem.n = scale.asDiagonal() * normal * scale.asDiagonal();
  problem.b = scale.cwiseProduct(rightSide);
  // The free minimum, where it is inside, is the answer.
  Vector x = problem.minimumOf(allAt(problem, State::free));
  if (!problem.isInside(x)) {
    if constexpr (maxVariables == Eigen::Dynamic)
      x = ActiveSet(problem, x).solve();
    else
      x = bestOfAllSets(problem);
  }
  LinearVector result(count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const double value = x[j] == problem.upper[j] ? upper[j] : x[j] == problem.lower[j] ? lower[j] : scale[j] * x[j];
    result[j] = problem.isSeen[std::size_t(j)] ? std::clamp(value, lower[j], upper[j]) : 0;
  }
  return result;
}

}  // namespace

LinearVector solveBounded(const LinearMatrix& normal, const LinearVector& rightSide, const LinearVector& lower,
                          const LinearVector& upper) {
  return normal.rows() <= fewVariables ? solveProblem<fewVariables>(normal, rightSide, lower, upper)
                                       : solveProblem<Eigen::Dynamic>(normal, rightSide, lower, upper);
}

namespace {

constexpr double quotientStep = 1e-5, firstDamping = 1e-3, costTolerance = 1e-5;
constexpr int triesOfStep = 8;

class BoundedSearch {
 public:
  BoundedSearch(const ResidualFunction& function, std::size_t residualCount, const BoundedVariables& variables)
      : function_(function), lower_(asVector(variables.minimum)), upper_(asVector(variables.maximum)) {
    x_ = asVector(variables.start).cwiseMax(lower_).cwiseMin(upper_);
    residuals_ = residualsAt(x_, residualCount);
  }

  /// One iteration; false where the cost no longer falls.
  bool improve() {
    const LinearMatrix jacobian = differences();
    const LinearMatrix normal = jacobian.transpose() * jacobian;
    const LinearVector slope = jacobian.transpose() * residuals_;
    const double cost = residuals_.squaredNorm();
    for (int k = 0; k < triesOfStep; ++k) {
      LinearMatrix damped = normal;
      damped.diagonal() *= 1 + damping_;
      const LinearVector step = solveBounded(damped, -slope, lower_ - x_, upper_ - x_);
      const LinearVector next = (x_ + step).cwiseMax(lower_).cwiseMin(upper_);
      LinearVector residuals = residualsAt(next, std::size_t(residuals_.size()));
      const double lowered = cost - residuals.squaredNorm();
      if (lowered > 0) {
        x_ = next;
        residuals_ = std::move(residuals);
        damping_ *= 0.2;
        return lowered > costTolerance * cost;
      }
      damping_ *= 5;
    }
    return false;
  }

  std::vector<double> values() const { return {x_.begin(), x_.end()}; }

 private:
  static LinearVector asVector(const std::vector<double>& values) {
    return Eigen::Map<const LinearVector>(values.data(), Eigen::Index(values.size()));
  }
  LinearVector residualsAt(const LinearVector& x, std::size_t count) const {
    LinearVector residuals = LinearVector::Zero(Eigen::Index(count));
    function_({x.data(), std::size_t(x.size())}, {residuals.data(), count});
    return residuals;
  }
  LinearMatrix differences() const {
    LinearMatrix jacobian(residuals_.size(), x_.size());
    LinearVector moved = x_;
    for (Eigen::Index k = 0; k < x_.size(); ++k) {
      // Toward the inside: the function is not asked beyond the bounds.
      const double step = x_(k) + quotientStep > upper_(k) ? -quotientStep : quotientStep;
      moved(k) = x_(k) + step;
      jacobian.col(k) = (residualsAt(moved, std::size_t(residuals_.size())) - residuals_) / step;
      moved(k) = x_(k);
    }
    return jacobian;
  }

  const ResidualFunction& function_;
  LinearVector lower_, upper_, x_, residuals_;
  double damping_ = firstDamping;
};

}  // namespace

std::vector<double> boundedLeastSquares(const ResidualFunction& function, std::size_t residualCount,
                                        const BoundedVariables& variables, int maxIterations,
                                        const std::stop_token& stop) {
  if (variables.start.empty()) return {};
  BoundedSearch search(function, residualCount, variables);
  for (int k = 0; k < maxIterations && !stop.stop_requested() && search.improve(); ++k) continue;
  return search.values();
}

}  // namespace gonio::fitting
