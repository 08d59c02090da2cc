// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

namespace gonio {

/// Inverts the integral of the linear function from `low` at 0 to `high` at 1, both >= 0, without cancellation: the
/// point t in [0, 1] with low t + (high - low) t^2 / 2 = area. 0 if both are 0.
inline double inverseOfRamp(double low, double high, double area) {
  const double root = std::sqrt(std::max(0.0, low * low + 2 * area * (high - low)));
  const double sum = low + root;
  return sum > 0 ? std::clamp(2 * area / sum, 0.0, 1.0) : 0;
}

}  // namespace gonio
