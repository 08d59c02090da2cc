// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/photograph/pixel_model.h"

/// The most likely coefficients given pixel values, their covariance, and the evidence of an exposure: what
/// fitPhotographs() is made of.
namespace gonio::photograph {

/// Pixel values with their noise, and the prior and the rows that explain them. The unknowns x are the coefficients of
/// red, green and blue, one channel after another. The prior and the rows must outlive it.
struct PixelProblem {
  const PhotographPrior& prior;
  const PixelRows& rows;
  Eigen::MatrixX3d data, noise;  ///< pixel values and the variances of their noise: rows x channels
  double share = 1;              ///< factor of the information of each row, sharedInformation()

  Eigen::Index components() const { return prior.d.cols(); }
  /// Components x channels.
  Eigen::MatrixX3d coefficients(const Eigen::VectorXd& x) const {
    return Eigen::Map<const Eigen::MatrixX3d>(x.data(), components(), channelCount);
  }
  Eigen::MatrixX3d weights(double modelNoise) const { return pixelWeights(data, noise, modelNoise, share); }
  /// The same photographs divided by an exposure.
  PixelProblem dividedBy(double exposure) const;
};

/// The energy of pixel values relative to that of differences beyond noise, which is at least a tenth of them; dB.
/// @param noise variances. All rows x channels.
double unexplainedSnr(const Eigen::MatrixX3d& values, const Eigen::MatrixX3d& noise,
                      const Eigen::MatrixX3d& differences);

/// How many times larger than the posterior standard deviations the errors of mapped values are, in the median over
/// training materials that were left out of the prior. A material that the components cannot represent in the pixels
/// differs from them in other directions, too. More images reduce the posterior deviations more than the errors, as
/// what the components cannot represent is alike in all.
/// @param unexplainedSnr of the photographs against the reconstruction, dB. @param images number of photographs.
double widening(double unexplainedSnr, std::size_t images);

/// Some of the rows.
PixelRows rowsAt(const PixelRows& rows, const std::vector<std::size_t>& chosen);

/// What is known of the training signals in the photographs, for the weights of the prior.
struct ComparedSignals {
  std::vector<std::size_t> rows;          ///< of the problem
  std::array<Eigen::MatrixXd, 3> images;  ///< signalImages() of them
};

/// In at most `most` rows of the problem. @throws Cancelled.
ComparedSignals comparedSignals(const PixelProblem& problem, std::size_t most, const TaskControl& control = {});

/// The most likely material.
struct MostLikely {
  LocalPrior prior;      ///< of the bandwidth
  double bandwidth = 0;  ///< of the weights of the training materials; infinite: all have the same weight
  double modelNoise = 0;
  Eigen::VectorXd x;
  PixelLinearisation at;  ///< at x
  double evidence = 0;    ///< logarithm of the probability of the pixel values, up to a constant
};

/// By Gauss-Newton steps, with the bandwidth and the noise of the largest evidence of the linearised problem.
/// About a second for 600 rows and 64 components on two cores. @throws Cancelled.
MostLikely mostLikely(const PixelProblem& problem, const ComparedSignals& compared, const TaskControl& control = {});

/// Of x = mean + G w, about a linearisation at x: the inverse of the covariance of w given the pixel values.
/// @param weights PixelProblem::weights().
Eigen::LLT<Eigen::MatrixXd> inverseCovariance(const PixelProblem& problem, const PixelLinearisation& at,
                                              const Eigen::VectorXd& x, const Eigen::MatrixX3d& weights,
                                              const LocalPrior& prior);

/// The evidence of a common factor of all pixel values.
struct ExposureEvidence {
  double logarithm = 0;       ///< of the exposure of the largest evidence
  double deviation = 0;       ///< standard deviation of the logarithm
  Eigen::VectorXd slope;      ///< derivative of the most likely x by the logarithm
  double unexplainedSnr = 0;  ///< unexplainedSnr() at the largest evidence of those tried, dB
  MostLikely atStart;         ///< with the first exposure that was tried: 1 if it is stated
};

/// In steps of factors of 2 up the evidence, then by a parabola; about five solutions of mostLikely(). (The most likely
/// exposure and material together would be too dark a material, since dark materials differ little in the mapped
/// values.) @param isStated starts at 1, else at the mean ratio to the training signals. @param images their number.
/// @throws Cancelled.
ExposureEvidence exposureEvidence(const PixelProblem& problem, const ComparedSignals& compared, bool isStated,
                                  std::size_t images, const TaskControl& control = {});

}  // namespace gonio::photograph
