// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/acquisition/measurable_directions.h"
#include "core/dictionary/principal_components.h"
#include "widgets/acquisition/half_difference_chart.h"

namespace gonio::app {

/// The chart's slice at the k-th phi_d of a grid: which cells can be measured, and how uncertain each cell is.
/// @param mapping the cells with training data; null before a basis is learned: then no cell is CellState::unlearned.
/// @param deviations one per cell of the mapping, or empty. O(cells of the slice).
widgets::HalfDifferenceSlice sliceAt(int k, const HalfDifferenceGrid& grid,
                                     const acquisition::MeasurableDirections& measurable,
                                     const dictionary::MappedCells* mapping, std::span<const float> deviations);

}  // namespace gonio::app
