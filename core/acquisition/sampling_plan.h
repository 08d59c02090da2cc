// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/coordinates/half_difference_grid.h"

namespace gonio::acquisition {

// The pairs of directions that a goniometer measures, and their order.

struct PlannedSample {
  int index = 0;  ///< from 1, in the order of choice (the most important first); identifies the sample in files
  DirectionPair directions;  ///< at or above the horizon; for isotropic materials both may be rotated about the normal
  int order = 0;             ///< from 1, in the order of measurement: along a short path of the arms

  bool operator==(const PlannedSample& other) const {
    return index == other.index && order == other.order && directions.wi == other.directions.wi &&
           directions.wo == other.directions.wo;
  }
};

struct SamplingPlan {
  std::vector<PlannedSample> samples;  ///< in the order of their index
  std::string method;                  ///< how they were chosen, for display; may be empty
  std::string basisDigest;             ///< of the file of principal components that the plan belongs to; empty: unknown

  /// The positions of the samples in `samples` in the order of measurement.
  std::vector<std::size_t> measurementOrder() const;
};

/// A plan that measures nodes of a grid (at phi_h = 0). Indices follow the order of `cells`; the order of measurement
/// is shortPath(). Deterministic. @throws Error that names a cell below the horizon or outside the grid.
SamplingPlan planFor(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells);

/// The node that represents all nodes of the same pair of directions. Where theta_h or theta_d is 0, phi_d at most
/// rotates both directions about the normal, so it is the node with phi_d = 0; elsewhere it is the node itself.
std::uint32_t pairNode(const HalfDifferenceGrid& grid, std::size_t node);

/// pairNode() of the node nearest to a pair of directions (each grid coordinate is rounded). @throws Error if light and
/// viewer are opposite or one lies below the horizon.
std::uint32_t nearestNode(const HalfDifferenceGrid& grid, const DirectionPair& directions);

/// The angle that the arms move between two pairs, rad: the sum for light and viewer.
double armTravel(const DirectionPair& from, const DirectionPair& to);

/// A short path through all pairs that starts with both arms at the normal: nearest neighbour, then 2-opt (Croes 1958,
/// "A Method for Solving Traveling-Salesman Problems") until no exchange shortens it, O(n^2) per round. More than 512
/// pairs are only sorted by the polar angle of the light, then of the viewer, O(n log n). @return positions in `pairs`.
/// Deterministic.
std::vector<std::size_t> shortPath(std::span<const DirectionPair> pairs);

// A sampling plan as CSV (csv_text.h): comment lines, then the columns
//   index, theta_i, phi_i, theta_o, phi_o, theta_h, theta_d, phi_d, order
// with angles in degrees; i is the light, o the viewer, as a comment says. The comments "method: .." and "basis,
// SHA-256: .." are read. theta_h, theta_d and phi_d are redundant, for the user's information; readers only use them to
// detect angles in radians. `order` is the order of measurement, along a short path of the arms.

/// Angles have six decimals, enough to find the node of the directions again. @param comments lines of comments,
/// without #.
std::string planCsv(const SamplingPlan& plan, const std::vector<std::string>& comments = {});
/// Writes a file, atomically. @throws Error that names the file.
void writePlan(const SamplingPlan& plan, const std::filesystem::path& path,
               const std::vector<std::string>& comments = {});

/// Reads a plan. Columns and rows may have any order; other columns are ignored; if `order` is missing, the path is
/// planned again. @throws Error that names the file and the line: a missing or repeated column or index, an index below
/// 1, an angle that is not in degrees above the horizon, an `order` that is not a permutation of 1 to the number of
/// rows, no rows or more than 65,536, or angles that appear to be radians (all small, and inconsistent with theta_h and
/// theta_d as degrees).
SamplingPlan readPlan(const std::filesystem::path& path);
/// The same for text; errors name no file.
SamplingPlan parsePlan(std::string_view text);

}  // namespace gonio::acquisition
