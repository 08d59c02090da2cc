// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/shared_subspace.h"

namespace gonio::dictionary {

struct TrainingOptions {
  int dictionaries = 8;  ///< K of each ensemble
  /// One ensemble each (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition",
  /// section 4.3.2.2: 4 ensembles of 8).
  std::vector<int> sparsities{32, 64, 128, 256};
  SignalOptions signals;
  int iterations = 24;         ///< maximum number of rounds per ensemble
  int passes = 4;              ///< per round, with fixed memberships (EnsembleLearner)
  double tolerance = 5e-4;     ///< an ensemble is finished when a round lowers its error by less than this fraction
  double subspaceLoss = 3e-5;  ///< fraction of the energy that the shared subspace may leave out
  bool fullSweep = true;       ///< whether a last sweep in the whole space follows
  std::uint64_t seed = 1;
};

/// State of an unfinished training, from which it continues with bitwise equal results.
struct TrainingState {
  SharedSubspace subspace;
  /// Dictionaries in the subspace, one entry per ensemble that was started; the last one may be unfinished.
  std::vector<std::vector<ModeMatrices<double>>> ensembles;
  /// Relative squared errors before each round, one list per ensemble that was started.
  std::vector<std::vector<double>> errors;
};

struct TrainingResult {
  Ensemble ensemble;
  TrainingState state;
  bool complete = true;              ///< false if the training was stopped
  std::vector<double> errorsBefore;  ///< relative squared error of the dictionaries of each sparsity in the whole
                                     ///< space, before the last sweep
  std::vector<double> errorsAfter;   ///< the same after it
  double seconds = 0;
};

/// Learns the dictionaries of all sparsities: finds a shared subspace, learns each ensemble in it (EnsembleLearner),
/// then makes one sweep in the whole space. If it is stopped, returns the dictionaries so far, with `complete` false.
/// @param resume state to continue from, of the same materials and options.
/// @param checkpoint called after each round with the state.
/// @throws Cancelled if stopped before there is a dictionary; Error if there are no materials.
/// Memory: the signals as small blocks (822 signals of 137 materials: about 0.3 GB), and a few tables.
TrainingResult train(const TrainingMaterials& materials, const TrainingOptions& options,
                     const TaskControl& control = {}, const TrainingState* resume = nullptr,
                     const std::function<void(const TrainingState&)>& checkpoint = {});

}  // namespace gonio::dictionary
