// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

#include "core/acquisition/sample_rows.h"
#include "core/support/task_control.h"

/// Locally weighted ridge regression (Atkeson, Moore and Schaal 1997, "Locally Weighted Learning"): the coefficients of
/// a channel have the mean and the covariance of the training signals that resemble the samples, instead of those of
/// all signals. Materials are far from normally distributed, so few similar ones predict the rest of a material better.
///
/// The distance of a training signal is the mean square, over the samples, of its difference from the readings, divided
/// by the variance of the training signals (and of known noise). Its weight is max(exp(-(distance - smallest distance)
/// / (2 h^2)), 0.005): the lower bound keeps a part of the whole training set for materials that resemble none. Given
/// these weights the coefficients are those of a ridge regression with noise of variance s^2 in all samples.
///
/// h and s^2 are not chosen: the result is the mean over their values (h from 0.11 to infinity, which is the ridge
/// regression over all signals), each with the weight E^(-m/2), where E is the squared error of the prediction of
/// samples from the others (of which also the distances are computed), and m the number of samples. With more than 40
/// samples they are left out in 40 groups.
namespace gonio::acquisition {

struct LocalRidge {
  Eigen::MatrixXd coefficients;  ///< of D = U Sigma: components x channels
  /// s^2 of the combination with the largest weight, relative to the variance of a coefficient over the training set,
  /// as eta of the ridge.
  double ridge = 0;
  double leaveOneOutError = 0;  ///< of that combination: root mean square over samples and channels
  /// F with F F^T the covariance of the coefficients given the samples, in that combination, mean of the channels.
  Eigen::MatrixXd posteriorFactor;
  /// Ratio of the squared differences that were found to those that this covariance predicts; 1 if all noise is known.
  double scale = 1;
};

/// @param v coordinates of the training signals: signals x at least as many components as `samples` uses
/// (GramSvd::v). @param uncertainty whether to compute `posteriorFactor`. At least two samples. O(min(m, 40) m^2
/// signals), about a second for 60 samples and 411 signals; same bits for any number of threads. @throws Cancelled.
LocalRidge localRidge(const SampleRows& samples, const Eigen::MatrixXd& v, bool uncertainty,
                      const TaskControl& control = {});

}  // namespace gonio::acquisition
