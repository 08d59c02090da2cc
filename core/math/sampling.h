// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/math/types.h"

namespace gonio {

/// Inverts the integral of the linear function from `low` at 0 to `high` at 1, both >= 0, without cancellation: the
/// point t in [0, 1] with low t + (high - low) t^2 / 2 = area. 0 if both are 0.
inline double inverseOfRamp(double low, double high, double area) {
  const double root = std::sqrt(std::max(0.0, low * low + 2 * area * (high - low)));
  const double sum = low + root;
  return sum > 0 ? std::clamp(2 * area / sum, 0.0, 1.0) : 0;
}

/// A well-mixed hash of two numbers, for counter-based seeds (pixel, dimension) without state.
std::uint32_t hashCombine(std::uint32_t a, std::uint32_t b);

/// Point `index` of the van der Corput sequence in base 2 with Owen's nested uniform scrambling and shuffling, in [0,
/// 1). Burley 2020, "Practical Hash-based Owen Scrambling". O(1).
double scrambledVanDerCorput(std::uint32_t index, std::uint32_t seed);

/// Point `index` of the first two dimensions of Sobol's sequence, scrambled and shuffled as above, in [0, 1)^2: any 2^k
/// points that start at a multiple of 2^k have exactly one point in each elementary interval (dyadic rectangle) of area
/// 2^-k.
/// Different seeds give independent point sets. O(1).
glm::dvec2 scrambledSobol(std::uint32_t index, std::uint32_t seed);

/// scrambledSobol() for many points of one seed: computes the seed-dependent part once.
class SobolPoints {
 public:
  explicit SobolPoints(std::uint32_t seed);
  glm::dvec2 operator[](std::uint32_t index) const;
  /// The same point with the third dimension of Sobol's sequence: points whose third number is in a dyadic interval are
  /// themselves well spread in the first two, as for a choice between densities.
  glm::dvec3 triple(std::uint32_t index) const;
  /// The fourth and the fifth dimension of the same point, less well spread.
  glm::dvec2 fourthAndFifth(std::uint32_t index) const;
  /// The first coordinate of the point: scrambledVanDerCorput() of the seed.
  double first(std::uint32_t index) const;

 private:
  std::uint32_t seed_;
  std::array<std::uint32_t, 5> seeds_;  ///< of the dimensions
};

}  // namespace gonio
