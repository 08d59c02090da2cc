// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

/// @throws Error if transforms or forms differ, so that the factors cannot be blended.
void checkBlendable(std::span<const PdvFactors* const> ends);

/// Blends factors of materials. The first term, which describes the highlight, is blended curve by curve on the nodes
/// of the first material (others are resampled): F2 by its width (core/factorization/width_blend.h), so that a narrow
/// and a wide highlight give one of intermediate width; F1 and F3 as weighted means. Further terms are corrections to
/// the first term of their own material and may cancel one another, so their curves are not mixed but only scaled by
/// the weight of the material. The result has at most maxPdvTerms terms; those of higher index are dropped. @param ends
/// factors of the materials, one per weight, at least one. @param weights >= 0, sum 1. Factors of weight 1 are returned
/// unchanged. @throws Error as checkBlendable().
PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights);

}  // namespace gonio::factorization
