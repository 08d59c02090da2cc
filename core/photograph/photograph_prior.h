// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/photograph/pixel_rows.h"

namespace gonio::photograph {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Red, green and blue.
inline constexpr Eigen::Index channelCount = 3;

/// What photographs are reconstructed from: principal components at the nodes of a grid on which pixels are integrated.
struct PhotographPrior {
  dictionary::MappedCells mapping;
  Eigen::VectorXf mean;  ///< of the mapped values, one per cell
  RowMatrix d;           ///< U Sigma: cells x components
  Eigen::VectorXd singularValues;
  Eigen::MatrixXd v;  ///< coefficients of the training signals: signals x components

  std::size_t trainingCount() const { return std::size_t(v.rows() / channelCount); }
  /// Components x channels.
  Eigen::MatrixX3d trainingCoefficients(std::size_t material) const {
    return v.middleRows(channelCount * Eigen::Index(material), channelCount).transpose();
  }
};

/// Number of components in use by default.
inline constexpr int defaultPhotographComponents = 64;

/// The first `components` of a basis, at every node in theta_h and about 30 x 36 nodes in theta_d and phi_d. A pixel
/// integrates over much larger angles. @throws Error if the basis is not that of a reciprocal grid.
PhotographPrior photographPrior(const dictionary::PrincipalComponents& basis,
                                int components = defaultPhotographComponents);

/// BRDF values of the prior's cells for coefficients (components x 3 channels), and, if `slopes` is given, their
/// derivatives by the mapped value.
std::vector<glm::vec3> cellValues(const PhotographPrior& prior, const Eigen::MatrixX3d& coefficients,
                                  std::vector<glm::vec3>* slopes = nullptr);

/// Logarithms of the pixel values of the training signals, for the light of each channel: [channel](row, signal).
std::array<Eigen::MatrixXd, 3> signalImages(const PhotographPrior& prior, const PixelRows& rows,
                                            const TaskControl& control = {});

/// Distances of the training signals from the photographs, per channel, as in acquisition/local_ridge.h but of the
/// logarithms of pixel values: signals x channels.
Eigen::MatrixX3d signalDistances(const std::array<Eigen::MatrixXd, 3>& images, const Eigen::MatrixX3d& values,
                                 const Eigen::MatrixX3d& variances);

/// All unknowns x: the coefficients of red, green and blue, then the logarithm of the exposure if it is unknown.
/// Before the photographs are seen, x is mean + G w, with independent standard normal w.
struct LocalPrior {
  Eigen::VectorXd mean;
  Eigen::MatrixXd factor;  ///< G
};

/// Mean and covariance over the training materials, in each order of their channels, weighted toward those that look
/// like the photographs. @param distances signals x channels.
LocalPrior localPrior(const Eigen::MatrixXd& v, const Eigen::MatrixX3d& distances, double bandwidth,
                      bool exposureKnown);

}  // namespace gonio::photograph
