// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training_materials.h"

#include "core/math/parallel.h"

namespace gonio::dictionary {

void forEachSignal(
    const TrainingMaterials& materials, const SignalOptions& options,
    const std::function<void(std::size_t material, std::size_t signal, const Eigen::ArrayXd& values)>& work,
    const std::function<void(std::size_t material)>& finished, const TaskControl& control) {
  constexpr std::size_t atATime = 8;  // bounds what waits for finished()
  const auto geometry = GridGeometry::of(materials.grid);
  const std::size_t total = materials.names.size();
  for (std::size_t begin = 0; begin < total; begin += atATime) {
    const std::size_t end = std::min(begin + atATime, total);
    parallelForBlocks(end - begin, 1,
                      [&](std::size_t offset, std::size_t) {
                        const std::size_t material = begin + offset;
                        const auto table = materials.load(material);
                        std::size_t signal = material * options.signalsPerMaterial();
                        for (const DataTransform transform : options.transforms) {
                          const auto signals = signalsOf(*table, transform, *geometry, options.scaled);
                          for (int c = 0; c < 3; ++c) work(material, signal++, signals[std::size_t(c)]);
                        }
                      },
                      {.stop = control.stop});
    for (std::size_t material = begin; material < end; ++material) finished(material);
    control.report(double(end) / double(total));
  }
}

}  // namespace gonio::dictionary
