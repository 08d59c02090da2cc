// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/acquisition/sample_rows.h"
#include "core/math/ridge_regression.h"
#include "core/support/task_control.h"

/// Ridge regression of samples that differ in their noise: sample i has noise of variance v (eta + n_i), where v is the
/// variance of the coefficients. Q is SampleRows::rows, y SampleRows::values.
namespace gonio::acquisition {

class NoisyRidge {
 public:
  /// @param noise n_i >= 0. @param ridge eta. Cost: one RidgeRegression.
  NoisyRidge(const SampleRows& samples, const Eigen::VectorXd& noise, double ridge);

  /// (Q^T N^-1 Q + I)^-1 Q^T N^-1 y, N = diag(eta + n): components x channels.
  Eigen::MatrixXd coefficients() const { return regression_.coefficients(scaledRidge_); }
  /// The symmetric F with F F = (Q^T N^-1 Q + I)^-1, which is the covariance of coefficients of variance 1 given the
  /// samples.
  Eigen::MatrixXd posteriorFactor() const { return regression_.posteriorFactor(scaledRidge_); }
  /// trace(y^T (Q Q^T + N)^-1 y) (RidgeRegression::weightedEnergy).
  double weightedEnergy() const { return regression_.weightedEnergy(scaledRidge_); }
  /// Each sample's values minus their prediction from all other samples: samples x channels. Requires that all eta +
  /// n_i are positive and finite.
  Eigen::MatrixXd leaveOneOut() const;

 private:
  double scaledRidge_;
  Eigen::VectorXd roots_;  ///< factors that scale the equations so that all have noise of variance scaledRidge_
  RidgeRegression regression_;
};

/// The eta for which each sample is predicted best from all others: it minimises the sum over the samples of (squared
/// difference) / (publishedRidge + n_i), so that noisy samples have little influence. Tries
/// RidgeRegression::triedRidges() and takes bestRidge() of them, or publishedRidge if there are none. Parallel; the
/// result does not depend on the number of threads. @throws Cancelled.
double leaveOneOutRidge(const SampleRows& samples, const Eigen::VectorXd& noise, const TaskControl& control = {});

}  // namespace gonio::acquisition
