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

/// The largest coefficients among blocks that come one after the other, in any order, with a threshold that rises: most
/// values are compared once.
template <typename Scalar>
class LargestCoefficients {
 public:
  /// @param kept the result, in no order; its memory is used again. @param count at most so many.
  LargestCoefficients(std::vector<Coefficient<Scalar>>& kept, std::size_t count) : kept_(kept), count_(count) {
    kept_.clear();
  }

  /// What is smaller in size is not among the largest.
  Scalar threshold() const { return threshold_; }

  /// Values with consecutive indices. Zeros are left out.
  void add(std::span<const Scalar> values, std::size_t firstIndex) {
    if (count_ == 0) return;
    constexpr std::size_t stretch = 32;
    for (std::size_t begin = 0; begin < values.size(); begin += stretch) {
      const std::size_t end = std::min(begin + stretch, values.size());
      Scalar highest = 0;
      for (std::size_t i = begin; i < end; ++i) highest = std::max(highest, std::abs(values[i]));
      if (!(highest > 0 && highest >= threshold_)) continue;
      for (std::size_t i = begin; i < end; ++i)
        if (values[i] != 0 && std::abs(values[i]) >= threshold_)
          kept_.push_back({std::uint32_t(firstIndex + i), values[i]});
      if (kept_.size() >= 2 * count_ + 64) prune();
    }
  }
  /// To be called after the last block.
  void prune() {
    if (kept_.size() <= count_) return;
    if (count_ > 0) {
      std::nth_element(kept_.begin(), kept_.begin() + std::ptrdiff_t(count_ - 1), kept_.end(), isLarger<Scalar>);
      threshold_ = std::abs(kept_[count_ - 1].value);
    }
    kept_.resize(count_);
  }

 private:
  std::vector<Coefficient<Scalar>>& kept_;
  std::size_t count_;
  Scalar threshold_ = 0;
};

/// The at most `count` largest entries in size other than 0, in no order: the hard threshold, the exact minimiser of
/// the error at that many coefficients where the dictionary is orthonormal.
/// @param kept the result; its memory is used again.
template <typename Scalar>
void keepLargest(std::span<const Scalar> values, std::size_t count, std::vector<Coefficient<Scalar>>& kept) {
  LargestCoefficients<Scalar> largest(kept, count);
  largest.add(values, 0);
  largest.prune();
}

/// Sum of the squares, in double.
template <typename Scalar>
double energy(std::span<const Coefficient<Scalar>> coefficients) {
  double sum = 0;
  for (const Coefficient<Scalar>& c : coefficients) sum += double(c.value) * double(c.value);
  return sum;
}

}  // namespace gonio::dictionary
