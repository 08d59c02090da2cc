// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::tool {

/// Pairs of directions with angles in degrees, as in the file.
struct DirectionTable {
  struct Row {
    double thetaI, phiI, thetaO, phiO;
  };
  std::vector<Row> rows;

  std::vector<DirectionPair> pairs() const;
};

/// Reads a CSV file (core/io/csv_text.h) with the columns theta_i, phi_i, theta_o, phi_o. The first line contains the
/// names (in any order, further columns are ignored); without names the columns have this order.
/// @throws Error that names the file, the line, what was found and what was expected.
DirectionTable readDirections(const std::filesystem::path& path);

/// theta_i, phi_i, theta_o, phi_o, r, g, b: degrees and 1/sr, with all digits.
std::string valuesCsv(const DirectionTable& directions, const std::vector<Rgb>& values);

}  // namespace gonio::tool
