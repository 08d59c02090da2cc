// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dictionary/largest_projections.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// A range of consecutive rows (modes 0 and 1 flattened) and slices (mode 2) of a block that contains invalid cells. In
/// a half-difference table about a third of all cells are invalid: large theta_h lie below the horizon.
struct InvalidBand {
  Eigen::Index firstRow, rows, firstSlice, slices;
};
/// Bands that together contain all invalid cells. @param valid one flag per cell of a block of `sizes`.
std::vector<InvalidBand> invalidBands(std::span<const std::uint8_t> valid, const Sizes& sizes);

/// Refinement rounds of Encoder::encode() for one signal and one dictionary: the invalid cells of the signal take the
/// values of its code. Incremental: each round projects only the change of the bands onto the atoms of mode 2.
template <typename Scalar>
class InvalidCellRefinement {
 public:
  /// @param signal of `sizes`; update() changes its invalid cells. Signal, flags and matrices must outlive this object.
  InvalidCellRefinement(Eigen::Array<Scalar, Eigen::Dynamic, 1>& signal, std::span<const std::uint8_t> valid,
                        const Sizes& sizes, const ModeMatrices<Scalar>& matrices);

  /// The `count` largest coefficients of the signal, in no particular order.
  void selectLargest(std::size_t count, std::vector<Coefficient<Scalar>>& selected) const;
  /// Sets the values of a code to the projections of the signal on its atoms. For a MERL table, 16,200
  /// multiplications per distinct pair of atoms of modes 1 and 2.
  void project(std::vector<Coefficient<Scalar>>& code) const;
  /// Resets the momentum: the next round starts without it.
  void restart() { decoded_.clear(); }
  /// Sets the invalid cells to the values of `code`, plus `momentum` times their change since the last round.
  void update(const std::vector<Coefficient<Scalar>>& code, Scalar momentum);

 private:
  Scalar* signal_;
  std::span<const std::uint8_t> valid_;
  Sizes sizes_;
  const ModeMatrices<Scalar>& matrices_;
  std::vector<InvalidBand> bands_;
  std::vector<Matrix<Scalar>> decoded_;  ///< values of the last round, one matrix per band; empty before the first
  BlockStorage<Scalar> slices_;          ///< the signal projected onto the atoms of mode 2
};

extern template class InvalidCellRefinement<float>;
extern template class InvalidCellRefinement<double>;

}  // namespace gonio::dictionary
