// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/models/model.h"

namespace gonio::models {

/// Blends parameters of one model: weighted means; geometric means for parameters with a logarithmic scale if all
/// values are positive. Choices must be equal. @param ends parameters of the materials, one per weight. @param weights
/// >= 0, sum 1. Parameters of weight 1 are returned bitwise unchanged. @throws Error that names a choice which differs.
ParameterValues blended(const ModelSpec& spec, std::span<const ParameterValues> ends, std::span<const double> weights);

}  // namespace gonio::models
