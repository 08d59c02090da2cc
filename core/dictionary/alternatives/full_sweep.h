// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"

namespace gonio::dictionary {

/// The dictionaries of one sparsity over whole tables, and the index of each signal's dictionary.
struct AssignedEnsemble {
  int sparsity = 0;
  std::vector<ModeMatrices<double>> dictionaries;
  std::vector<int> memberships;
};

/// Relative squared error of every ensemble over all signals, each with its own dictionary. One pass over the
/// materials.
std::vector<double> fullErrors(const std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials,
                               const SignalOptions& options, const TaskControl& control = {});

/// One round of training in the whole space with fixed memberships, to learn what the shared subspace left out: the
/// largest coefficients, then each mode by orthogonal Procrustes. No error increases. Three passes over the materials.
/// Returns fullErrors() before the round. @throws Cancelled; the ensembles are then unchanged.
std::vector<double> sweepFullSpace(std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials,
                                   const SignalOptions& options, const TaskControl& control = {});

}  // namespace gonio::dictionary
