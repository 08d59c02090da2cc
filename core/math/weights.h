// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// Weights of materials that are blended: one per material, each in [0, 1], with the sum 1.
namespace gonio {

/// @throws Error that states the count, weight or sum (to 1e-9) that is wrong; weights that are not numbers too.
void checkWeights(std::span<const double> weights, std::size_t materials);

/// The material that has all of the weight.
std::optional<std::size_t> wholeWeight(std::span<const double> weights);

}  // namespace gonio
