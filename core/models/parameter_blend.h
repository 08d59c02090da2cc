// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/models/model.h"

namespace gonio::models {

/// Between the parameters of one model: weighted means, geometric ones of parameters of a logarithmic scale where all
/// are positive, as a slider would stand. Choices must agree.
/// @param ends one a weight; @param weights >= 0, sum 1. Where a weight is 1 its end comes back bit for bit.
/// @throws Error naming a choice that differs.
ParameterValues blended(const ModelSpec& spec, std::span<const ParameterValues> ends, std::span<const double> weights);

}  // namespace gonio::models
