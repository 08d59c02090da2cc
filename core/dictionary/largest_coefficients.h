// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::dictionary {

/// An entry of a block and its index.
template <typename Scalar>
struct Coefficient {
  std::uint32_t index = 0;
  Scalar value = 0;
};

/// The coefficients with values rounded to the precision of Scalar.
template <typename Scalar, typename From>
std::vector<Coefficient<Scalar>> coefficientsIn(const std::vector<Coefficient<From>>& coefficients) {
  std::vector<Coefficient<Scalar>> result;
  result.reserve(coefficients.size());
  for (const Coefficient<From>& c : coefficients) result.push_back({c.index, Scalar(c.value)});
  return result;
}

/// Orders by decreasing absolute value, then by index, so that a selection does not depend on the order of computation.
template <typename Scalar>
bool isLarger(const Coefficient<Scalar>& a, const Coefficient<Scalar>& b) {
  const Scalar sizeA = std::abs(a.value), sizeB = std::abs(b.value);
  return sizeA > sizeB || (sizeA == sizeB && a.index < b.index);
}

/// Selects the largest coefficients of blocks that are added one after another, in any order. A rising threshold
/// rejects most values after one comparison.
template <typename Scalar>
class LargestCoefficients {
 public:
  /// @param selected the result, in no particular order; its memory is reused. @param count maximum number of
  /// coefficients.
  LargestCoefficients(std::vector<Coefficient<Scalar>>& selected, std::size_t count)
      : selected_(selected), count_(count) {
    selected_.clear();
  }

  /// Values of smaller absolute value are not among the largest.
  Scalar threshold() const { return threshold_; }

  /// Adds values with consecutive indices; zeros are skipped.
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
          selected_.push_back({std::uint32_t(firstIndex + i), values[i]});
      if (selected_.size() >= 2 * count_ + 64) prune();
    }
  }
  /// Reduces the result to `count`. Call it after the last block.
  void prune() {
    if (selected_.size() <= count_) return;
    if (count_ > 0) {
      std::nth_element(selected_.begin(), selected_.begin() + std::ptrdiff_t(count_ - 1), selected_.end(),
                       isLarger<Scalar>);
      threshold_ = std::abs(selected_[count_ - 1].value);
    }
    selected_.resize(count_);
  }

 private:
  std::vector<Coefficient<Scalar>>& selected_;
  std::size_t count_;
  Scalar threshold_ = 0;
};

/// Hard thresholding: the `count` entries of largest absolute value, without zeros, in no particular order. They
/// minimise the error with that many coefficients if the dictionary is orthonormal. @param selected the result; its
/// memory is reused.
template <typename Scalar>
void selectLargest(std::span<const Scalar> values, std::size_t count, std::vector<Coefficient<Scalar>>& selected) {
  LargestCoefficients<Scalar> largest(selected, count);
  largest.add(values, 0);
  largest.prune();
}

/// Sum of squares, in double.
template <typename Scalar>
double energy(std::span<const Coefficient<Scalar>> coefficients) {
  double sum = 0;
  for (const Coefficient<Scalar>& c : coefficients) sum += double(c.value) * double(c.value);
  return sum;
}

}  // namespace gonio::dictionary
