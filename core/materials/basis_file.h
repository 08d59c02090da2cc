// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/coordinates/half_difference_grid.h"
#include "core/dictionary/principal_components.h"
#include "core/io/byte_source.h"
#include "core/support/json_object.h"

namespace gonio::materials {

// Grids in the JSON descriptions of files.

inline constexpr int maxGridNodes = 1024;  ///< per axis

inline nlohmann::json gridJson(const HalfDifferenceGrid& grid) {
  return {{"thetaH", grid.thetaHCount},
          {"thetaD", grid.thetaDCount},
          {"phiD", grid.phiDCount},
          {"reciprocal", grid.reciprocal}};
}

/// @throws Error that names a member which is missing or not in [1, maxGridNodes].
inline HalfDifferenceGrid gridOf(const JsonObject& object) {
  const auto count = [&](const char* key) { return int(object.number(key, 1, maxGridNodes)); };
  return {.thetaHCount = count("thetaH"),
          .thetaDCount = count("thetaD"),
          .phiDCount = count("phiD"),
          .reciprocal = object.flag("reciprocal")};
}

// A file of principal components, `.basis`, with which materials are reconstructed from the samples of a plan. A
// container (core/io/container.h) "GONIOPCA", version 2; a description with the grid, the numbers of cells, components
// and signals, the precision and the training materials; then
//   the mask of the mapped cells, one bit per cell of the grid, lowest bit first; for each mapped cell the reference
//   and the mean (float32); the square roots of leftOutVariance() for the stored components: their maximum (float32),
//   then all of them divided by it, float16 or float32; the singular values, then V column by column (float64); per
//   component the largest absolute entry of its column of U (float32), then the column divided by it, float16 or
//   float32.
// The weights of the cells follow from the grid. 1.1 million cells take 11.1 MB plus 2.2 MB per component in half
// precision, which changes a mapped value y by less than about y / 2000.

inline constexpr std::string_view basisSuffix = ".basis";

enum class BasisPrecision { single, half };

struct BasisFile {
  dictionary::PrincipalComponents components;
  std::vector<std::string> learnedFrom;  ///< names of the training materials
};

/// The bytes of a file. @param components number of components to store, at most basis.count().
std::vector<std::byte> encodeBasis(const dictionary::PrincipalComponents& basis, int components,
                                   const std::vector<std::string>& learnedFrom,
                                   BasisPrecision precision = BasisPrecision::half);
/// Writes a file, atomically. @throws Error that names the file.
void writeBasis(const dictionary::PrincipalComponents& basis, int components,
                const std::vector<std::string>& learnedFrom, const std::filesystem::path& path,
                BasisPrecision precision = BasisPrecision::half);

/// Reads a file; checks its size before memory is allocated. @throws Error that names the file, what was found and what
/// was expected.
std::shared_ptr<const BasisFile> readBasis(const std::filesystem::path& path);
/// The same for bytes; errors name no file.
std::shared_ptr<const BasisFile> readBasis(const io::ByteSource& source);

/// Every second node of MERL tables in theta_h and theta_d, every fourth in phi_d. A finer grid does not improve
/// reconstructions from scattered points.
inline constexpr HalfDifferenceGrid bundledBasisGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 45};

/// The principal components of the bundled materials and the largest of their values, on bundledBasisGrid; used to
/// reconstruct scattered measurements.
struct BundledBasis {
  dictionary::PrincipalComponents components;  ///< of the measured and near-measured bundled materials
  std::vector<float> largest;                  ///< per cell, the largest channel value of all bundled materials, 1/sr
};

/// Computed at the first call in a process (5 s), then shared; 19 MB. @throws Cancelled; the next call then starts
/// again.
std::shared_ptr<const BundledBasis> bundledBasis(const TaskControl& control = {});

}  // namespace gonio::materials
