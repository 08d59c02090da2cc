// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"

namespace gonio::dictionary {

/// An ensemble of one sparsity over whole tables, with the dictionary of each signal.
struct AssignedEnsemble {
  int sparsity = 0;
  std::vector<ModeMatrices<double>> dictionaries;
  std::vector<int> memberships;
};

/// Relative squared errors of every ensemble over all signals, by the dictionary of each signal. One pass.
std::vector<double> fullErrors(const std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials,
                               const SignalOptions& options, const TaskControl& control = {});

/// One round of training in the whole space with the memberships kept: coefficients by the hard threshold, then each
/// mode in turn by Procrustes. What a shared subspace left out is learned here; no error grows. Three passes over the
/// materials. Returns the errors before it, as fullErrors().
/// @throws Cancelled with the ensembles as they were.
std::vector<double> sweepFullSpace(std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials,
                                   const SignalOptions& options, const TaskControl& control = {});

}  // namespace gonio::dictionary
