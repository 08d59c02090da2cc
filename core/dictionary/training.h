// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/shared_subspace.h"

namespace gonio::dictionary {

struct TrainingOptions {
  int dictionaries = 8;                           ///< K of each ensemble
  std::vector<int> sparsities{32, 64, 128, 256};  ///< one ensemble each (dissertation 4.3.2.2: 4 ensembles of 8)
  SignalOptions signals;
  int iterations = 12;         ///< rounds at most, for each ensemble
  int passes = 4;              ///< over the dictionaries in each round, with the memberships kept
  double tolerance = 5e-4;     ///< an ensemble is done when a round lowers its error by less than this fraction
  double subspaceLoss = 3e-5;  ///< fraction of the energy that the shared subspace may leave to the last sweep
  bool fullSweep = true;       ///< the last sweep in the whole space
  std::uint64_t seed = 1;
};

/// How far a training is: enough to go on with the same bits.
struct TrainingState {
  SharedSubspace subspace;
  /// In the subspace; one entry for each ensemble that was begun, the last one unfinished or not.
  std::vector<std::vector<ModeMatrices<double>>> ensembles;
  /// Relative squared errors before each round, one list for each ensemble that was begun.
  std::vector<std::vector<double>> errors;
};

struct TrainingResult {
  Ensemble ensemble;
  TrainingState state;
  bool complete = true;              ///< false after a stop: the best so far
  std::vector<double> errorsBefore;  ///< of each ensemble in the whole space, before the last sweep
  std::vector<double> errorsAfter;   ///< and after it
  double seconds = 0;
};

/// Learns the aggregated ensemble. A shared subspace first, then each ensemble in it (EnsembleLearner), then one sweep
/// in the whole space. A stop gives the best so far, with `complete` false.
/// @param resume a state to go on from, of the same materials and options.
/// @param checkpoint called after each round with the state.
/// @throws Cancelled when stopped before there is a dictionary; Error where there are no materials.
/// Memory: the signals in the subspace (822 signals of 137 materials: some 350 MB), and a few tables.
TrainingResult train(const TrainingMaterials& materials, const TrainingOptions& options,
                     const TaskControl& control = {}, const TrainingState* resume = nullptr,
                     const std::function<void(const TrainingState&)>& checkpoint = {});

}  // namespace gonio::dictionary
