// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/training_materials.h"

/// What a training set says about the coefficients over each dictionary of an ensemble.
namespace gonio::acquisition {

/// Of one dictionary: coefficients taken as independent and Gaussian.
struct CoefficientPrior {
  std::vector<std::uint32_t> indices;  ///< of the atoms, rising, as those of a ChannelCode
  Eigen::VectorXf means, variances;    ///< of their coefficients
  double restVariance = 0;             ///< mean square of what the other atoms add to a cell of a scaled signal
};

struct DictionaryPrior {
  HalfDifferenceGrid grid;
  DataTransform transform = DataTransform::logPlus;
  float highest = 0;                           ///< the largest transformed value of the training set
  std::vector<CoefficientPrior> dictionaries;  ///< in the order of the ensemble
};

struct DictionaryPriorOptions {
  DataTransform transform = DataTransform::logPlus;  ///< logPlus or cosineLog
  std::size_t atoms = 4096;                          ///< of each dictionary, those of largest mean square
  /// What a signal that another dictionary keeps better counts beside one that this one keeps best, (0, 1]. With 1
  /// every dictionary learns from all signals alike.
  double sharing = 0.1;
};

/// Means and variances over the signals of the materials (three channels each). The signals are analysed in the
/// subspace that they share but for 1e-4 of their energy, and there by the atoms of each mode that hold all but as
/// much; restVariance counts what is left out. Same result for any number of threads. Two passes over the materials,
/// 0.8 MB a signal; O(materials dictionaries).
/// @throws Error when there is no material, a grid or an option does not fit; Cancelled; whatever `load` throws.
DictionaryPrior learnDictionaryPrior(const dictionary::Ensemble& ensemble,
                                     const dictionary::TrainingMaterials& materials,
                                     const DictionaryPriorOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::acquisition
