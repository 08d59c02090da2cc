// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_slice.h"

#include <algorithm>
#include <limits>

namespace gonio::app {

namespace {

/// The place of a cell in the mapping; nothing where it does not count.
std::optional<std::size_t> placeIn(const dictionary::MappedCells& mapping, std::size_t cell) {
  const auto found = std::ranges::lower_bound(mapping.cells, cell);
  if (found == mapping.cells.end() || *found != cell) return std::nullopt;
  return std::size_t(found - mapping.cells.begin());
}

widgets::CellState stateOf(const HalfDifferenceGrid& grid, std::size_t cell,
                           const acquisition::MeasurableDirections& measurable, bool learned) {
  using widgets::CellState;
  if (!grid.nodeAboveHorizon(cell)) return CellState::belowHorizon;
  if (!grid.nodeWithin(cell, measurable.maxPolarAngle)) return CellState::grazing;
  if (!measurable.allows(grid.directions(cell))) return CellState::forbidden;
  return learned ? CellState::measurable : CellState::unlearned;
}

}  // namespace

widgets::HalfDifferenceSlice sliceAt(int k, const HalfDifferenceGrid& grid,
                                     const acquisition::MeasurableDirections& measurable,
                                     const dictionary::MappedCells* mapping, std::span<const float> deviations) {
  widgets::HalfDifferenceSlice slice{.phiD = k * grid.phiDPeriod() / grid.phiDCount,
                                     .thetaHCount = grid.thetaHCount,
                                     .thetaDCount = grid.thetaDCount,
                                     .states = {},
                                     .deviations = {}};
  for (int i = 0; i < grid.thetaHCount; ++i)
    for (int j = 0; j < grid.thetaDCount; ++j) {
      const std::size_t cell = grid.index(i, j, k);
      const auto place = mapping ? placeIn(*mapping, cell) : std::nullopt;
      slice.states.push_back(stateOf(grid, cell, measurable, place || !mapping));
      if (!deviations.empty())
        slice.deviations.push_back(place ? deviations[*place] : std::numeric_limits<float>::quiet_NaN());
    }
  return slice;
}

}  // namespace gonio::app
