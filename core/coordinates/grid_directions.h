// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/coordinates/half_difference_grid.h"

namespace gonio {

/// The directions of all nodes of a grid, for loops over whole tables: computes sines and cosines once per axis instead
/// of per node. Bitwise equal to the methods of HalfDifferenceGrid, about 20 times as fast.
class GridDirections {
 public:
  explicit GridDirections(const HalfDifferenceGrid& grid);

  struct Node {
    DirectionPair pair;  ///< phi_h = 0; z clamped to >= 0 where `aboveHorizon`
    bool aboveHorizon;
  };
  Node at(std::size_t index) const;

 private:
  struct SineCosine {
    double sine, cosine;
  };
  HalfDifferenceGrid grid_;
  std::vector<SineCosine> thetaH_, thetaD_, phiD_;
};

}  // namespace gonio
