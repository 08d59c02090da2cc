// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// A signal as a small block: its own truncated higher-order SVD (De Lathauwer et al. 2000, "A Multilinear Singular
/// Value Decomposition"). Projections of the block onto dictionaries cost a fraction of those of the signal.
template <typename Scalar>
struct CompactSignal {
  ModeMatrices<Scalar> bases;  ///< one per mode: size of the mode x rank, columns orthonormal
  Sizes ranks{};
  BlockStorage<Scalar> block;  ///< of `ranks`, the first index fastest
  double energy = 0;           ///< sum of squares of the whole signal

  /// The dictionary in the coordinates of the bases: bases^T `dictionary` in each mode. Projecting the block onto it
  /// gives the projection of the signal onto `dictionary`. @param dictionary one matrix per mode, size of the mode x
  /// atoms.
  ModeMatrices<Scalar> inBases(const ModeMatrices<Scalar>& dictionary) const;
  /// The `count` largest coefficients over a dictionary (selectLargestProjections()), without what the block
  /// omits.
  void selectLargest(const ModeMatrices<Scalar>& dictionary, std::size_t count, Workspace<Scalar>& workspace,
                     std::vector<Coefficient<Scalar>>& selected) const;
};

/// @param signal of `sizes`, the first index fastest. @param maxLoss maximum fraction of the signal's energy that
/// the block omits.
template <typename Scalar>
CompactSignal<Scalar> compactSignal(const Scalar* signal, const Sizes& sizes, double maxLoss);

extern template struct CompactSignal<float>;
extern template struct CompactSignal<double>;
extern template CompactSignal<float> compactSignal(const float*, const Sizes&, double);
extern template CompactSignal<double> compactSignal(const double*, const Sizes&, double);

}  // namespace gonio::dictionary
