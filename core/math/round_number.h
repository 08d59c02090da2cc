// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

namespace gonio {

/// The smallest of 1, 2 and 5 times a power of ten that is no smaller, up to rounding (0.2 stays 2 * 0.1): steps of
/// ticks, ends of scales. 0 of what is not above 0.
inline double roundedUp(double value) {
  if (!(value > 0)) return 0;
  constexpr double tolerance = 1 + 1e-12;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * power * tolerance) return step * power;
  return 10 * power;
}

}  // namespace gonio
