// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/math/decompositions.h"

namespace gonio {

/// Ridge regression (Hoerl and Kennard 1970): the coefficients c that make |A c - b|^2 + ridge |c|^2 small, for the
/// columns of B at once. One singular value decomposition of A serves every ridge; A^T A is never formed, so its
/// condition number is not squared. A may have fewer rows than columns. Singular values of 1e-8 of the largest and less
/// count as 0.
class RidgeRegression {
 public:
  /// @param rows A, rows x columns; @param values B, rows x right-hand sides. Cost: O(rows columns min(rows, columns)).
  RidgeRegression(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& values);

  Eigen::Index rowCount() const { return svd_.u.rows(); }

  /// (A^T A + ridge I)^-1 A^T B: columns x right-hand sides. With ridge 0 the solution of least norm; with an infinite
  /// one 0. @param ridge >= 0.
  Eigen::MatrixXd coefficients(double ridge) const;

  /// B less what the coefficients of all other rows predict for each, in closed form: the i-th row of H B over H_ii,
  /// H = (A A^T + ridge I)^-1. @param ridge > 0, finite.
  Eigen::MatrixXd leaveOneOut(double ridge) const;

  /// Ten a decade from 1e3 down to 1e-7 of the largest squared singular value. None where the values carry no
  /// information on them: where A is 0 or has one row, which no other predicts.
  std::vector<double> triedRidges() const;

  /// bestRidge() of triedRidges() by the sums of squares of leaveOneOut().
  double leaveOneOutRidge(double otherwise) const;

  /// trace(B^T (A A^T + ridge I)^-1 B). Over the number of values it is the most likely variance of the coefficients,
  /// ridge times it that of the noise of B, where both are Gaussian. @param ridge >= 0; with 0, what the rows of A do
  /// not reach is left out.
  double weightedEnergy(double ridge) const;

  /// F, columns x columns, symmetric, of ridge (A^T A + ridge I)^-1 = F F: the covariance of the coefficients under a
  /// prior of variance 1 and noise of variance `ridge`. @param ridge >= 0, or infinite.
  Eigen::MatrixXd posteriorFactor(double ridge) const;

 private:
  /// ridge / (s^2 + ridge) of each singular value: the fraction that a sample does not determine.
  Eigen::VectorXd residualFractions(double ridge) const;

  ThinSvd svd_;
  Eigen::MatrixXd projected_;  ///< U^T B
  Eigen::MatrixXd outside_;    ///< B less its part in the span of U: 0 unless A has more rows than columns
};

/// The ridge of the least sum; of those that are equal to a fraction of 1e-9 the larger. `otherwise` of none.
/// @param ridges descending.
double bestRidge(const std::vector<double>& ridges, const std::vector<double>& sums, double otherwise);

}  // namespace gonio
