// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/math/types.h"

namespace gonio::test {

/// Random pairs with both directions at least 1.1 degrees above the horizon; the cosines are uniform.
inline std::vector<DirectionPair> pairs(int count, int seed = 1) {
  std::mt19937_64 random{std::uint64_t(seed)};
  std::uniform_real_distribution<double> height(0.02, 1), around(-pi, pi);
  std::vector<DirectionPair> result;
  for (int i = 0; i < count; ++i)
    result.push_back({fromSpherical(std::acos(height(random)), around(random)),
                      fromSpherical(std::acos(height(random)), around(random))});
  return result;
}

}  // namespace gonio::test
