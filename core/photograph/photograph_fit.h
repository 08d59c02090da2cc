// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/photograph/pixel_rows.h"

namespace gonio::photograph {

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What photographs are reconstructed from: principal components at the nodes of a grid on which pixels are integrated.
struct PhotographPrior {
  dictionary::MappedCells mapping;
  Eigen::VectorXf mean;     ///< of the mapped values, one per cell
  Eigen::VectorXf leftOut;  ///< variance of a mapped value in components that are not used, one per cell
  RowMatrix d;              ///< U Sigma: cells x components
  Eigen::VectorXd singularValues;
  Eigen::MatrixXd v;  ///< coefficients of the training signals: signals x components
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

struct FitOptions {
  std::size_t regions = 600;  ///< number of regions of all photographs together
  /// Errors of the model, such as what no combination of training materials can represent, are alike in neighbouring
  /// regions. All regions of a photograph together count as this many independent ones.
  double independentRegions = 25;
  bool checksInput = true;  ///< whether to look for errors of the input (PhotographFit::checks)
};

/// How much better the photographs are explained if one property of the input differs from what was stated.
struct InputCheck {
  std::string property;  ///< "exposure", "gamma", "outline x", "outline y", "outline radius" or "rotation"
  double estimate = 0;   ///< difference from the stated value: of a logarithm (exposure, gamma), in pixels, or in rad
  double deviation = 0;  ///< posterior standard deviation of the estimate
  double evidence = 0;   ///< half the squared ratio of estimate and deviation: the gain of log likelihood
  bool isSuspicious = false;  ///< whether the estimate is significant and large enough to matter
};

struct PhotographFit {
  dictionary::ComponentCode code;  ///< over the components of the basis
  double exposure = 1;             ///< factor of pixel values; 1 if it is known
  double exposureDeviation = 0;    ///< standard deviation of its logarithm; 0 if it is known
  /// Per channel, F with F F^T the covariance of the coefficients (of U Sigma) given the photographs.
  std::array<Eigen::MatrixXd, 3> posteriorFactors;
  double bandwidth = 0;   ///< h of the local ridge; infinite: all training signals have the same weight
  double modelNoise = 0;  ///< relative standard deviation of a pixel value that the model does not explain
  std::vector<Region> regions;
  std::vector<Rgb> predicted;  ///< pixel values of the regions
  /// 10 log10 of the energy of the regions relative to that of their differences from `predicted`, dB, per photograph.
  std::vector<double> residualSnr;
  double lost = 0;  ///< fraction of the light in directions without training data, mean over the regions
  std::vector<InputCheck> checks;
  std::vector<std::string> warnings;  ///< one sentence each, for people
};

/// The most likely material given photographs, and its uncertainty: a Gaussian prior over the coefficients of the
/// principal components, weighted toward training materials that would look like the photographs (as
/// acquisition::localRidge()), and Gauss-Newton iterations for the mapped values, of which a pixel is not a linear
/// function. BRDF values are never negative. About 10 s for 256 x 256 pixels under an environment on two cores.
/// @throws Error as regionsOf() and assembleRows(); Cancelled.
PhotographFit fitPhotographs(const PhotographPrior& prior, const PhotographSet& set, const FitOptions& options = {},
                             const TaskControl& control = {});

/// Standard deviations of the mapped values of all cells of a basis, per channel (acquisition::Reconstruction::
/// standardDeviation). O(cells components^2).
std::vector<glm::vec3> deviations(const dictionary::PrincipalComponents& basis, const PhotographFit& fit,
                                  const TaskControl& control = {});

}  // namespace gonio::photograph
