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

/// One channel of a material: a few coefficients over one dictionary. The index of a coefficient is that of a table:
/// l0 + n0 (l1 + n1 l2) of the atoms of the three modes.
struct ChannelCode {
  int dictionary = 0;
  std::vector<Coefficient<float>> coefficients;  ///< larger in size first
  /// No transformed value is more: the largest of the measurement. A sum of few atoms overshoots where cells count
  /// little, and the inverse of a logarithm makes a cliff of it.
  float highest = std::numeric_limits<float>::max();
};

/// A material as a sparse code over an ensemble: red, green, blue.
struct SparseCode {
  HalfDifferenceGrid grid;
  DataTransform transform = DataTransform::logPlus;
  std::array<ChannelCode, 3> channels;

  /// Of the channel that has most.
  std::size_t coefficients() const;
  /// With at most so many coefficients per channel: the largest.
  SparseCode truncated(std::size_t coefficients) const;
};

}  // namespace gonio::dictionary
