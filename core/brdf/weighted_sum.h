// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio {

/// Weights of blended materials: one per material, each in [0, 1], with sum 1.

/// @throws Error that states the wrong number of weights, weight (also NaN) or sum (tolerance 1e-9).
void checkWeights(std::span<const double> weights, std::size_t materials);

/// The index of the material of weight 1, if any.
std::optional<std::size_t> indexOfFullWeight(std::span<const double> weights);

/// The weighted sum of BRDFs, weights >= 0, at least one > 0; terms of weight 0 are dropped. sample() selects a term in
/// proportion to its weight and uses its density.
std::shared_ptr<const Brdf> weightedSum(std::vector<std::shared_ptr<const Brdf>> terms, std::vector<double> weights);

/// The weighted sum of tables on the same grid, cell by cell; a cell is valid if it is valid in all tables of weight >
/// 0. Parallel. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> weightedSum(std::span<const std::shared_ptr<const TabulatedBrdf>> tables,
                                                 std::span<const double> weights, const TaskControl& control = {});

/// Resamples a table on another grid (trilinear); cells without data are invalid. Returns the table itself if it has
/// that grid. On a reciprocal grid the mean of both orders of the directions. @throws Cancelled.
std::shared_ptr<const TabulatedBrdf> onGrid(const std::shared_ptr<const TabulatedBrdf>& table,
                                            const HalfDifferenceGrid& grid, const TaskControl& control = {});

}  // namespace gonio
