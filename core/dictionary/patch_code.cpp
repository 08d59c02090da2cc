// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/patch_code.h"

#include <algorithm>
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

}  // namespace gonio::dictionary
