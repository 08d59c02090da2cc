// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/acquisition/sample_rows.h"
#include "core/math/ridge_regression.h"
#include "core/support/task_control.h"

/// Ridge regression of samples that differ in their noise: sample i has a noise of variance v (eta + n_i), where the
/// coefficients have the variance v.
namespace gonio::acquisition {

class NoisyRidge {
 public:
  /// @param noise n_i >= 0. Cost: one RidgeRegression.
  NoisyRidge(const SampleRows& samples, const Eigen::VectorXd& noise, double ridge);

  /// (Q^T N^-1 Q + I)^-1 Q^T N^-1 y, N = diag(eta + n): components x channels.
  Eigen::MatrixXd coefficients() const { return regression_.coefficients(scaledRidge_); }
  /// F, symmetric, of (Q^T N^-1 Q + I)^-1 = F F: the covariance of coefficients of variance 1 given the samples.
  Eigen::MatrixXd posteriorFactor() const { return regression_.posteriorFactor(scaledRidge_); }
  /// trace(y^T (Q Q^T + N)^-1 y) (RidgeRegression::weightedEnergy).
  double weightedEnergy() const { return regression_.weightedEnergy(scaledRidge_); }
  /// Each sample's values less what all others predict for them: samples x channels. All variances eta + n_i > 0 and
  /// finite.
  Eigen::MatrixXd leaveOneOut() const;

 private:
  double scaledRidge_;
  Eigen::VectorXd roots_;  ///< what the equations are multiplied by, so that all have a noise of variance scaledRidge_
  RidgeRegression regression_;
};

/// The eta by which the samples are best predicted from all others: the least sum of their squared differences over
/// (publishedRidge + n_i), so that noisy samples do not decide. Tried are RidgeRegression::triedRidges(), of which
/// bestRidge() is taken; the published one where there are none. In parallel; the same for any number of threads.
/// @throws Cancelled.
double leaveOneOutRidge(const SampleRows& samples, const Eigen::VectorXd& noise, const TaskControl& control = {});

}  // namespace gonio::acquisition
