// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// A direction sampled from a density, with the density in 1/sr. pdf = 0 marks a sample that failed (contributes
/// nothing).
struct DirectionSample {
  Direction wi{0, 0, 1};
  double pdf = 0;
};

}  // namespace gonio
