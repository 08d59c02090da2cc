// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio {

/// The sum of weight times BRDF value, the weights >= 0; terms of weight 0 are left out. Samples directions from the
/// terms' own densities, each as often as its weight says.
std::shared_ptr<const Brdf> weightedSum(std::vector<std::shared_ptr<const Brdf>> terms, std::vector<double> weights);

/// The same of tables on one grid, cell by cell; a cell is valid where it is in all tables of a weight > 0.
/// In parallel. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> weightedSum(std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                                 std::span<const double> weights, const TaskControl& control = {});

/// A table on another grid: its values between the nodes, valid where it has data. The table itself where the grid is
/// its own. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> onGrid(const std::shared_ptr<const TabulatedBrdf>& table,
                                            const HalfDifferenceGrid& grid, const TaskControl& control = {});

}  // namespace gonio
