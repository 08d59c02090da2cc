// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/coordinates/half_difference_grid.h"

namespace gonio {

/// Evaluates a BRDF at nodes of a grid. If the BRDF is known to have equal values at nodes that mirror each other
/// (phi_d and -phi_d), it is evaluated at the first of the two only, and the value is copied to the other. Up to
/// rounding the values are those of Brdf::evaluate().
/// @param nodes ascending. @param pairs the directions of each node. @param values one per node, linear RGB, 1/sr.
/// @param bothOrders whether the caller also adds the values with light and viewer exchanged. On a folded grid, -phi_d
/// is stored as pi - phi_d, which is the mirrored pair with light and viewer exchanged. The sums of both orders are
/// then equal at the two nodes even if the BRDF is not reciprocal.
void evaluateNodes(const Brdf& brdf, const HalfDifferenceGrid& grid, std::span<const std::size_t> nodes,
                   std::span<const DirectionPair> pairs, std::span<Rgb> values, bool bothOrders = false);

}  // namespace gonio
