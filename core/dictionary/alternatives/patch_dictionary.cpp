// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/patch_dictionary.h"

#include <algorithm>
#include <random>
#include <string>

#include "core/dictionary/code_packing.h"
#include "core/dictionary/dictionary.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

using Eigen::Index;

void checkSizes(const Sizes& sizes, const Sizes& patch) {
  for (std::size_t mode = 0; mode < 3; ++mode)
    if (patch[mode] < 1 || sizes[mode] % patch[mode] != 0)
      throw Error("patches of " + std::to_string(patch[mode]) + " nodes do not tile the " +
                  std::to_string(sizes[mode]) + " nodes of mode " + std::to_string(mode));
}

/// Calls work(cell, row, column) for every cell of a signal, with its row and column in the matrix of patches.
template <typename Work>
void forEachCell(const Sizes& sizes, const Sizes& patch, const Work& work) {
  const Index across = sizes[0] / patch[0], along = sizes[1] / patch[1];
  Index cell = 0;
  for (Index k = 0; k < sizes[2]; ++k)
    for (Index j = 0; j < sizes[1]; ++j)
      for (Index i = 0; i < sizes[0]; ++i, ++cell)
        work(cell, i % patch[0] + patch[0] * (j % patch[1] + patch[1] * (k % patch[2])),
             i / patch[0] + across * (j / patch[1] + along * (k / patch[2])));
}

/// `error` as a fraction of a patch's norm.
double fractionOf(double error, double norm) { return norm > 0 ? error / norm : 0; }

PatchCode codeToError(const AtomSet& atoms, const Eigen::MatrixXd& patches, double error, int most,
                      const TaskControl& control) {
  PatchCode code;
  code.patches.resize(std::size_t(patches.cols()));
  const BatchPursuit pursuit(atoms);
  constexpr std::size_t block = 16;
  const auto pursue = [&](std::size_t begin, std::size_t end) {
    std::vector<double> residuals;
    for (std::size_t p = begin; p < end; ++p) residuals.push_back(fractionOf(error, patches.col(Index(p)).norm()));
    std::ranges::move(pursuit.code(patches, Index(begin), Index(end), {.steps = most}, residuals),
                      code.patches.begin() + std::ptrdiff_t(begin));
  };
  parallelForBlocks(code.patches.size(), block, pursue, {.stop = control.stop});
  return code;
}

/// Number of coefficients of codeToError(), from the codes with the maximum number.
std::size_t coefficientsFor(double error, const PatchCode& longest) {
  std::size_t sum = 0;
  for (const PursuitResult& code : longest.patches) {
    const double enough = fractionOf(error, code.path[0]) * code.path[0];
    // The norms of a path never increase.
    const auto reached = std::find_if(code.path.begin(), code.path.end(), [&](double norm) { return norm <= enough; });
    sum += std::min(std::size_t(reached - code.path.begin()), code.atoms.size());
  }
  return sum;
}

}  // namespace

Eigen::MatrixXd patchesOf(const Eigen::ArrayXd& signal, const Sizes& sizes, const Sizes& patch) {
  checkSizes(sizes, patch);
  Eigen::MatrixXd patches(Index(count(patch)), Index(count(sizes) / count(patch)));
  forEachCell(sizes, patch, [&](Index cell, Index row, Index column) { patches(row, column) = signal[cell]; });
  return patches;
}

Eigen::ArrayXd signalOf(const Eigen::MatrixXd& patches, const Sizes& sizes, const Sizes& patch) {
  checkSizes(sizes, patch);
  Eigen::ArrayXd signal(Index(count(sizes)));
  forEachCell(sizes, patch, [&](Index cell, Index row, Index column) { signal[cell] = patches(row, column); });
  return signal;
}

std::size_t PatchCode::coefficients() const {
  std::size_t sum = 0;
  for (const PursuitResult& patch : patches) sum += patch.atoms.size();
  return sum;
}

PatchCode encodePatches(const AtomSet& atoms, const Eigen::MatrixXd& patches, std::size_t coefficients, int maxPerPatch,
                        const TaskControl& control) {
  const PatchCode longest = codeToError(atoms, patches, 0, maxPerPatch, control);
  control.report(0.5);
  // At the largest norm of a patch, no coefficient is needed.
  double tooMany = 0, fits = patches.size() > 0 ? patches.colwise().norm().maxCoeff() : 0;
  constexpr int bisections = 16;
  for (int step = 0; step < bisections; ++step) {
    const double error = (tooMany + fits) / 2;
    (coefficientsFor(error, longest) > coefficients ? tooMany : fits) = error;
  }
  return codeToError(atoms, patches, fits, maxPerPatch, control);
}

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
  const auto draw = [&](std::size_t, std::size_t signal, std::span<const Eigen::ArrayXd> parts) {
    const Eigen::MatrixXd patches = patchesOf(parts.front(), sizes, options.patch);
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
    channel.highest = rangeOf(signals[std::size_t(c)], table, *geometry, true).highest;
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
