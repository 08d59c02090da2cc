// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/models/parameter_spec.h"

namespace gonio::fitting {

/// Scales a parameter for solvers: its soft range becomes [0, 1], logarithmically if the spec says so.
class UnitScale {
 public:
  explicit UnitScale(const models::ParameterSpec& spec);

  double toUnit(double value) const;
  /// Always inside the hard range.
  double toValue(double unit) const;
  /// The hard range in units. For a logarithmic scale with a hard minimum of 0 it ends some decades below the soft
  /// range.
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }

 private:
  bool logarithmic_;
  double hardMin_, hardMax_;
  double origin_, extent_;  ///< of the soft range, on the linear or logarithmic scale
  double minimum_, maximum_;
};

}  // namespace gonio::fitting
