// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/dictionary/dictionary.h"
#include "core/dictionary/largest_coefficients.h"

namespace gonio::dictionary {

/// One channel of a material: a few coefficients over one dictionary. Like a cell of a table, the coefficient of the
/// atoms l0, l1, l2 of the three modes has the index l0 + n0 (l1 + n1 l2), with n the sizes of the modes.
struct ChannelCode {
  int dictionary = 0;
  std::vector<Coefficient<float>> coefficients;  ///< by decreasing absolute value
  /// Upper bound of the transformed values: the largest of the measurement. A sum of few atoms overshoots in cells with
  /// a small factor of cell scaling, and the inverse of the logarithm would amplify that.
  float highest = std::numeric_limits<float>::max();
  float step = 0;  ///< of which all values are multiples (quantised()); 0: not quantised
};

/// A material as a sparse code over an ensemble: red, green, blue.
struct SparseCode {
  HalfDifferenceGrid grid;
  DataTransform transform = DataTransform::logPlus;
  bool scaled = true;  ///< whether it represents signals with cell scaling (GridGeometry::cellScaling)
  std::array<ChannelCode, 3> channels;

  /// The largest number of coefficients of a channel.
  std::size_t coefficients() const;
  /// The code with only the largest `coefficients` of each channel.
  SparseCode truncated(std::size_t coefficients) const;
};

}  // namespace gonio::dictionary
