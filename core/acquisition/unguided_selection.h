// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/coordinates/half_difference_grid.h"

/// Choices that know nothing of materials: what the others have to better.
namespace gonio::acquisition {

/// Distinct indices below `count`, all sets and orders alike; all of them, shuffled, when there are fewer. O(count).
std::vector<std::size_t> randomIndices(std::size_t count, std::size_t samples, std::uint64_t seed);

/// Distinct indices of `cells`, spread evenly over the measure d wi d wo that the cells stand for
/// (HalfDifferenceGrid::cellMeasure): the inverse of the cumulative measure at the points of a low-discrepancy sequence
/// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R_3). A cell that is taken gives way to
/// the next. More samples begin with the same cells. @param cells ascending. O(cells).
std::vector<std::size_t> evenlySpreadIndices(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells,
                                             std::size_t samples);

}  // namespace gonio::acquisition
