// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/training_materials.h"

/// Prior distribution of the coefficients over each dictionary of an ensemble, learned from a training set.
namespace gonio::acquisition {

/// The prior of one dictionary: independent Gaussian coefficients.
struct CoefficientPrior {
  std::vector<std::uint32_t> indices;  ///< of the atoms, ascending, numbered as in ChannelCode
  Eigen::VectorXf means, variances;    ///< of the atoms' coefficients
  double restVariance = 0;  ///< mean square, per cell, of the contribution of the other atoms to a signal with cell
                            ///< scaling (GridGeometry::cellScaling)
};

struct DictionaryPrior {
  HalfDifferenceGrid grid;
  DataTransform transform = DataTransform::logPlus;
  float highest = 0;                           ///< the largest transformed value of the training set
  std::vector<CoefficientPrior> dictionaries;  ///< in the order of the ensemble
};

struct DictionaryPriorOptions {
  DataTransform transform = DataTransform::logPlus;  ///< logPlus or cosineLog
  std::size_t atoms = 4096;  ///< per dictionary: those with the largest mean square of the coefficients
  /// Weight, in (0, 1], of a signal in the priors of all dictionaries other than the one that represents it best, where
  /// its weight is 1. With 1 every dictionary learns from all signals equally.
  double sharing = 0.1;
};

/// Weighted means and variances of the coefficients over the signals of the materials (three channels each). The
/// signals are projected onto a shared subspace that loses at most 1e-4 of their energy, then projected onto each
/// dictionary, using in each mode only as many atoms as needed to lose at most another 1e-4 of the energy in total;
/// restVariance includes both losses. The result does not depend on the number of threads. Two passes over the
/// materials; 0.8 MB of memory per signal; O(materials dictionaries).
/// @throws Error if there is no material, the grids differ or an option is out of range; Cancelled; whatever
/// TrainingMaterials::load throws.
DictionaryPrior learnDictionaryPrior(const dictionary::Ensemble& ensemble,
                                     const dictionary::TrainingMaterials& materials,
                                     const DictionaryPriorOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::acquisition
