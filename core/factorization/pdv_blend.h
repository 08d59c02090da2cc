// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

/// Between the factors of materials: term by term and curve by curve the weighted mean, on the nodes of the first
/// material (the others are resampled where theirs differ). So a highlight between a narrow and a wide one is one of
/// middle width. Terms behind the first may have any signs: F2 and F3 are turned to those of the first material, F1
/// with them. A material with fewer terms adds nothing to the others' further ones.
/// @param ends one a weight, at least one; @param weights >= 0, sum 1. Where a weight is 1 its end comes back as it is.
/// @throws Error when the transforms or the forms differ.
PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights);

}  // namespace gonio::factorization
