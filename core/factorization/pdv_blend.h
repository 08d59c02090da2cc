// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

/// @throws Error when the transforms or the forms differ, so that there is nothing between them.
void checkBlendable(std::span<const PdvFactors* const> ends);

/// Between the factors of materials. The first term, which describes the highlight, is blended curve by curve: F2 by
/// its width (core/factorization/width_blend.h), so that between a narrow and a wide highlight lies one of middle
/// width, F1 and F3 as weighted means; on the nodes of the first material (the others are resampled where theirs
/// differ). The terms behind it correct what their own first term leaves, fit no other curves and may cancel one
/// another, so they stay as they are and fade with the weight of their material. At most maxPdvTerms in all; of more,
/// those of the lowest index.
/// @param ends one a weight, at least one; @param weights >= 0, sum 1. Where a weight is 1 its end comes back as it is.
/// @throws Error as checkBlendable().
PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights);

}  // namespace gonio::factorization
