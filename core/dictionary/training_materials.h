// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/dictionary/signals.h"

namespace gonio::dictionary {

/// The materials that dictionaries learn from: read again for every pass over them, so that memory holds a few at a
/// time.
struct TrainingMaterials {
  std::vector<std::string> names;
  HalfDifferenceGrid grid;
  /// The table of a material, of `grid`. Called from several threads.
  std::function<std::shared_ptr<const TabulatedBrdf>(std::size_t material)> load;
};

/// Which signals a material gives: three channels for each transform.
struct SignalOptions {
  std::vector<DataTransform> transforms{DataTransform::logPlus, DataTransform::cosineLog};

  std::size_t signalsPerMaterial() const { return 3 * transforms.size(); }
};

/// Calls `work(material, signal, values)` for every signal, those of a material in order on one thread, several
/// materials at a time; signals are numbered through: material * signalsPerMaterial() + transform * 3 + channel. Then
/// `finished(material)` on the calling thread, in the order of the materials: sums made there have the same bits for
/// any number of threads.
/// @throws Cancelled; whatever `load` throws.
void forEachSignal(
    const TrainingMaterials& materials, const SignalOptions& options,
    const std::function<void(std::size_t material, std::size_t signal, const Eigen::ArrayXf& values)>& work,
    const std::function<void(std::size_t material)>& finished, const TaskControl& control = {});

}  // namespace gonio::dictionary
