// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/acquisition/measured_values.h"
#include "core/dictionary/dictionary.h"
#include "core/dictionary/training_materials.h"

namespace gonio::acquisition {

// Prior distribution of the coefficients over each dictionary of an ensemble, learned from a training set.

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

// Reconstruction of a whole material from a few measured values in an ensemble of multi-dimensional dictionaries.
// Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", mentions it as future
// work.

/// The criterion by which the dictionary is chosen.
enum class DictionaryChoice {
  evidence,    ///< largest likelihood of the samples under the prior, at its most likely scale
  leaveOneOut  ///< smallest squared error when each sample is predicted from the others
};

struct DictionaryReconstructionOptions {
  DictionaryChoice choice = DictionaryChoice::evidence;
  double noise = 0;  ///< variance of the noise of a sample's scaled value, relative to CoefficientPrior::restVariance;
                     ///< 0: determined by `choice`, as the dictionary is
};

struct DictionaryReconstruction {
  std::shared_ptr<const TabulatedBrdf> table;
  dictionary::SparseCode code;  ///< the posterior means of the coefficients of the prior
  int dictionary = 0;           ///< index of the chosen one, the same for all channels
  double noise = 0;             ///< variance, relative to restVariance
  double logEvidence = 0;       ///< up to a constant
  double leaveOneOutError = 0;  ///< root mean square, in scaled transformed values
};

/// Gaussian process regression with a kernel that consists of the atoms. A scaled signal is z(x) = sum_k c_k a_k(x),
/// with independent c_k of mean mu_k and variance v sigma_k^2; a sample measures z with noise of variance v n, n =
/// DictionaryReconstruction::noise times restVariance. With A the atoms at the samples' nodes, the posterior mean is
///
///     c = mu + S A^T (A S A^T + n I)^-1 (z - A mu),   S = diag(sigma_k^2),
///
/// computed for the three channels by one decomposition of a samples x samples matrix per dictionary. The common scale
/// v does not affect c; the evidence uses its most likely value. Where the standard deviations of the values are
/// known, n of a sample is `noise` times (restVariance + s^2), with s the standard deviation of its scaled transformed
/// value (root mean square of the channels). Among equally good dictionaries the first is chosen. Atoms are evaluated
/// at the samples only: O(dictionaries samples^2 atoms), then decode().
/// @throws Error as reconstruct(), and if the prior belongs to another ensemble.
DictionaryReconstruction reconstructInDictionaries(const dictionary::Ensemble& ensemble, const DictionaryPrior& prior,
                                                   const SamplingPlan& plan, const MeasuredValues& values,
                                                   const DictionaryReconstructionOptions& options = {},
                                                   const TaskControl& control = {});

}  // namespace gonio::acquisition
