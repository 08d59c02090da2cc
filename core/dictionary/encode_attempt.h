// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <optional>

#include "core/dictionary/encode.h"
#include "core/dictionary/invalid_cells.h"

namespace gonio::dictionary {

/// The three signals of one transform of a material while Encoder refines their coefficients.
template <typename Scalar>
class EncodeAttempt {
 public:
  using Signals = std::array<Eigen::Array<Scalar, Eigen::Dynamic, 1>, 3>;
  using Dictionaries = std::array<const ModeMatrices<Scalar>*, 3>;  ///< of the channels

  /// Chooses the coefficients by one projection. Table, options and dictionaries must outlive this object.
  EncodeAttempt(Signals signals, const TabulatedBrdf& table, const EncodeOptions& options,
                const Dictionaries& dictionaries, const TaskControl& control);
  EncodeAttempt(const EncodeAttempt&) = delete;
  EncodeAttempt& operator=(const EncodeAttempt&) = delete;

  /// As many more rounds.
  void refine(int rounds, const TaskControl& control);
  /// The coefficients of the channels by decreasing absolute value; only as many as EncodeOptions::relativeError needs.
  std::array<std::vector<Coefficient<float>>, 3> coefficients() const;

 private:
  std::vector<Coefficient<float>> coefficients(std::size_t channel) const;
  void refineChannel(std::size_t channel, int rounds, const TaskControl& control);

  const EncodeOptions& options_;
  Signals signals_;  ///< with the values that the rounds give to invalid cells
  std::array<std::optional<InvalidCellRefinement<Scalar>>, 3> cells_;
  std::array<std::vector<Coefficient<Scalar>>, 3> found_;  ///< in no order
  int rounds_ = 0;
};

extern template class EncodeAttempt<float>;
extern template class EncodeAttempt<double>;

}  // namespace gonio::dictionary
