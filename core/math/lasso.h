// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio {

/// Basis pursuit denoising (Chen, Donoho and Saunders 1998, "Atomic Decomposition by Basis Pursuit"; the lasso of
/// Tibshirani 1996) of a small dense system: the c that minimises |A c - b|^2 / 2 + lambda |c|_1. For lambda -> 0 and
/// fewer rows than columns, it is the solution of A c = b with the smallest sum of absolute values. By cyclic
/// coordinate descent (Friedman, Hastie and Tibshirani 2010, "Regularization Paths for Generalized Linear Models via
/// Coordinate Descent"), until no coordinate changes A c by more than 1e-9 of |b|.
class Lasso {
 public:
  explicit Lasso(const Eigen::MatrixXd& a);

  /// The smallest lambda for which the solution is 0: the largest absolute value of A^T b.
  double largestPenalty(const Eigen::VectorXd& b) const;

  /// @param lambda > 0. @param start a guess, such as the solution for a somewhat larger lambda; receives the solution.
  /// O(rows columns) a sweep.
  void solve(const Eigen::VectorXd& b, double lambda, Eigen::VectorXd& start) const;

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd squares_;  ///< squared lengths of the columns
};

}  // namespace gonio
