// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/coordinates/half_difference_grid.h"

namespace gonio {

/// Where GridDirections lie.
enum class GridPoints {
  nodes,  ///< at the nodes; bitwise equal to the methods of HalfDifferenceGrid
  /// One in each cell (HalfDifferenceGrid::cellMeasure()), spread evenly over all: for integrals of functions that are
  /// special at the nodes, such as the error of a table. For node n, the cell is divided into 16 steps along each axis,
  /// and the point lies in the middle of step floor(16 frac(n / g)) of theta_h, floor(16 frac(n / g^2)) of theta_d and
  /// floor(16 frac(n / g^3)) of phi_d with g = 1.2207440846 (Roberts 2018, "The Unreasonable Effectiveness of
  /// Quasirandom Sequences"). Points of nodes with phi_d and -phi_d mirror each other: those of the second half of
  /// phi_d follow from the first.
  scattered
};

/// The directions of all nodes or cells of a grid, for loops over whole tables: computes sines and cosines once per
/// axis instead of per node, about 20 times as fast.
class GridDirections {
 public:
  explicit GridDirections(const HalfDifferenceGrid& grid, GridPoints points = GridPoints::nodes);

  struct Node {
    DirectionPair pair;  ///< phi_h = 0; z clamped to >= 0 where `aboveHorizon`
    bool aboveHorizon;
  };
  Node at(std::size_t index) const;

 private:
  struct SineCosine {
    double sine, cosine;
  };
  std::size_t steps_;  ///< points of a cell along an axis, one after the other in the lists
  std::size_t thetaDCount_, phiCount_;
  std::vector<SineCosine> thetaH_, thetaD_, phiD_, phiDSteps_;
};

}  // namespace gonio
