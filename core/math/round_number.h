// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

namespace gonio {

/// The smallest number >= value that is 1, 2 or 5 times a power of ten, up to rounding (0.2 stays 2 * 0.1), for steps
/// of ticks and ends of scales. 0 if value is not above 0.
inline double roundedUp(double value) {
  if (!(value > 0)) return 0;
  constexpr double tolerance = 1 + 1e-12;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power * tolerance) return step * power;
  return 10 * power;
}

}  // namespace gonio
