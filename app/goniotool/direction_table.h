// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::tool {

/// Pairs of directions as people write them: angles in degrees, as they stand in the file.
struct DirectionTable {
  struct Row {
    double thetaI, phiI, thetaO, phiO;
  };
  std::vector<Row> rows;

  std::vector<DirectionPair> pairs() const;
};

/// Reads a CSV (core/io/csv_text.h) of columns theta_i, phi_i, theta_o, phi_o: a first line with their names (in any
/// order, others beside them are ignored), or numbers in this order at once.
/// @throws Error naming the file, the line, what was found and what was expected.
DirectionTable readDirections(const std::filesystem::path& path);

/// theta_i, phi_i, theta_o, phi_o, r, g, b: degrees and 1/sr, with all digits.
std::string valuesCsv(const DirectionTable& directions, const std::vector<Rgb>& values);

}  // namespace gonio::tool
