// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/math/decompositions.h"

namespace gonio {

/// Ridge regression (Hoerl and Kennard 1970): the coefficients c that minimise |A c - b|^2 + ridge |c|^2, for all
/// columns b of B. One singular value decomposition of A serves all ridges; A^T A, which would square the condition
/// number, is never formed. A may have fewer rows than columns. Singular values of at most 1e-8 of the largest count as
/// 0.
class RidgeRegression {
 public:
  /// @param rows A, rows x columns. @param values B, rows x right-hand sides. Cost: O(rows columns min(rows, columns)).
  RidgeRegression(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& values);

  Eigen::Index rowCount() const { return svd_.u.rows(); }

  /// (A^T A + ridge I)^-1 A^T B: columns x right-hand sides. With ridge 0 this is the solution of least norm; with an
  /// infinite ridge it is 0. @param ridge >= 0.
  Eigen::MatrixXd coefficients(double ridge) const;

  /// Leave-one-out residuals: each row of B minus its prediction from all other rows, in closed form: the i-th row of H
  /// B divided by H_ii, H = (A A^T + ridge I)^-1. @param ridge > 0, finite.
  Eigen::MatrixXd leaveOneOut(double ridge) const;

  /// The ridges to try: ten per decade, from 1e3 down to 1e-7 times the largest squared singular value. Empty if the
  /// values carry no information about the ridge: A is 0 or has one row.
  std::vector<double> triedRidges() const;

  /// bestRidge() of triedRidges() by the sums of squares of leaveOneOut(). @param otherwise result if there are none.
  double leaveOneOutRidge(double otherwise) const;

  /// trace(B^T (A A^T + ridge I)^-1 B). Divided by the number of values, it is the most likely variance v of the
  /// coefficients, and ridge v is the most likely variance of the noise of B, if both are Gaussian. @param ridge >= 0;
  /// with 0 the part of B outside the range of A is left out.
  double weightedEnergy(double ridge) const;

  /// The symmetric F (columns x columns) with F F = ridge (A^T A + ridge I)^-1, which is the covariance of the
  /// coefficients under a prior of variance 1 and noise of variance `ridge`. @param ridge >= 0, or infinite.
  Eigen::MatrixXd posteriorFactor(double ridge) const;

 private:
  /// ridge / (s^2 + ridge) per singular value s: the fraction that the samples do not determine.
  Eigen::VectorXd residualFractions(double ridge) const;

  ThinSvd svd_;
  Eigen::MatrixXd projected_;  ///< U^T B
  Eigen::MatrixXd outside_;    ///< B minus its part in the span of U; 0 unless A has more rows than columns
};

/// The ridge with the smallest sum; the largest among those that are equal within a factor of 1 + 1e-9. @param ridges
/// descending. @param otherwise result if there are none.
double bestRidge(const std::vector<double>& ridges, const std::vector<double>& sums, double otherwise);

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
