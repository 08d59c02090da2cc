// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string_view>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"

namespace gonio::dictionary {

/// What stands in the invalid cells of a signal. No dictionary may spend coefficients on a cliff at the horizon that is
/// not there.
enum class InvalidFill {
  zero,  ///< the naive one: a cliff wherever a material reflects at the horizon
  hold   ///< along theta_h (toward the horizon) the transformed value of the last valid cell
};

/// cosineWeight() of every cell of a grid, in the order of its indices; 1e-3 beyond the horizon.
Eigen::ArrayXf cosineWeights(const HalfDifferenceGrid& grid);

/// The three channels of a table, transformed, every cell filled: what dictionaries are trained on and what is encoded.
/// In single precision, without cancellation for small values. About 20 ms for a MERL table.
class Signals {
 public:
  using Values = Eigen::ArrayXf;

  /// @param weights cosineWeights() of the table's grid.
  Signals(const TabulatedBrdf& table, DataTransform transform, const Values& weights,
          InvalidFill fill = InvalidFill::hold);

  const Values& channel(int c) const { return channels_[std::size_t(c)]; }
  Values& channel(int c) { return channels_[std::size_t(c)]; }

 private:
  std::array<Values, 3> channels_;
};

/// In place: reflectances (1/sr, >= 0) become transformed values, and back. Back, values that no reflectance has give 0,
/// and those beyond the range of float its largest number (a code of few coefficients may overshoot before expm1).
void transform(Eigen::ArrayXf& values, DataTransform transform, const Eigen::ArrayXf& weights);
void invertTransform(Eigen::ArrayXf& values, DataTransform transform, const Eigen::ArrayXf& weights);

}  // namespace gonio::dictionary
