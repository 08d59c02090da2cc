// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training_materials.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/mode_products.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

/// The bases' leading columns.
ModeMatrices<double> leadingColumns(const SharedSubspace& subspace) {
  ModeMatrices<double> leading;
  for (std::size_t mode = 0; mode < 3; ++mode) leading[mode] = subspace.bases[mode].leftCols(subspace.ranks[mode]);
  return leading;
}

bool contains(const std::vector<DataTransform>& transforms, DataTransform transform) {
  return std::ranges::find(transforms, transform) != transforms.end();
}

}  // namespace

ModeMatrices<double> SharedSubspace::lifted(const ModeMatrices<double>& inner) const {
  ModeMatrices<double> full = bases;
  for (std::size_t mode = 0; mode < 3; ++mode)
    full[mode].leftCols(ranks[mode]) = bases[mode].leftCols(ranks[mode]) * inner[mode];
  return full;
}

SharedSubspace findSharedSubspace(const TrainingMaterials& materials, const SignalOptions& options, double maxLoss,
                                  const TaskControl& control) {
  const Sizes sizes = modeSizes(materials.grid);
  const auto zeros = [&] {
    ModeMatrices<double> z;
    for (std::size_t mode = 0; mode < 3; ++mode) z[mode] = Eigen::MatrixXd::Zero(sizes[mode], sizes[mode]);
    return z;
  };
  ModeMatrices<double> total = zeros();
  std::vector<ModeMatrices<double>> grams(materials.names.size());
  forEachSignal(
      materials, options,
      [&](std::size_t material, std::size_t, std::span<const Eigen::ArrayXd> parts) {
        if (grams[material][0].size() == 0) grams[material] = zeros();
        for (const Eigen::ArrayXd& values : parts)
          for (int mode = 0; mode < 3; ++mode) addGram(values.data(), sizes, mode, grams[material][std::size_t(mode)]);
      },
      [&](std::size_t material) {
        for (std::size_t mode = 0; mode < 3; ++mode) total[mode] += grams[material][mode];
        grams[material] = {};
      },
      control);
  SharedSubspace subspace;
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const EigenBasis basis = eigenBasis(total[mode]);
    subspace.bases[mode] = basis.vectors;
    subspace.ranks[mode] = rankFor(basis.values, maxLoss / 3);
  }
  return subspace;
}

void forEachProjection(SharedSubspace& subspace, const TrainingMaterials& materials, const SignalOptions& options,
                       const std::function<void(std::size_t signal, std::span<const double> blocks)>& work,
                       const TaskControl& control) {
  const Sizes sizes = modeSizes(materials.grid);
  const ModeMatrices<double> bases = leadingColumns(subspace);
  // The mode that shrinks most goes first.
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return double(subspace.ranks[std::size_t(a)]) / sizes[std::size_t(a)] <
           double(subspace.ranks[std::size_t(b)]) / sizes[std::size_t(b)];
  });
  const std::size_t signals = materials.names.size() * options.signalsPerMaterial();
  std::vector<double> energies(signals), projected(signals);
  forEachSignal(
      materials, options,
      [&](std::size_t, std::size_t signal, std::span<const Eigen::ArrayXd> parts) {
        thread_local Workspace<double> workspace;
        thread_local std::vector<double> blocks;
        blocks.clear();
        const std::size_t size = count(subspace.ranks);
        for (const Eigen::ArrayXd& values : parts) {
          energies[signal] += values.square().sum();
          const double* block = transposedModeProducts(values.data(), sizes, bases, workspace, -1, order);
          projected[signal] += Eigen::Map<const Eigen::VectorXd>(block, Eigen::Index(size)).squaredNorm();
          blocks.insert(blocks.end(), block, block + size);
        }
        work(signal, blocks);
      },
      [](std::size_t) {}, control);
  const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
  const double kept = std::accumulate(projected.begin(), projected.end(), 0.0);
  subspace.loss = total > 0 ? std::max(0.0, 1 - kept / total) : 0;
}

void forEachSignal(
    const TrainingMaterials& materials, const SignalOptions& options,
    const std::function<void(std::size_t material, std::size_t signal, std::span<const Eigen::ArrayXd> parts)>& work,
    const std::function<void(std::size_t material)>& finished, const TaskControl& control) {
  constexpr std::size_t atATime = 8;  // bounds what waits for finished()
  const std::size_t total = materials.names.size();
  for (std::size_t begin = 0; begin < total; begin += atATime) {
    const std::size_t end = std::min(begin + atATime, total);
    parallelForBlocks(end - begin, 1,
                      [&](std::size_t offset, std::size_t) {
                        const std::size_t material = begin + offset;
                        const auto table = materials.load(material);
                        const HalfDifferenceGrid& grid = table->grid();
                        const bool hasBothOrders = grid != materials.grid;
                        assert(!hasBothOrders || grid == materials.grid.wholeCircle());
                        const auto geometry = GridGeometry::of(grid);
                        std::size_t signal = material * options.signalsPerMaterial();
                        for (const DataTransform transform : options.transforms) {
                          if (hasBothOrders && !contains(options.transformsOfBothOrders, transform)) {
                            for (int c = 0; c < 3; ++c) work(material, signal++, {});
                            continue;
                          }
                          auto signals = signalsOf(*table, transform, *geometry, options.scaled);
                          for (Eigen::ArrayXd& values : signals) {
                            const double energy = values.square().sum() / (hasBothOrders ? 2 : 1);
                            if (options.normalised && energy > 0) values /= std::sqrt(energy);
                            if (hasBothOrders)
                              work(material, signal++, partsOfOrders(values, grid.phiDCount));
                            else
                              work(material, signal++, {&values, 1});
                          }
                        }
                      },
                      {.stop = control.stop});
    for (std::size_t material = begin; material < end; ++material) finished(material);
    control.report(double(end) / double(total));
  }
}

}  // namespace gonio::dictionary
