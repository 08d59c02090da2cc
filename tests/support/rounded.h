// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/types.h"

namespace gonio::test {

/// A unit vector as a shader gets it: rounded to float. Through memory, since GCC 12 leaves out the rounding of two
/// numbers that it converts to float and back as a vector.
inline Direction rounded(const Direction& w) {
  const volatile float x = float(w.x), y = float(w.y), z = float(w.z);
  return {x, y, z};
}

}  // namespace gonio::test
