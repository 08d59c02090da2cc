// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"

namespace gonio::dictionary {

/// A subspace that contains nearly all energy of a set of signals: the truncated higher-order SVD of the set (De
/// Lathauwer et al. 2000, "A Multilinear Singular Value Decomposition"). Training works on the small blocks of
/// projected signals.
struct SharedSubspace {
  ModeMatrices<double> bases;  ///< square, orthonormal; columns by decreasing energy
  Sizes ranks{};               ///< number of leading columns that span the subspace
  double loss = 0;             ///< fraction of the set's energy outside of it

  /// Extends a dictionary of the subspace to the whole space; the other directions remain the columns of `bases`.
  ModeMatrices<double> lifted(const ModeMatrices<double>& inner) const;
};

/// Finds the smallest ranks with which the energy that is left out, summed over the modes, is at most the fraction
/// `maxLoss`. One pass over the materials.
SharedSubspace findSharedSubspace(const TrainingMaterials& materials, const SignalOptions& options, double maxLoss,
                                  const TaskControl& control = {});

/// Calls `work(signal, block)` with the projection of each signal onto the subspace, of `ranks`, in the order and on
/// the threads of forEachSignal(); sets the subspace's `loss`. One pass over the materials.
void forEachProjection(SharedSubspace& subspace, const TrainingMaterials& materials, const SignalOptions& options,
                       const std::function<void(std::size_t signal, std::span<const double> block)>& work,
                       const TaskControl& control = {});

}  // namespace gonio::dictionary
