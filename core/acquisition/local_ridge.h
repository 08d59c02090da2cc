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
/// / (2 h^2)), 0.005): because of the lower bound every training signal contributes, which helps if the material
/// resembles none of them. Given these weights the coefficients are those of a ridge regression with additional noise
/// of variance s^2 in all samples.
///
/// No single pair of h and s^2 is chosen: the result is the weighted mean of the regressions for several values of h
/// (0.11 to infinity; infinity gives the ridge regression over all signals) and of s^2. The weight of a pair is
/// E^(-m/2), where m is the number of samples and E the squared error when each sample is predicted from the others;
/// the distances are then computed from those others, too. More than 40 samples are left out in 40 groups instead of
/// one by one.
namespace gonio::acquisition {

struct LocalRidge {
  Eigen::MatrixXd coefficients;  ///< of D = U Sigma: components x channels
  /// s^2 of the pair with the largest weight, relative to the variance of a coefficient over the training set, as eta
  /// of the ridge.
  double ridge = 0;
  double leaveOneOutError = 0;  ///< of that pair: root mean square over samples and channels
  /// F with F F^T the covariance of the coefficients given the samples, for that pair, mean of the channels.
  Eigen::MatrixXd posteriorFactor;
  /// The squared differences between the samples and the weighted mean of the training signals, divided by the squared
  /// differences that the covariances of signals and noise predict. 1 if all noise is known.
  double scale = 1;
};

/// @param v coordinates of the training signals: signals x at least as many components as `samples` uses
/// (GramSvd::v). @param uncertainty whether to compute `posteriorFactor`. At least two samples. O(min(m, 40) m^2
/// signals), about a second for 60 samples and 411 signals; same bits for any number of threads. @throws Cancelled.
LocalRidge localRidge(const SampleRows& samples, const Eigen::MatrixXd& v, bool uncertainty,
                      const TaskControl& control = {});

}  // namespace gonio::acquisition
