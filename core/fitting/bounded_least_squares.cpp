// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/bounded_least_squares.h"

#include <algorithm>

#include "core/fitting/bounded_quadratic.h"

namespace gonio::fitting {

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
