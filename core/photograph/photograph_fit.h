// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/photograph/photograph_prior.h"

namespace gonio::photograph {

/// Number of regions of all photographs together, by default.
inline constexpr std::size_t defaultRegions = 600;

/// How much better the photographs are explained if one property of the input differs from what was stated.
struct InputCheck {
  /// "exposure", "gamma", "rotation", and of spheres "outline x", "outline y" or "outline radius".
  std::string property;
  double estimate = 0;   ///< difference from the stated value: of a logarithm (exposure, gamma), in pixels, or in rad
  double deviation = 0;  ///< standard deviation of the estimate: that of the posterior, or widening() times it
  double evidence = 0;   ///< half the squared ratio of estimate and deviation: the gain of log likelihood
  double unexplainedSnr = 0;  ///< PhotographFit::unexplainedSnr with the estimated difference, dB
  bool isSuspicious = false;  ///< whether the estimate is significant, large enough to matter, and explains the pixels
};

struct PhotographFit {
  dictionary::ComponentCode code;  ///< over the components of the basis
  double exposure = 1;             ///< factor of pixel values; 1 if it is known
  double exposureDeviation = 0;    ///< standard deviation of its logarithm; 0 if it is known
  /// Per channel, F with F F^T the covariance of the coefficients (of U Sigma) given the photographs.
  std::array<Eigen::MatrixXd, 3> posteriorFactors;
  double bandwidth = 0;   ///< h of the local ridge; infinite: all training signals have the same weight
  double modelNoise = 0;  ///< relative standard deviation of a pixel value that the model does not explain
  /// 10 log10 of the energy of all regions relative to that of their differences from `predicted` beyond noise, dB.
  double unexplainedSnr = 0;
  /// Factor of the posterior standard deviations that `posteriorFactors` and deviations() include,
  /// widening().
  double widening = 1;
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
/// function. BRDF values are never negative. An unknown exposure is the one of the largest evidence. About 10 s for
/// 256 x 256 pixels under an environment on two cores.
/// @throws Error as regionsOf() and assembleRows(); Cancelled.
PhotographFit fitPhotographs(const PhotographPrior& prior, const PhotographSet& set,
                             std::size_t maxRegions = defaultRegions, const TaskControl& control = {});

/// Standard deviations of the mapped values of all cells of a basis, per channel (acquisition::Reconstruction::
/// standardDeviation). O(cells components^2).
std::vector<glm::vec3> deviations(const dictionary::PrincipalComponents& basis, const PhotographFit& fit,
                                  const TaskControl& control = {});

}  // namespace gonio::photograph
