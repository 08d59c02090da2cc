// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "core/photograph/photograph_prior.h"

/// Pixel values as functions of the coefficients, and how accurate they are: what fit and plan share.
namespace gonio::photograph {

/// Pixel values and their derivatives at given coefficients.
struct PixelLinearisation {
  Eigen::MatrixX3d values;                  ///< rows x channels
  std::array<Eigen::MatrixXd, 3> jacobian;  ///< by the coefficients: rows x components
};

/// @param coefficients components x channels. O(entries of the rows x components). Reports no progress.
/// @throws Cancelled.
PixelLinearisation linearised(const PhotographPrior& prior, const PixelRows& rows, const Eigen::MatrixX3d& coefficients,
                              const TaskControl& control = {});

/// The values alone: rows x channels.
Eigen::MatrixX3d pixelValues(const PhotographPrior& prior, const PixelRows& rows, const Eigen::MatrixX3d& coefficients);

/// At most `most` indices below `count`, evenly spaced.
std::vector<std::size_t> evenlySpaced(std::size_t count, std::size_t most);

/// Factor of the information of each row. Errors of the model, such as what no combination of training materials can
/// represent, are alike in neighbouring regions: all regions of a photograph together count as 25 independent ones, of
/// a flat sample, which shows one normal, as one.
double sharedInformation(std::span<const Photograph> photographs, std::size_t rows);

/// Inverse variances of pixel values, times `share`: of their noise, and of what the model does not explain.
/// @param values pixel values. @param noise variances of their noise. Both rows x channels.
/// @param modelNoise standard deviation of the latter, relative to the value (and 5 % of the mean of its channel).
Eigen::MatrixX3d pixelWeights(const Eigen::MatrixX3d& values, const Eigen::MatrixX3d& noise, double modelNoise,
                              double share);

}  // namespace gonio::photograph
