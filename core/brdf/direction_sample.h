// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

/// A sampled direction of light and its density, 1/sr. pdf = 0: the sample failed and contributes nothing.
struct DirectionSample {
  Direction wi{0, 0, 1};
  double pdf = 0;
};

}  // namespace gonio
