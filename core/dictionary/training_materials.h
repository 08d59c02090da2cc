// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/dictionary/mode_products.h"
#include "core/dictionary/signals.h"

namespace gonio::dictionary {

/// The materials of a training set. They are loaded again for every pass, so that only a few are in memory at a time.
struct TrainingMaterials {
  std::vector<std::string> names;
  HalfDifferenceGrid grid;
  /// Returns the table of a material. It must have `grid`, or its wholeCircle() for both orders of the directions.
  /// Called from several threads at once.
  std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)> load;
};

/// The signals of a material: three channels for each transform. A signal has one part, or two over the same grid if
/// the table has both orders of the directions (partsOfOrders()).
struct SignalOptions {
  std::vector<DataTransform> transforms{DataTransform::logPlus, DataTransform::cosineLog};
  /// The transforms in which tables of both orders have signals; in others of `transforms` their signals have no parts.
  /// Near the horizon, the log-plus of measured files is large and rough: it would dominate what is learned, while
  /// their codes almost always are of the cosine-log.
  std::vector<DataTransform> transformsOfBothOrders{DataTransform::cosineLog};
  bool scaled = true;  ///< whether they have cell scaling (GridGeometry::cellScaling); not in the published method

  /// Whether each signal is divided by its norm, so that dark materials count as much as bright ones: otherwise the
  /// energies of measured files in the cosine-log differ by orders of magnitude.
  bool normalised = false;

  std::size_t signalsPerMaterial() const { return 3 * transforms.size(); }
};

/// Calls `work(material, signal, parts)` for every signal (signalsOf()): those of a material in order on one thread,
/// several materials in parallel. The index of a signal is material * signalsPerMaterial() + transform * 3 + channel.
/// Then calls `finished(material)` on the calling thread in the order of the materials, so that sums made there do not
/// depend on the number of threads.
/// @throws Cancelled; whatever `load` throws.
void forEachSignal(
    const TrainingMaterials& materials, const SignalOptions& options,
    const std::function<void(std::size_t material, std::size_t signal, std::span<const Eigen::ArrayXd> parts)>& work,
    const std::function<void(std::size_t material)>& finished, const TaskControl& control = {});

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

/// Calls `work(signal, blocks)` with the projection of each signal onto the subspace: one block of `ranks` for each
/// part, one after another, in the order and on the threads of forEachSignal(). Sets the subspace's `loss`. One pass
/// over the materials.
void forEachProjection(SharedSubspace& subspace, const TrainingMaterials& materials, const SignalOptions& options,
                       const std::function<void(std::size_t signal, std::span<const double> blocks)>& work,
                       const TaskControl& control = {});

}  // namespace gonio::dictionary
