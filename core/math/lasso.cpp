// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/lasso.h"

#include <algorithm>
#include <cmath>

namespace gonio {

Lasso::Lasso(const Eigen::MatrixXd& a) : a_(a), squares_(a.colwise().squaredNorm()) {}

double Lasso::largestPenalty(const Eigen::VectorXd& b) const {
  return a_.cols() > 0 ? (a_.transpose() * b).cwiseAbs().maxCoeff() : 0;
}

void Lasso::solve(const Eigen::VectorXd& b, double lambda, Eigen::VectorXd& start) const {
  constexpr int maxSweeps = 10'000;
  constexpr double tolerance = 1e-9;
  const double smallest = tolerance * b.norm();
  Eigen::VectorXd remainder = b - a_ * start;
  for (int sweep = 0; sweep < maxSweeps; ++sweep) {
    double largest = 0;
    for (Eigen::Index i = 0; i < a_.cols(); ++i) {
      if (!(squares_[i] > 0)) continue;
      const double along = a_.col(i).dot(remainder) + squares_[i] * start[i];
      const double next = std::copysign(std::max(0.0, std::abs(along) - lambda), along) / squares_[i];
      if (next == start[i]) continue;
      remainder -= (next - start[i]) * a_.col(i);
      largest = std::max(largest, std::abs(next - start[i]) * std::sqrt(squares_[i]));
      start[i] = next;
    }
    if (largest <= smallest) return;
  }
}

}  // namespace gonio
