// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/math/types.h"

namespace gonio {

/// One coordinate of a pair of directions.
struct CoordinateColumn {
  std::string_view name;  ///< of columns in files
  bool isAngle = true;    ///< rad here, degrees in files; otherwise without unit
};

/// Coordinates of a pair of directions by name, for files and Python. wi points toward the light, wo toward the viewer.
struct CoordinateSystem {
  std::string_view id, source;
  std::vector<CoordinateColumn> columns;
  /// One value per column, angles in rad. @param pair unit vectors above the horizon.
  std::vector<double> (*to)(const DirectionPair& pair);
  /// The pair with the viewer (half-difference: the half vector) at azimuth 0, or none if no pair of directions above
  /// the horizon has these coordinates. @param values one per column, finite, angles in rad.
  std::optional<DirectionPair> (*from)(std::span<const double> values);
};

/// The polar angles and azimuths of both directions (standard), toHalfDifference(), toHalfOut() and
/// toProjectedDeviation(), with the ranges that are stated there.
std::span<const CoordinateSystem> coordinateSystems();
/// @throws Error that lists the names.
const CoordinateSystem& coordinateSystemNamed(std::string_view id);

}  // namespace gonio
