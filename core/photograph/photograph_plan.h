// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/photograph/photograph_prior.h"

/// Which image to take next.
namespace gonio::photograph {

/// What a plan assumes.
struct PlanOptions {
  int images = 1;  ///< number of images to choose; fewer are chosen if there are fewer candidates
  /// Number of training materials about which pixel values are linearised, evenly spaced in the training set.
  std::size_t materials = 24;
  /// Relative standard deviation of a pixel value that the model does not explain (PhotographFit::modelNoise).
  double modelNoise = 0.08;
  std::size_t regionsPerImage = 60;
};

/// Expected standard deviations of mapped values: the root of the mean variance over the prior's cells, the channels
/// and the training materials of the plan. Components that the prior does not use are not included.
struct ExpectedDeviation {
  double overall = 0;
  std::vector<double> classes;  ///< of the materials of each class; NaN for a class without materials in the plan
};

struct PhotographPlan {
  std::vector<std::size_t> materials;         ///< indices of the training materials about which it is linearised
  ExpectedDeviation before;                   ///< without images: that of the training set
  std::vector<ExpectedDeviation> taken;       ///< after the first image of the set, the first two, ...
  std::vector<ExpectedDeviation> candidates;  ///< after all images of the set and this candidate
  std::vector<std::size_t> chosen;            ///< candidates in the order of choice
  std::vector<ExpectedDeviation> after;       ///< after the images of the set and the first chosen one, two, ...
};

/// Chooses the candidates that reduce the uncertainty most: greedy A-optimal Bayesian design (Chaloner and Verdinelli
/// 1995, "Bayesian Experimental Design: A Review"), as acquisition::chooseAOptimal() for samples. Before the images,
/// the coefficients have the mean and covariance of all training materials (localPrior() with infinite bandwidth).
/// Pixel values are linearised about each of some training materials, as if it were the material that is photographed,
/// with the noise and the division of information of fitPhotographs(). Each step chooses the candidate with the
/// smallest mean, over these materials, of the posterior variances of the mapped values; the first one among equals.
///
/// Seconds for 24 materials and 12 candidates under an environment; memory 140 kB per image and material. The same
/// choice for any number of threads.
/// @param set images that are taken or will be; their pixels are not used. Its exposure counts as unknown if
/// `exposureKnown` is false. @param candidates images without pixels.
/// @param classOf class of each training material, below `classes`. @throws Error if no image is chosen, there is no
/// candidate, or as assembleRows(); Cancelled.
PhotographPlan planPhotographs(const PhotographPrior& prior, const PhotographSet& set,
                               const std::vector<Photograph>& candidates, const std::vector<std::size_t>& classOf,
                               std::size_t classes, const PlanOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::photograph
