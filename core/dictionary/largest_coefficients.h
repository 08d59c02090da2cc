// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::dictionary {

/// A number of a block and where it stands.
template <typename Scalar>
struct Coefficient {
  std::uint32_t index = 0;
  Scalar value = 0;
};

/// Larger in size first; among equals the lower index, so that the choice never depends on the order of work.
template <typename Scalar>
bool isLarger(const Coefficient<Scalar>& a, const Coefficient<Scalar>& b) {
  const Scalar sizeA = std::abs(a.value), sizeB = std::abs(b.value);
  return sizeA > sizeB || (sizeA == sizeB && a.index < b.index);
}

/// The at most `count` largest entries in size other than 0, in no order: the hard threshold, the exact minimiser of
/// the error at that many coefficients where the dictionary is orthonormal. One pass over the values with a rising
/// threshold: most of them are compared once.
/// @param kept the result; its memory is used again.
template <typename Scalar>
void keepLargest(std::span<const Scalar> values, std::size_t count, std::vector<Coefficient<Scalar>>& kept) {
  kept.clear();
  if (count == 0) return;
  const std::size_t room = 2 * count + 64;
  Scalar threshold = 0;
  const auto prune = [&] {
    if (kept.size() <= count) return;
    std::nth_element(kept.begin(), kept.begin() + std::ptrdiff_t(count - 1), kept.end(), isLarger<Scalar>);
    kept.resize(count);
    threshold = std::abs(kept.back().value);
  };
  constexpr std::size_t stretch = 32;
  for (std::size_t begin = 0; begin < values.size(); begin += stretch) {
    const std::size_t end = std::min(begin + stretch, values.size());
    Scalar highest = 0;
    for (std::size_t i = begin; i < end; ++i) highest = std::max(highest, std::abs(values[i]));
    if (!(highest > threshold)) continue;
    for (std::size_t i = begin; i < end; ++i)
      if (std::abs(values[i]) > threshold) kept.push_back({std::uint32_t(i), values[i]});
    if (kept.size() >= room) prune();
  }
  prune();
}

/// Sum of the squares, in double.
template <typename Scalar>
double energy(std::span<const Coefficient<Scalar>> coefficients) {
  double sum = 0;
  for (const Coefficient<Scalar>& c : coefficients) sum += double(c.value) * double(c.value);
  return sum;
}

}  // namespace gonio::dictionary
