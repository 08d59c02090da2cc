// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/models/parameter_spec.h"

namespace gonio::fitting {

/// A parameter as solvers like it: 0 to 1 is its soft range, in the logarithm where the spec says so.
class UnitScale {
 public:
  explicit UnitScale(const models::ParameterSpec& spec);

  double toUnit(double value) const;
  /// Always inside the hard range.
  double toValue(double unit) const;
  /// The hard range in units (that of a logarithm ends some decades below the soft range where the hard one reaches 0).
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

 private:
  bool logarithmic_;
  double hardMin_, hardMax_;
  double origin_, extent_;  ///< of the soft range, in the scale
  double lowest_, highest_;
};

}  // namespace gonio::fitting
