// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/materials/basis_file.h"
#include "core/support/task_control.h"

namespace gonio::study {

/// Number of components of a basis by default. Reconstructions from few readings are not more accurate with more
/// (docs/results/acquisition-study.md).
inline constexpr int defaultBasisComponents = 128;

/// Bases that are kept need at most this many bytes together; those that were not used for the longest time are
/// removed. A basis of 128 components over the MERL grid has 285 MB.
inline constexpr std::uint64_t maxKeptBytes = 2'000'000'000;

/// The folder of kept bases: gonio/bases in $XDG_CACHE_HOME, otherwise in ~/.cache; empty if neither is known.
std::filesystem::path keptBasesFolder();

struct LearnedBasis {
  std::shared_ptr<const materials::BasisFile> basis;
  /// The file that keeps it, which is read-only; empty if it could not be kept.
  std::filesystem::path file;
  std::string digest;  ///< SHA-256 of the file's bytes, lower-case hex
  double seconds = 0;  ///< time to learn it; 0 if it was kept
};

/// The principal components of a training set, on the grid of its tables (trainingGrid()). They are learned once (0.2 s
/// per bundled material) and kept in keptBasesFolder() for the same components, precision, and materials (bundled ones
/// by their content, files by path, size and date); reading them takes about 1 s. The result has the rounding of the
/// file, so that it does not depend on whether it was kept. A training set that contains .gonio documents, which refer
/// to other files, is not kept.
/// @param files trainingFiles(). @param components maximum number. @throws as trainingMaterials() and
/// learnPrincipalComponents(); Cancelled.
LearnedBasis learnedBasis(const std::vector<std::string>& files, int components = defaultBasisComponents,
                          materials::BasisPrecision precision = materials::BasisPrecision::half,
                          const TaskControl& control = {});

}  // namespace gonio::study
