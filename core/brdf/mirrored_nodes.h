// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/coordinates/half_difference_grid.h"

namespace gonio {

/// Evaluates a BRDF at nodes of a grid; of two nodes that mirror each other (phi_d and -phi_d), only the first, where
/// the BRDF is known to have the same value at both. Up to rounding the values are those of Brdf::evaluate().
/// @param nodes ascending. @param pairs directions of each node. @param values as many, linear RGB, 1/sr.
/// @param bothOrders whether the caller adds the values with the directions exchanged, so that their order does not
/// matter.
void evaluateNodes(const Brdf& brdf, const HalfDifferenceGrid& grid, std::span<const std::size_t> nodes,
                   std::span<const DirectionPair> pairs, std::span<Rgb> values, bool bothOrders = false);

}  // namespace gonio
