// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/fitting/fit_cells.h"

namespace gonio::fitting {

/// Messages for the user about problems that make a fit to these cells doubtful: no cells, black channels, many
/// negative values, the same value everywhere, one cell that outweighs all others. Usually empty. One pass over the
/// used cells.
std::vector<std::string> measurementWarnings(const TabulatedBrdf& table, const CellSelection& selection);
/// The same for cells without a table. @param negative number of channel values that were below 0.
std::vector<std::string> measurementWarnings(const FitCells& cells, std::size_t negative);

}  // namespace gonio::fitting
