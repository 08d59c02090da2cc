// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <numbers>

namespace gonio {

/// atan2(y, x) of finite numbers, without branches and calls, so that loops are vectorised. Absolute error below 1e-15,
/// relative error below 4e-16 for results near 0. x = 0 counts as positive: (0, 0) gives 0. The arc tangent is a
/// polynomial on |t| <= tan(pi/8) (Chebyshev interpolation of degree 10 in t^2, error 5e-18).
inline double fastAtan2(double y, double x) {
  const double absX = std::abs(x), absY = std::abs(y);
  const double large = absX > absY ? absX : absY, small = absX > absY ? absY : absX;
  constexpr double tanEighth = std::numbers::sqrt2 - 1;
  const bool upper = small > tanEighth * large;
  const double denominator = upper ? small + large : large;
  const double t = (upper ? small - large : small) / (denominator > 0 ? denominator : 1.0);
  const double z = t * t;
  double p = -0.019176885636589053;
  p = p * z + 0.039231657085083686;
  p = p * z - 0.050854496960392584;
  p = p * z + 0.05858148904795124;
  p = p * z - 0.0666451144646022;
  p = p * z + 0.07692183190760651;
  p = p * z - 0.09090904578121085;
  p = p * z + 0.11111111015256292;
  p = p * z - 0.14285714284666542;
  p = p * z + 0.1999999999999552;
  p = p * z - 0.3333333333333333;
  constexpr double quarter = std::numbers::pi / 4, half = std::numbers::pi / 2;
  double angle = (upper ? quarter : 0.0) + (t + t * (z * p));
  angle = absY > absX ? half - angle : angle;
  angle = x < 0 ? std::numbers::pi - angle : angle;
  return std::copysign(angle, y);
}

}  // namespace gonio
