// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// Weights of blended materials: one per material, each in [0, 1], with sum 1.
namespace gonio {

/// @throws Error that states the wrong number of weights, weight (also NaN) or sum (tolerance 1e-9).
void checkWeights(std::span<const double> weights, std::size_t materials);

/// The index of the material of weight 1, if any.
std::optional<std::size_t> indexOfFullWeight(std::span<const double> weights);

}  // namespace gonio
