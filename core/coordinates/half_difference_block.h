// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <span>

#include "core/coordinates/half_difference.h"

namespace gonio {

/// Half-difference coordinates of a block of pairs as separate arrays, for vectorised loops over tables.
struct HalfDifferenceBlock {
  static constexpr std::size_t capacity = 64;
  double thetaH[capacity];
  double thetaD[capacity];
  double phiD[capacity];
  std::int64_t valid[capacity];  ///< 1, or 0 where wi = -wo
};

/// Fills the first pairs.size() (<= capacity) entries. Bitwise equal to toHalfDifference() of one pair; about 15 ns per
/// pair.
void toHalfDifference(std::span<const DirectionPair> pairs, HalfDifferenceBlock& block);

}  // namespace gonio
