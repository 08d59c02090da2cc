// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/sampling.h"

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

SobolPoints::SobolPoints(std::uint32_t seed)
    : seed_(seed), firstSeed_(hashCombine(seed, 1)), secondSeed_(hashCombine(seed, 2)) {}

glm::dvec2 SobolPoints::operator[](std::uint32_t index) const {
  const std::uint32_t i = shuffled(index, seed_);
  return {unitInterval(scrambleReversed(i, firstSeed_)),
          unitInterval(scrambleReversed(sobolSecondReversed(i), secondSeed_))};
}

double SobolPoints::first(std::uint32_t index) const {
  return unitInterval(scrambleReversed(shuffled(index, seed_), firstSeed_));
}

}  // namespace gonio
