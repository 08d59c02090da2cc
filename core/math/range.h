// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gonio {

/// A set of numbers by its bounds, for interval arithmetic (Moore 1966, Interval Analysis): the result of an operation
/// contains the results for all operands in the sets. Bounds are computed in double precision without directed
/// rounding; who needs a strict bound widens the result by more than the rounding errors (a few units in the last
/// place per operation).
struct Range {
  double low = 0, high = 0;

  constexpr Range() = default;
  constexpr Range(double value) : low(value), high(value) {}  // NOLINT: numbers are ranges
  constexpr Range(double lowest, double highest) : low(lowest), high(highest) {}

  static constexpr Range all() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  double width() const { return high - low; }
  bool contains(double value) const { return low <= value && value <= high; }

  friend Range operator-(const Range& a) { return {-a.high, -a.low}; }
  friend Range operator+(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
  friend Range operator-(const Range& a, const Range& b) { return {a.low - b.high, a.high - b.low}; }
  /// An object times itself is its square, which is not negative.
  friend Range operator*(const Range& a, const Range& b) {
    if (&a == &b) return square(a);
    if (a.low >= 0 && b.low >= 0) return {product(a.low, b.low), product(a.high, b.high)};
    const double p = product(a.low, b.low), q = product(a.low, b.high), r = product(a.high, b.low),
                 s = product(a.high, b.high);
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
  }
  friend Range operator/(const Range& a, const Range& b) {
    if (b.low > 0 || b.high < 0) return a * Range(1 / b.high, 1 / b.low);
    if (a.low == 0 && a.high == 0) return {0, 0};
    if (b.low == 0 && b.high > 0) return a * Range(1 / b.high, std::numeric_limits<double>::infinity());
    return all();
  }
  Range& operator+=(const Range& other) { return *this = *this + other; }
  Range& operator*=(const Range& other) { return *this = *this * other; }

  friend Range square(const Range& a) {
    const double p = product(a.low, a.low), q = product(a.high, a.high);
    return {a.contains(0) ? 0 : std::min(p, q), std::max(p, q)};
  }
  friend Range sqrt(const Range& a) { return {std::sqrt(std::max(0.0, a.low)), std::sqrt(std::max(0.0, a.high))}; }
  friend Range min(const Range& a, const Range& b) { return {std::min(a.low, b.low), std::min(a.high, b.high)}; }
  friend Range max(const Range& a, const Range& b) { return {std::max(a.low, b.low), std::max(a.high, b.high)}; }
  friend Range hull(const Range& a, const Range& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
  friend Range abs(const Range& a) {
    const double p = std::abs(a.low), q = std::abs(a.high);
    return {a.contains(0) ? 0 : std::min(p, q), std::max(p, q)};
  }

 private:
  /// 0 times infinity is 0: an infinite bound stands for numbers.
  static constexpr double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }
};

/// An increasing function of all numbers of a range.
template <typename Function>
Range increasing(const Range& a, const Function& function) {
  return {function(a.low), function(a.high)};
}

/// Cosines of all angles of a range, rad.
inline Range cosine(const Range& angle) {
  constexpr double halfTurn = 3.141592653589793;
  const double p = std::cos(angle.low), q = std::cos(angle.high);
  // Multiples of half a turn in the range: even ones give 1, odd ones -1.
  const double first = std::ceil(angle.low / halfTurn), last = std::floor(angle.high / halfTurn);
  const bool some = last >= first, more = last > first, firstIsEven = std::fmod(std::abs(first), 2) == 0;
  return {(some && !firstIsEven) || more ? -1 : std::min(p, q), (some && firstIsEven) || more ? 1 : std::max(p, q)};
}
/// Sines of all angles of a range, rad.
inline Range sine(const Range& angle) { return cosine(angle - Range(1.5707963267948966)); }

/// Comparisons of ranges that neither is always true nor always false. overBranches() tries both answers.
struct RangeBranches {
  std::uint32_t answers = 0;
  int asked = 0;

  static RangeBranches*& current() {
    thread_local RangeBranches* branches = nullptr;
    return branches;
  }
  static bool undecided() {
    RangeBranches* branches = current();
    return branches && branches->asked < 32 ? (branches->answers >> branches->asked++ & 1) != 0 : false;
  }
};

inline bool operator<(const Range& a, const Range& b) {
  if (a.high < b.low) return true;
  return a.low >= b.high ? false : RangeBranches::undecided();
}
inline bool operator==(const Range& a, const Range& b) {
  if (a.low > b.high || a.high < b.low) return false;
  return a.low == a.high && b.low == b.high ? true : RangeBranches::undecided();
}
inline bool operator>(const Range& a, const Range& b) { return b < a; }

/// Calls evaluate() once for each sequence of answers to its comparisons, and use(result) for each result. Returns
/// false if there are more than 64: the results then do not cover all cases.
template <typename Evaluate, typename Use>
bool overBranches(const Evaluate& evaluate, const Use& use) {
  constexpr int most = 64;
  RangeBranches branches;
  RangeBranches* const outer = RangeBranches::current();
  RangeBranches::current() = &branches;
  bool complete = false;
  for (int run = 0; run < most && !complete; ++run) {
    branches.asked = 0;
    use(evaluate());
    // The next sequence: the last answer that was no becomes yes, later ones are asked again.
    int last = branches.asked - 1;
    while (last >= 0 && (branches.answers >> last & 1) != 0) --last;
    complete = last < 0;
    if (!complete) branches.answers = (branches.answers & ((1u << last) - 1)) | 1u << last;
  }
  RangeBranches::current() = outer;
  return complete;
}

}  // namespace gonio
