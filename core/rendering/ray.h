// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio {

struct Ray {
  Direction origin, direction;  ///< world, `direction` unit
};

}  // namespace gonio
