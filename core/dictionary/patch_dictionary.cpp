// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/patch_dictionary.h"

#include <algorithm>
#include <random>

#include "core/dictionary/patch_code.h"
#include "core/dictionary/quantised_code.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

using Eigen::Index;

constexpr DataTransform patchTransform = DataTransform::logPlus;
constexpr int maxPerPatch = 32;

void checkGrid(const PatchDictionary& dictionary, const HalfDifferenceGrid& grid) {
  if (grid != dictionary.grid) throw Error("the table and the dictionary of patches have different grids");
}

Eigen::MatrixXd decodedPatches(const PatchDictionary& dictionary, const ChannelCode& channel) {
  const AtomSet& atoms = dictionary.atoms;
  Eigen::MatrixXd patches = Eigen::MatrixXd::Zero(atoms.length(), Index(dictionary.grid.size()) / atoms.length());
  for (const Coefficient<float>& one : channel.coefficients) {
    const Index patch = Index(one.index) / atoms.count();
    if (patch >= patches.cols())
      throw Error("found a coefficient of patch " + std::to_string(patch) + ", expected fewer than " +
                  std::to_string(patches.cols()) + " patches");
    patches.col(patch) += double(one.value) * atoms.matrix().col(Index(one.index) % atoms.count());
  }
  return patches;
}

}  // namespace

std::size_t PatchDictionary::maxCoefficients() const {
  return std::size_t(maxPerPatch) * (grid.size() / std::size_t(atoms.length()));
}

PatchDictionary learnPatchDictionary(const TrainingMaterials& materials, const PatchTrainingOptions& options,
                                     const TaskControl& control) {
  if (std::size_t(options.kSvd.atoms) > count(options.patch))
    throw Error("found " + std::to_string(options.kSvd.atoms) + " atoms, expected at most " +
                std::to_string(count(options.patch)) + ", the number of cells of a patch");
  const Sizes sizes = modeSizes(materials.grid);
  const SignalOptions signalOptions{.transforms = {patchTransform}};
  const std::size_t signals = materials.names.size() * signalOptions.signalsPerMaterial();
  const std::size_t each = std::max<std::size_t>(1, options.samples / std::max<std::size_t>(1, signals));
  std::vector<Eigen::MatrixXd> drawn(signals);
  const auto draw = [&](std::size_t, std::size_t signal, const Eigen::ArrayXd& values) {
    const Eigen::MatrixXd patches = patchesOf(values, sizes, options.patch);
    std::mt19937_64 random(options.kSvd.seed + signal);
    drawn[signal].resize(patches.rows(), Index(each));
    for (auto column : drawn[signal].colwise()) column = patches.col(Index(random() % std::uint64_t(patches.cols())));
  };
  constexpr double readingFraction = 0.1;
  forEachSignal(
      materials, signalOptions, draw, [](std::size_t) {}, control.between(0, readingFraction));
  Eigen::MatrixXd all(Index(count(options.patch)), Index(signals * each));
  for (std::size_t s = 0; s < signals; ++s) all.middleCols(Index(s * each), Index(each)) = drawn[s];
  KSvdResult learned = learnKSvd(all, options.kSvd, control.between(readingFraction, 1));
  return {materials.grid, options.patch, AtomSet(std::move(learned.atoms)), materials.names};
}

SparseCode encode(const PatchDictionary& dictionary, const TabulatedBrdf& table, std::size_t coefficients,
                  const TaskControl& control) {
  checkGrid(dictionary, table.grid());
  const auto geometry = GridGeometry::of(table.grid());
  const auto signals = signalsOf(table, patchTransform, *geometry);
  SparseCode code{.grid = table.grid(), .transform = patchTransform, .channels = {}};
  for (int c = 0; c < 3; ++c) {
    ChannelCode& channel = code.channels[std::size_t(c)];
    channel.highest = highestOf(signals[std::size_t(c)], table, *geometry, true);
    const Eigen::MatrixXd patches = patchesOf(signals[std::size_t(c)], modeSizes(table.grid()), dictionary.patch);
    const PatchCode encoded =
        encodePatches(dictionary.atoms, patches, coefficients, maxPerPatch, control.between(c / 3.0, (c + 1) / 3.0));
    for (std::size_t p = 0; p < encoded.patches.size(); ++p)
      for (std::size_t i = 0; i < encoded.patches[p].atoms.size(); ++i)
        channel.coefficients.push_back(
            {.index = std::uint32_t(encoded.patches[p].atoms[i]) + std::uint32_t(dictionary.atoms.count() * Index(p)),
             .value = float(encoded.patches[p].coefficients[i])});
    std::ranges::sort(channel.coefficients, isLarger<float>);
  }
  return quantised(std::move(code));
}

std::shared_ptr<const TabulatedBrdf> decode(const PatchDictionary& dictionary, const SparseCode& code) {
  checkGrid(dictionary, code.grid);
  const auto geometry = GridGeometry::of(code.grid);
  const Eigen::ArrayXf scales = cellScales(code.grid, *geometry);
  std::vector<TabulatedBrdf::Value> values(code.grid.size());
  for (int c = 0; c < 3; ++c) {
    const ChannelCode& channel = code.channels[std::size_t(c)];
    Eigen::ArrayXd signal = signalOf(decodedPatches(dictionary, channel), modeSizes(code.grid), dictionary.patch);
    signal = (signal / scales.cast<double>()).min(double(channel.highest));
    invertTransform(signal, code.transform, geometry->weights);
    for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell][c] = float(signal[Index(cell)]);
  }
  return std::make_shared<const TabulatedBrdf>(code.grid, std::move(values), geometry->aboveHorizon);
}

}  // namespace gonio::dictionary
