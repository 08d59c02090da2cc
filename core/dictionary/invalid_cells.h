// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// A part of a block that holds invalid cells: neighbouring rows of modes 0 and 1, in the slices of mode 2 from one on.
/// In a half-difference table they are about a third of all cells: the horizon cuts off large theta_h.
struct InvalidBand {
  Eigen::Index firstRow, rows, firstSlice, slices;
};
/// Bands that together hold all invalid cells. @param valid one flag per cell, of `sizes`.
std::vector<InvalidBand> invalidBands(std::span<const std::uint8_t> valid, const Sizes& sizes);

/// One signal over one dictionary, whose invalid cells take the values of its code, round after round. What stays the
/// same between rounds is not computed again: only the change of the bands is projected onto the atoms of mode 2.
class InvalidCellRounds {
 public:
  /// @param signal of `sizes`, changed by the rounds in the invalid cells. It, the flags and the matrices must outlive
  /// this object.
  InvalidCellRounds(Eigen::ArrayXf& signal, std::span<const std::uint8_t> valid, const Sizes& sizes,
                    const ModeMatrices<float>& matrices);

  /// The signal's `count` largest coefficients, in no order.
  void keepLargest(std::size_t count, std::vector<Coefficient<float>>& kept) const;
  /// The invalid cells take the values that `code` gives them, and `momentum` times their change since the last round.
  void update(const std::vector<Coefficient<float>>& code, float momentum);

 private:
  float* signal_;
  std::span<const std::uint8_t> valid_;
  Sizes sizes_;
  const ModeMatrices<float>& matrices_;
  std::vector<InvalidBand> bands_;
  std::vector<Eigen::MatrixXf> decoded_;  ///< one per band, of the last round; empty before the first
  std::vector<float> slices_;             ///< the signal projected onto the atoms of mode 2
};

}  // namespace gonio::dictionary
