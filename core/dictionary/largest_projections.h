// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dictionary/mode_products.h"

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

/// Reduces the coefficients of a signal of several parts over the same dictionary to the `count` largest of all parts
/// together; those of one part stay as they are. @param parts lists of at most `count` coefficients each.
void keepLargest(std::span<std::vector<Coefficient<double>>> parts, std::size_t count);

/// Sum of squares, in double.
template <typename Scalar>
double energy(std::span<const Coefficient<Scalar>> coefficients) {
  double sum = 0;
  for (const Coefficient<Scalar>& c : coefficients) sum += double(c.value) * double(c.value);
  return sum;
}

/// Adds X_(mode) (S x_p U_p x_q U_q)_(mode)^T of a signal X with coefficients S to `z`, where p and q are the two other
/// modes: the matrix from which orthogonalProcrustes() computes the dictionary's matrix of `mode`. Projects the signal
/// only onto the atoms that have coefficients: for few coefficients much faster than the projection onto all.
/// @param block X of `sizes`, the first index fastest. @param matrices U, one per mode, sizes[mode] rows.
/// @param coefficients their indices are those of a block with as many entries in each mode as the matrix of that mode
/// has columns. @param z sizes[mode] x columns.
void addCorrelation(const double* block, const Sizes& sizes, const ModeMatrices<double>& matrices, int mode,
                    std::span<const Coefficient<double>> coefficients, Workspace<double>& workspace,
                    Eigen::MatrixXd& z);

/// A signal as a small block: its own truncated higher-order SVD (De Lathauwer et al. 2000, "A Multilinear Singular
/// Value Decomposition"). Projections of the block onto dictionaries cost a fraction of those of the signal.
template <typename Scalar>
struct CompactSignal {
  ModeMatrices<Scalar> bases;  ///< one per mode: size of the mode x rank, columns orthonormal
  Sizes ranks{};
  BlockStorage<Scalar> block;  ///< of `ranks`, the first index fastest
  double energy = 0;           ///< sum of squares of the whole signal

  /// The dictionary in the coordinates of the bases: bases^T `dictionary` in each mode. Projecting the block onto it
  /// gives the projection of the signal onto `dictionary`. @param dictionary one matrix per mode, size of the mode x
  /// atoms.
  ModeMatrices<Scalar> inBases(const ModeMatrices<Scalar>& dictionary) const;
  /// The `count` largest coefficients over a dictionary (selectLargestProjections()), without what the block
  /// omits.
  void selectLargest(const ModeMatrices<Scalar>& dictionary, std::size_t count, Workspace<Scalar>& workspace,
                     std::vector<Coefficient<Scalar>>& selected) const;
};

/// @param signal of `sizes`, the first index fastest. @param maxLoss maximum fraction of the signal's energy that
/// the block omits.
template <typename Scalar>
CompactSignal<Scalar> compactSignal(const Scalar* signal, const Sizes& sizes, double maxLoss);

extern template struct CompactSignal<float>;
extern template struct CompactSignal<double>;
extern template CompactSignal<float> compactSignal(const float*, const Sizes&, double);
extern template CompactSignal<double> compactSignal(const double*, const Sizes&, double);

/// selectLargest() of transposedModeProducts(): the largest coefficients of a signal over a dictionary, without
/// computing those that cannot be among them. No coefficient exceeds the norm of the fibre or slice that it is
/// projected from, so the last and most expensive product is computed for few fibres only.
/// @param signal of `sizes`, the first index fastest. @param matrices one per mode, sizes[mode] rows, columns of norm
/// at most 1. @param selected the result, in no particular order; its memory is reused.
/// Takes half the time of the full projection for materials at 262 coefficients.
template <typename Scalar>
void selectLargestProjections(const Scalar* signal, const Sizes& sizes, const ModeMatrices<Scalar>& matrices,
                              std::size_t count, Workspace<Scalar>& workspace,
                              std::vector<Coefficient<Scalar>>& selected);

/// The same for a signal that is already projected onto the atoms of mode 2. @param projected2 sizes[0] x sizes[1] x
/// matrices[2].cols() numbers, the first index fastest.
template <typename Scalar>
void selectLargestOfSlices(const Scalar* projected2, const Sizes& sizes, const ModeMatrices<Scalar>& matrices,
                           std::size_t count, std::vector<Coefficient<Scalar>>& selected);

extern template void selectLargestProjections(const float*, const Sizes&, const ModeMatrices<float>&, std::size_t,
                                              Workspace<float>&, std::vector<Coefficient<float>>&);
extern template void selectLargestProjections(const double*, const Sizes&, const ModeMatrices<double>&, std::size_t,
                                              Workspace<double>&, std::vector<Coefficient<double>>&);
extern template void selectLargestOfSlices(const float*, const Sizes&, const ModeMatrices<float>&, std::size_t,
                                           std::vector<Coefficient<float>>&);
extern template void selectLargestOfSlices(const double*, const Sizes&, const ModeMatrices<double>&, std::size_t,
                                           std::vector<Coefficient<double>>&);

}  // namespace gonio::dictionary
