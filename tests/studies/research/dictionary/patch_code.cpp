// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/research/dictionary/patch_code.h"

#include <algorithm>
#include <random>
#include <string>

#include "core/dictionary/dictionary.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

using Eigen::Index;

void checkSizes(const Sizes& sizes, const Sizes& patch) {
  for (std::size_t mode = 0; mode < 3; ++mode)
    if (patch[mode] < 1 || sizes[mode] % patch[mode] != 0)
      throw Error("patches of " + std::to_string(patch[mode]) + " nodes do not tile the " +
                  std::to_string(sizes[mode]) + " nodes of mode " + std::to_string(mode));
}

/// Calls work(cell, row, column) for every cell of a signal and where it stands among the patches.
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

/// The fraction of a patch's norm at which its error is `error`.
double fractionOf(double error, double norm) { return norm > 0 ? error / norm : 0; }

PatchCode codeToError(const AtomSet& atoms, const Eigen::MatrixXd& patches, double error, int most,
                      const TaskControl& control) {
  PatchCode code;
  code.patches.resize(std::size_t(patches.cols()));
  constexpr std::size_t block = 16;
  const auto pursue = [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Eigen::VectorXd patch = patches.col(Index(p));
      code.patches[p] =
          orthogonalMatchingPursuit(atoms, patch, {.steps = most, .residual = fractionOf(error, patch.norm())});
    }
  };
  parallelForBlocks(code.patches.size(), block, pursue, {.stop = control.stop});
  return code;
}

/// The coefficients that codeToError() spends, told from its pursuits to the end.
std::size_t coefficientsFor(double error, const PatchCode& ends) {
  std::size_t sum = 0;
  for (const PursuitResult& end : ends.patches) {
    const double enough = fractionOf(error, end.path[0]) * end.path[0];
    // The norms of a path never grow.
    const auto reached = std::find_if(end.path.begin(), end.path.end(), [&](double norm) { return norm <= enough; });
    sum += std::min(std::size_t(reached - end.path.begin()), end.atoms.size());
  }
  return sum;
}

}  // namespace

Eigen::MatrixXd patchesOf(const Eigen::ArrayXf& signal, const Sizes& sizes, const Sizes& patch) {
  checkSizes(sizes, patch);
  Eigen::MatrixXd patches(Index(count(patch)), Index(count(sizes) / count(patch)));
  forEachCell(sizes, patch, [&](Index cell, Index row, Index column) { patches(row, column) = double(signal[cell]); });
  return patches;
}

Eigen::ArrayXf signalOf(const Eigen::MatrixXd& patches, const Sizes& sizes, const Sizes& patch) {
  checkSizes(sizes, patch);
  Eigen::ArrayXf signal(Index(count(sizes)));
  forEachCell(sizes, patch, [&](Index cell, Index row, Index column) { signal[cell] = float(patches(row, column)); });
  return signal;
}

KSvdResult learnPatchAtoms(const TrainingMaterials& materials, const PatchTrainingOptions& options,
                           const TaskControl& control) {
  const Sizes sizes = modeSizes(materials.grid);
  checkSizes(sizes, options.patch);
  const std::size_t signals = materials.names.size() * options.signals.signalsPerMaterial();
  const std::size_t each = std::max<std::size_t>(1, options.samples / std::max<std::size_t>(1, signals));
  std::vector<Eigen::MatrixXd> drawn(signals);
  const auto draw = [&](std::size_t, std::size_t signal, const Eigen::ArrayXf& values) {
    const Eigen::MatrixXd patches = patchesOf(values, sizes, options.patch);
    std::mt19937_64 random(options.kSvd.seed + signal);
    drawn[signal].resize(patches.rows(), Index(each));
    for (auto column : drawn[signal].colwise()) column = patches.col(Index(random() % std::uint64_t(patches.cols())));
  };
  constexpr double readingFraction = 0.1;
  forEachSignal(
      materials, options.signals, draw, [](std::size_t) {}, control.between(0, readingFraction));
  Eigen::MatrixXd all(Index(count(options.patch)), Index(signals * each));
  for (std::size_t s = 0; s < signals; ++s) all.middleCols(Index(s * each), Index(each)) = drawn[s];
  return learnKSvd(all, options.kSvd, control.between(readingFraction, 1));
}

std::size_t PatchCode::coefficients() const {
  std::size_t sum = 0;
  for (const PursuitResult& patch : patches) sum += patch.atoms.size();
  return sum;
}

PatchCode encodePatches(const AtomSet& atoms, const Eigen::MatrixXd& patches, std::size_t coefficients,
                        int mostOfAPatch, const TaskControl& control) {
  const PatchCode ends = codeToError(atoms, patches, 0, mostOfAPatch, control);
  control.report(0.5);
  // At the error of the largest patch no coefficient is spent.
  double tooMany = 0, fits = patches.size() > 0 ? patches.colwise().norm().maxCoeff() : 0;
  constexpr int bisections = 16;
  for (int step = 0; step < bisections; ++step) {
    const double error = (tooMany + fits) / 2;
    (coefficientsFor(error, ends) > coefficients ? tooMany : fits) = error;
  }
  return codeToError(atoms, patches, fits, mostOfAPatch, control);
}

Eigen::MatrixXd decodePatches(const AtomSet& atoms, const PatchCode& code) {
  Eigen::MatrixXd patches = Eigen::MatrixXd::Zero(atoms.length(), Index(code.patches.size()));
  for (std::size_t p = 0; p < code.patches.size(); ++p)
    for (std::size_t i = 0; i < code.patches[p].atoms.size(); ++i)
      patches.col(Index(p)) += code.patches[p].coefficients[i] * atoms.matrix().col(code.patches[p].atoms[i]);
  return patches;
}

}  // namespace gonio::dictionary
