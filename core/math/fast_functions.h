// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <bit>
#include <cmath>
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

// Cube root and logarithms without branches and calls, so that loops are vectorised. Always inlined, because the
// compiler would consider them too long.

/// The cube root of a finite number: relative error below 5e-16. Starts with the exponent divided by three, which is
/// within 6 %, followed by Halley and Newton steps.
[[gnu::always_inline]] inline double fastCbrt(double x) {
  // Subnormal numbers have no exponent to divide, and twice a huge number overflows.
  const double size = std::abs(x);
  const bool isTiny = size < 1e-290;
  const bool isHuge = size > 1e290;
  const double a = size * (isTiny ? 0x1p96 : isHuge ? 0x1p-96 : 1.0);
  constexpr double exponentOf1 = 1023.0 * 0x1p20, bestShift = 0.0331 * 0x1p20;  // in units of the upper half's last bit
  const auto upper = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(a) >> 32);
  const auto first = static_cast<std::int32_t>(upper * (1.0 / 3) + (exponentOf1 * 2 / 3 - bestShift));
  double root = std::bit_cast<double>(static_cast<std::uint64_t>(first) << 32);
  double cube = root * root * root;
  root *= (cube + 2 * a) / (2 * cube + a);
  cube = root * root * root;
  root *= (cube + 2 * a) / (2 * cube + a);
  root -= (root - a / (root * root)) * (1.0 / 3);
  root *= isTiny ? 0x1p-32 : isHuge ? 0x1p32 : 1.0;
  return std::copysign(size > 0 ? root : 0.0, x);
}

/// ln(u) + correction for finite u > 0 that is not subnormal. With u = 2^k m, m in [sqrt(1/2), sqrt(2)), it is k ln 2 +
/// 2 artanh((m - 1) / (m + 1)).
[[gnu::always_inline]] inline double logWithCorrection(double u, double correction) {
  // The exponent increases by one at sqrt(2).
  constexpr std::uint64_t one = 0x3ff0000000000000, rootHalf = 0x3fe6a09e667f3bcd;
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(u) + (one - rootHalf);
  const double m = std::bit_cast<double>((shifted & 0x000fffffffffffff) + rootHalf);
  // An integer below 2^52 in the mantissa of 2^52 needs no conversion to double, which not every processor supports for
  // vectors.
  const double k = std::bit_cast<double>((shifted >> 52) | 0x4330000000000000) - (0x1p52 + 1023);
  const double f = m - 1, s = f / (f + 2), z = s * s, half = 0.5 * f * f;
  double series = 1.0 / 21;
  series = series * z + 1.0 / 19;
  series = series * z + 1.0 / 17;
  series = series * z + 1.0 / 15;
  series = series * z + 1.0 / 13;
  series = series * z + 1.0 / 11;
  series = series * z + 1.0 / 9;
  series = series * z + 1.0 / 7;
  series = series * z + 1.0 / 5;
  series = series * z + 1.0 / 3;
  // 2 s = f - half + s half, without the rounding of s; k ln 2 in two parts, the first of them exact.
  constexpr double ln2Upper = 0x1.62e42feep-1, ln2Lower = std::numbers::ln2 - ln2Upper;
  const double small = s * (half + 2 * z * series) + (k * ln2Lower + correction);
  return k * ln2Upper - ((half - small) - f);
}

/// ln x for finite x > 0 that is not subnormal (from 2.3e-308 on): relative error below 5e-16.
[[gnu::always_inline]] inline double fastLog(double x) { return logWithCorrection(x, 0); }

/// ln(1 + x) for finite x > -1: relative error below 5e-16. The correction is for the rounding of 1 + x.
[[gnu::always_inline]] inline double fastLog1p(double x) {
  const double u = 1 + x;
  const double ofSmall = x - (u - 1), ofLarge = 1 - (u - x), rounded = x < 1 ? ofSmall : ofLarge;
  return logWithCorrection(u, rounded / u);
}

/// atan2(y, x) of finite numbers, without branches and calls, so that loops are vectorised. Absolute error below 1e-15,
/// relative error below 4e-16 for results near 0. x = 0 counts as positive: (0, 0) gives 0. The arc tangent is a
/// polynomial on |t| <= tan(pi/8) (Chebyshev interpolation of degree 10 in t^2, error 5e-18).
inline double fastAtan2(double y, double x) {
  const double absX = std::abs(x), absY = std::abs(y);
  const double large = absX > absY ? absX : absY, small = absX > absY ? absY : absX;
  constexpr double tanEighth = std::numbers::sqrt2 - 1;
  const bool upper = small > tanEighth * large;
  const double denominator = upper ? small + large : large;
  const double t = (upper ? small - large : small) / (denominator > 0 ? denominator : 1.0);
  const double z = t * t;
  double p = -0.019176885636589053;
  p = p * z + 0.039231657085083686;
  p = p * z - 0.050854496960392584;
  p = p * z + 0.05858148904795124;
  p = p * z - 0.0666451144646022;
  p = p * z + 0.07692183190760651;
  p = p * z - 0.09090904578121085;
  p = p * z + 0.11111111015256292;
  p = p * z - 0.14285714284666542;
  p = p * z + 0.1999999999999552;
  p = p * z - 0.3333333333333333;
  constexpr double quarter = std::numbers::pi / 4, half = std::numbers::pi / 2;
  double angle = (upper ? quarter : 0.0) + (t + t * (z * p));
  angle = absY > absX ? half - angle : angle;
  angle = x < 0 ? std::numbers::pi - angle : angle;
  return std::copysign(angle, y);
}

struct SineAndCosine {
  double sine, cosine;
};

/// Sine and cosine of 2 pi `turns`, |turns| < 1e6, without branches and calls, so that loops are vectorised: absolute
/// error below 4e-16. Quarter turns are exact. The rest of the nearest quarter turn is at most pi/4, for which Taylor
/// polynomials of degree 15 and 16 have errors below 1e-16.
[[gnu::always_inline]] inline SineAndCosine fastSineAndCosine(double turns) {
  constexpr double shift = 0x1.8p52;  // adding it rounds to an integer, which is then in the last bits
  const double shifted = 4 * turns + shift;
  const std::uint64_t quarter = std::bit_cast<std::uint64_t>(shifted);
  const double x = (4 * turns - (shifted - shift)) * (std::numbers::pi / 2), z = x * x;
  double s = -1.0 / 1307674368000;
  s = s * z + 1.0 / 6227020800;
  s = s * z - 1.0 / 39916800;
  s = s * z + 1.0 / 362880;
  s = s * z - 1.0 / 5040;
  s = s * z + 1.0 / 120;
  s = s * z - 1.0 / 6;
  double c = 1.0 / 20922789888000;
  c = c * z - 1.0 / 87178291200;
  c = c * z + 1.0 / 479001600;
  c = c * z - 1.0 / 3628800;
  c = c * z + 1.0 / 40320;
  c = c * z - 1.0 / 720;
  c = c * z + 1.0 / 24;
  const double sine = x + x * (z * s), cosine = 1 - z * (0.5 - z * c);
  const bool isOdd = (quarter & 1) != 0;
  const double across = isOdd ? cosine : sine, along = isOdd ? sine : cosine;
  // The sine is negative in the quadrants 2 and 3, the cosine in 1 and 2.
  const auto flipped = [](double value, std::uint64_t quadrants) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ ((quadrants & 2) << 62));
  };
  return {flipped(across, quarter), flipped(along, quarter + 1)};
}

}  // namespace gonio
