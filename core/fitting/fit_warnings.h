// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/fitting/fit_cells.h"

namespace gonio::fitting {

/// Sentences for people about what makes a fit to these cells doubtful: no cells, black channels, many values below
/// 0, the same value everywhere, one cell that outweighs all others. Usually none. One pass over the cells that count.
std::vector<std::string> measurementWarnings(const TabulatedBrdf& table, const CellCensus& census);
/// The same of cells that no table holds. @param negative channels of them that were below 0.
std::vector<std::string> measurementWarnings(const FitCells& cells, std::size_t negative);

}  // namespace gonio::fitting
