// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/dictionary/signals.h"

namespace gonio::dictionary {

/// The materials of a training set. They are loaded again for every pass, so that only a few are in memory at a time.
struct TrainingMaterials {
  std::vector<std::string> names;
  HalfDifferenceGrid grid;
  /// Returns the table of a material, which must have `grid`. Called from several threads at once.
  std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)> load;
};

/// The signals of a material: three channels for each transform.
struct SignalOptions {
  std::vector<DataTransform> transforms{DataTransform::logPlus, DataTransform::cosineLog};
  bool scaled = true;  ///< whether they have cell scaling (GridGeometry::cellScaling); not in the published method

  std::size_t signalsPerMaterial() const { return 3 * transforms.size(); }
};

/// Calls `work(material, signal, values)` for every signal (signalsOf()): those of a material in order on one thread,
/// several materials in parallel. The index of a signal is material * signalsPerMaterial() + transform * 3 + channel.
/// Then calls `finished(material)` on the calling thread in the order of the materials, so that sums made there do not
/// depend on the number of threads.
/// @throws Cancelled; whatever `load` throws.
void forEachSignal(
    const TrainingMaterials& materials, const SignalOptions& options,
    const std::function<void(std::size_t material, std::size_t signal, const Eigen::ArrayXd& values)>& work,
    const std::function<void(std::size_t material)>& finished, const TaskControl& control = {});

}  // namespace gonio::dictionary
