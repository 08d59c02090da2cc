// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <random>

#include "core/math/types.h"

namespace gonio::test {

/// Even over the solid angle of the upper hemisphere.
inline Direction randomUpper(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double z = uniform(random);
  return fromSpherical(std::acos(z), 2 * pi * uniform(random));
}

/// Turned about the normal.
inline Direction rotateZ(const Direction& w, double phi) {
  return {std::cos(phi) * w.x - std::sin(phi) * w.y, std::sin(phi) * w.x + std::cos(phi) * w.y, w.z};
}

}  // namespace gonio::test
