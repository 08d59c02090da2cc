// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/acquisition/dictionary_prior.h"
#include "core/acquisition/measured_values.h"
#include "core/dictionary/sparse_code.h"

/// A whole material from a few measurements in an ensemble of multi-dimensional dictionaries (the dissertation's
/// future work).
namespace gonio::acquisition {

/// By what the dictionary is chosen.
enum class DictionaryChoice {
  evidence,    ///< the likelihood of the samples under the prior, its scale the most likely one
  leaveOneOut  ///< the squared error with which the samples are predicted from one another
};
/// In JSON and on the command line, in the order of the enumeration.

struct DictionaryReconstructionOptions {
  DictionaryChoice choice = DictionaryChoice::evidence;
  double noise = 0;  ///< variance of the noise of a scaled sample over the prior's restVariance; 0: chosen too
};

struct DictionaryReconstruction {
  std::shared_ptr<const TabulatedBrdf> table;
  dictionary::SparseCode code;  ///< the posterior means of the coefficients of the prior
  int dictionary = 0;           ///< that was chosen, for all channels
  double noise = 0;             ///< over restVariance
  double logEvidence = 0;       ///< but for a constant
  double leaveOneOutError = 0;  ///< root mean square, of scaled transformed values
};

/// A Gaussian process whose kernel the atoms make: a scaled signal is z(x) = sum_k c_k a_k(x), c_k independent of mean
/// mu_k and variance v sigma_k^2; a sample reads it with a noise of variance v n. With A the atoms at the samples'
/// nodes, the posterior mean is
///
///     c = mu + S A^T (A S A^T + n I)^-1 (z - A mu),   S = diag(sigma_k^2),
///
/// of the three channels by one decomposition of a matrix of samples x samples a dictionary. v, their common scale,
/// does not change c; for the evidence it is the most likely one. Where standard deviations of the values are given a
/// sample counts as in reconstruct(), beside a noise of restVariance. Of equals the first dictionary. Atoms are
/// evaluated at the samples alone: O(dictionaries samples^2 atoms), then decode().
/// @throws Error as reconstruct(), and when prior and ensemble do not belong together.
DictionaryReconstruction reconstructInDictionaries(const dictionary::Ensemble& ensemble, const DictionaryPrior& prior,
                                                   const SamplingPlan& plan, const MeasuredValues& values,
                                                   const DictionaryReconstructionOptions& options = {},
                                                   const TaskControl& control = {});

}  // namespace gonio::acquisition
