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

/// Any direction, below the horizon too; often nearly horizontal or vertical.
inline Direction hardDirection(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double small = std::pow(10, -17 * uniform(random)), phi = 2 * pi * uniform(random);
  switch (random() % 6) {
    case 0:
      return fromSpherical(halfPi - small, phi);
    case 1:
      return fromSpherical(small, phi);
    case 2:
      return -randomUpper(random);
    default:
      return randomUpper(random);
  }
}

/// Half of the pairs are unrelated; the others are near the mirror direction, or back to the light.
inline DirectionPair hardPair(std::mt19937_64& random) {
  DirectionPair pair{hardDirection(random), hardDirection(random)};
  const double small = std::pow(10, -17 * std::uniform_real_distribution<double>(0, 1)(random));
  const Direction offset = small * randomUpper(random);
  const std::uint64_t kind = random() % 4;
  if (kind == 0) pair.wi = glm::normalize(Direction(-pair.wo.x, -pair.wo.y, pair.wo.z) + offset);
  if (kind == 1) pair.wi = glm::normalize(pair.wo + offset);
  return pair;
}

/// Turned about the normal.
inline Direction rotateZ(const Direction& w, double phi) {
  return {std::cos(phi) * w.x - std::sin(phi) * w.y, std::sin(phi) * w.x + std::cos(phi) * w.y, w.z};
}

}  // namespace gonio::test
