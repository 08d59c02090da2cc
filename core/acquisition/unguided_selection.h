// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/coordinates/half_difference_grid.h"

/// Selections that use no training materials: the baselines for the other methods.
namespace gonio::acquisition {

/// `samples` distinct random indices below `count`; all sets and orders are equally likely. If `samples` exceeds
/// `count`, all indices, shuffled. O(count).
std::vector<std::size_t> randomIndices(std::size_t count, std::size_t samples, std::uint64_t seed);

/// Distinct indices into `cells`, spread evenly over the solid angles d wi d wo of the cells
/// (HalfDifferenceGrid::cellMeasure). The three coordinates of each point of a low-discrepancy sequence (Roberts 2018,
/// "The Unreasonable Effectiveness of Quasirandom Sequences", R_3) select theta_h, then theta_d for this theta_h, then
/// phi_d, each at that fraction of the cumulative measure. If a cell is taken, the next free one is used. A larger
/// number of samples starts with the same cells. @param cells ascending. O(cells).
std::vector<std::size_t> evenlySpreadIndices(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells,
                                             std::size_t samples);

}  // namespace gonio::acquisition
