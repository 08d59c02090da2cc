// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

namespace gonio {

/// e^x = power (1 + rest): with x = k ln 2 + r, |r| <= ln 2 / 2, power is 2^k and rest the Taylor polynomial of e^r
/// - 1.
struct ExpParts {
  double power, rest;
};

/// For -708 <= x <= 709, without branches and calls, so that loops are vectorised. Always inlined, because the compiler
/// would consider it too long.
[[gnu::always_inline]] inline ExpParts expParts(double x) {
  constexpr double shift = 0x1.8p52;  // adding it rounds to an integer, which is then in the last bits
  constexpr double ln2Upper = 0x1.62e42feep-1, ln2Lower = 1.90821492927058770002e-10;
  const double shifted = x * std::numbers::log2e + shift, k = shifted - shift;
  const double r = (x - k * ln2Upper) - k * ln2Lower;
  double series = 1.0 / 479001600;
  series = series * r + 1.0 / 39916800;
  series = series * r + 1.0 / 3628800;
  series = series * r + 1.0 / 362880;
  series = series * r + 1.0 / 40320;
  series = series * r + 1.0 / 5040;
  series = series * r + 1.0 / 720;
  series = series * r + 1.0 / 120;
  series = series * r + 1.0 / 24;
  series = series * r + 1.0 / 6;
  series = series * r + 0.5;
  return {std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023) << 52), r + r * r * series};
}

/// e^x for x <= 709: relative error below 5e-16; 0 below -708, where the result would be subnormal.
[[gnu::always_inline]] inline double fastExp(double x) {
  const bool isZero = x < -708;
  const ExpParts e = expParts(isZero ? -708 : x);
  return isZero ? 0.0 : (1 + e.rest) * e.power;
}

/// e^x - 1 for |x| <= 708, without cancellation: relative error below 2e-15.
[[gnu::always_inline]] inline double fastExpm1(double x) {
  const ExpParts e = expParts(x);
  return e.power * e.rest + (e.power - 1);
}

}  // namespace gonio
