// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/grid_directions.h"

#include <algorithm>
#include <cmath>

namespace gonio {

GridDirections::GridDirections(const HalfDifferenceGrid& grid) : grid_(grid) {
  const auto of = [](double angle) { return SineCosine{std::sin(angle), std::cos(angle)}; };
  for (int i = 0; i < grid.thetaHCount; ++i) thetaH_.push_back(of(grid.node(grid.index(i, 0, 0)).thetaH));
  for (int j = 0; j < grid.thetaDCount; ++j) thetaD_.push_back(of(grid.node(grid.index(0, j, 0)).thetaD));
  for (int k = 0; k < grid.phiDCount; ++k) phiD_.push_back(of(grid.node(grid.index(0, 0, k)).phiD));
}

GridDirections::Node GridDirections::at(std::size_t index) const {
  const std::size_t phiCount = phiD_.size(), row = index / phiCount;
  const SineCosine& h = thetaH_[row / thetaD_.size()];
  const SineCosine& d = thetaD_[row % thetaD_.size()];
  const SineCosine& f = phiD_[index % phiCount];
  Node node{fromHalfDifference(h.sine, h.cosine, d.sine, d.cosine, f.sine, f.cosine),
            isAboveHorizon(h.sine, h.cosine, d.sine, d.cosine, f.cosine)};
  if (node.aboveHorizon) {
    // Rounding alone leaves horizontal directions a little below.
    node.pair.wi.z = std::max(0.0, node.pair.wi.z);
    node.pair.wo.z = std::max(0.0, node.pair.wo.z);
  }
  return node;
}

}  // namespace gonio
