// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/coordinates/half_difference_grid.h"
#include "core/support/json_object.h"

/// Grids in the JSON descriptions of files.
namespace gonio::materials {

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

}  // namespace gonio::materials
