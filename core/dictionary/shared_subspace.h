// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"

namespace gonio::dictionary {

/// Where nearly all of a set of signals lies: the truncated higher-order SVD of the set (De Lathauwer et al. 2000).
/// Training works in its small block; the other directions wait behind it.
struct SharedSubspace {
  ModeMatrices<double> bases;  ///< square, orthonormal, columns by falling energy
  Sizes ranks{};               ///< leading columns that span the subspace
  double loss = 0;             ///< fraction of the set's energy outside of it

  /// The dictionary of the whole space that is `inner` in the subspace and leaves the rest as it is.
  ModeMatrices<double> lifted(const ModeMatrices<double>& inner) const;
};

/// The smallest ranks whose left-out energy, summed over the modes, is at most `maxLoss` of the set's. One pass.
SharedSubspace findSharedSubspace(const TrainingMaterials& materials, const SignalOptions& options, double maxLoss,
                                  const TaskControl& control = {});

/// The signals in the subspace, one a column, in single precision; sets the subspace's `loss`. One pass.
Matrix<float> projectOnto(SharedSubspace& subspace, const TrainingMaterials& materials, const SignalOptions& options,
                          const TaskControl& control = {});

}  // namespace gonio::dictionary
