// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/sampling.h"

#include <array>

namespace gonio {

namespace {

std::uint32_t reverseBits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// Owen scrambling of a number whose bits are reversed: each bit is flipped by a hash of the bits below it.
/// Even multipliers keep that order; the constants are Burley's (2020).
std::uint32_t scrambleReversed(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

/// Bit-reversed second dimension of Sobol's sequence: its generator is Pascal's triangle modulo 2, a Kronecker power
/// of [1 1; 0 1], and so needs one step for each bit of the bit's position.
std::uint32_t sobolSecondReversed(std::uint32_t index) {
  index ^= (index >> 16) & 0x0000ffffu;
  index ^= (index >> 8) & 0x00ff00ffu;
  index ^= (index >> 4) & 0x0f0f0f0fu;
  index ^= (index >> 2) & 0x33333333u;
  index ^= (index >> 1) & 0x55555555u;
  return index;
}

/// Sums of the direction numbers of a dimension over the bits of each byte of an index.
using DirectionSums = std::array<std::array<std::uint32_t, 256>, 4>;

/// The dimension of a primitive polynomial x^degree + ... + 1 (Joe and Kuo 2008, "Constructing Sobol Sequences with
/// Better Two-Dimensional Projections", whose numbers these are).
/// @param inner coefficients between the first and the last one. @param first the first `degree` odd numbers.
constexpr DirectionSums directionSums(std::size_t degree, std::uint32_t inner, std::array<std::uint32_t, 3> first) {
  std::array<std::uint32_t, 32> odd{};
  for (std::size_t i = 0; i < 32; ++i) {
    if (i < degree) {
      odd[i] = first[i];
      continue;
    }
    odd[i] = odd[i - degree] ^ (odd[i - degree] << degree);
    for (std::size_t k = 1; k < degree; ++k)
      if (inner >> (degree - 1 - k) & 1) odd[i] ^= odd[i - k] << k;
  }
  DirectionSums sums{};
  for (std::size_t byte = 0; byte < 4; ++byte)
    for (std::size_t value = 0; value < 256; ++value)
      for (std::size_t bit = 0; bit < 8; ++bit)
        if (value >> bit & 1) sums[byte][value] ^= odd[8 * byte + bit] << (31 - (8 * byte + bit));
  return sums;
}

constexpr DirectionSums thirdSums = directionSums(2, 1, {1, 3}), fourthSums = directionSums(3, 1, {1, 3, 1}),
                        fifthSums = directionSums(3, 2, {1, 1, 1});

std::uint32_t sobolReversed(const DirectionSums& sums, std::uint32_t index) {
  return reverseBits(sums[0][index & 0xff] ^ sums[1][index >> 8 & 0xff] ^ sums[2][index >> 16 & 0xff] ^
                     sums[3][index >> 24]);
}

double unitInterval(std::uint32_t reversed) { return reverseBits(reversed) * 0x1p-32; }

std::uint32_t shuffled(std::uint32_t index, std::uint32_t seed) {
  return reverseBits(scrambleReversed(reverseBits(index), seed));
}

}  // namespace

std::uint32_t hashCombine(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a * 0x9e3779b9u + b + 0x7f4a7c15u;
  for (int round = 0; round < 2; ++round) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    x += b;
  }
  return x;
}

double scrambledVanDerCorput(std::uint32_t index, std::uint32_t seed) { return SobolPoints(seed).first(index); }

glm::dvec2 scrambledSobol(std::uint32_t index, std::uint32_t seed) { return SobolPoints(seed)[index]; }

SobolPoints::SobolPoints(std::uint32_t seed) : seed_(seed) {
  for (std::uint32_t i = 0; i < seeds_.size(); ++i) seeds_[i] = hashCombine(seed, i + 1);
}

glm::dvec2 SobolPoints::operator[](std::uint32_t index) const {
  const std::uint32_t i = shuffled(index, seed_);
  return {unitInterval(scrambleReversed(i, seeds_[0])),
          unitInterval(scrambleReversed(sobolSecondReversed(i), seeds_[1]))};
}

glm::dvec3 SobolPoints::triple(std::uint32_t index) const {
  const std::uint32_t i = shuffled(index, seed_);
  return {unitInterval(scrambleReversed(i, seeds_[0])),
          unitInterval(scrambleReversed(sobolSecondReversed(i), seeds_[1])),
          unitInterval(scrambleReversed(sobolReversed(thirdSums, i), seeds_[2]))};
}

glm::dvec2 SobolPoints::fourthAndFifth(std::uint32_t index) const {
  const std::uint32_t i = shuffled(index, seed_);
  return {unitInterval(scrambleReversed(sobolReversed(fourthSums, i), seeds_[3])),
          unitInterval(scrambleReversed(sobolReversed(fifthSums, i), seeds_[4]))};
}

double SobolPoints::first(std::uint32_t index) const {
  return unitInterval(scrambleReversed(shuffled(index, seed_), seeds_[0]));
}

}  // namespace gonio
