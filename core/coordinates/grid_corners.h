// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/coordinates/half_difference_grid.h"

namespace gonio {

/// The two neighbouring nodes of a position on one axis, and the weight of the upper one.
struct GridBracket {
  int low, high;
  double weight;
};

/// Beyond the last node, values of the last node. @param position in nodes.
inline GridBracket clampedBracket(double position, int count) {
  position = std::clamp(position, 0.0, count - 1.0);
  const int low = static_cast<int>(position);
  return {low, std::min(low + 1, count - 1), position - low};
}

/// After the last node, the first. @param position in nodes, in [0, count].
inline GridBracket wrappedBracket(double position, int count) {
  const int low = std::min(static_cast<int>(position), count - 1);
  return {low, low + 1 == count ? 0 : low + 1, position - low};
}

/// The eight nodes about a position in a grid, for trilinear interpolation: a corner has the upper node of phi_d if its
/// bit 0 is set, of theta_d if bit 1 is, of theta_h if bit 2 is.
struct GridCorners {
  GridBracket thetaH, thetaD, phiD;
  std::size_t rows[4];  ///< first cells of the phi_d rows, by bits 1 and 2 of the corner

  GridCorners() = default;  ///< uninitialised
  GridCorners(const HalfDifferenceGrid& grid, const HalfDifferenceGrid::Position& position)
      : thetaH(clampedBracket(position.thetaH, grid.thetaHCount)),
        thetaD(clampedBracket(position.thetaD, grid.thetaDCount)),
        phiD(wrappedBracket(position.phiD, grid.phiDCount)),
        rows{grid.index(thetaH.low, thetaD.low, 0), grid.index(thetaH.low, thetaD.high, 0),
             grid.index(thetaH.high, thetaD.low, 0), grid.index(thetaH.high, thetaD.high, 0)} {}

  std::size_t cell(int corner) const {
    return rows[corner >> 1] + static_cast<std::size_t>((corner & 1) != 0 ? phiD.high : phiD.low);
  }
  /// The weights of all corners sum to 1.
  double weight(int corner) const {
    return ((corner & 4) != 0 ? thetaH.weight : 1 - thetaH.weight) *
           ((corner & 2) != 0 ? thetaD.weight : 1 - thetaD.weight) *
           ((corner & 1) != 0 ? phiD.weight : 1 - phiD.weight);
  }
};

}  // namespace gonio
