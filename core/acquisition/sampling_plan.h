// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/coordinates/half_difference_grid.h"

/// Which pairs of directions a goniometer shall visit, and in which order.
namespace gonio::acquisition {

struct PlannedSample {
  int index = 0;             ///< from 1 in the order of choice: the first ones matter most; names the sample in files
  DirectionPair directions;  ///< at or above the horizon. Of isotropic materials: both may be turned about the normal
  int order = 0;             ///< from 1 in the order of measurement, along a short path of the arms

  bool operator==(const PlannedSample& other) const {
    return index == other.index && order == other.order && directions.wi == other.directions.wi &&
           directions.wo == other.directions.wo;
  }
};

struct SamplingPlan {
  std::vector<PlannedSample> samples;  ///< by index
  std::string method;                  ///< how they were chosen, for people; may be empty
  std::string basisDigest;             ///< of the file of principal components that belongs to it; empty: none is known

  /// The positions of the samples in `samples` in the order of measurement.
  std::vector<std::size_t> measurementOrder() const;
};

/// Nodes of a grid as directions (phi_h = 0), in the order of `cells`, with an order of measurement. Deterministic.
/// @throws Error naming a cell below the horizon or outside the grid.
SamplingPlan planFor(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells);

/// The node that stands for all nodes of the same pair of directions: where theta_h or theta_d is 0 that of phi_d = 0,
/// since there phi_d changes nothing but a turn of both about the normal; any other node is the only one.
std::uint32_t pairNode(const HalfDifferenceGrid& grid, std::size_t node);

/// The node nearest to a pair of directions in grid coordinates, each rounded: pairNode() of it.
/// @throws Error where light and viewer are opposite, or one lies below the horizon.
std::uint32_t nearestNode(const HalfDifferenceGrid& grid, const DirectionPair& directions);

/// The angle by which the arms have to move between two pairs, rad: of the light and of the viewer together.
double armTravel(const DirectionPair& from, const DirectionPair& to);

/// A short way through all pairs, from where the arms stand upright: nearest neighbour, then 2-opt (Croes 1958) until
/// nothing gains, O(n^2) a round. Of more than 512 pairs simply in the order of the polar angle of the light, then of
/// the viewer, O(n log n). @return positions in `pairs`. Deterministic.
std::vector<std::size_t> shortPath(std::span<const DirectionPair> pairs);

}  // namespace gonio::acquisition
