// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::metrics {

/// One test of physical plausibility. `worst` is the largest violation in the unit that the check's name implies
/// (relative difference, albedo, 1/sr); `where` tells the directions in degrees for people.
struct PlausibilityCheck {
  std::string name;  ///< "reciprocity", "energy", "negative", "non-finite"
  bool passed = true;
  double worst = 0;
  std::string where = {};
};

/// Reciprocity |f(i,o) - f(o,i)| <= 2 % of the larger value's scale, albedo <= 1 + 1 % at 0..85 degrees, no negative
/// and no non-finite values, over a fixed deterministic set of directions. Some 100 ms.
std::vector<PlausibilityCheck> checkPlausibility(const Brdf& brdf);

}  // namespace gonio::metrics
