// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/brdf/brdf.h"

namespace gonio::test {

/// Directional albedo by brute force, for wi in the plane phi = 0: `rings` about the normal of the half vector, uniform
/// in log tan theta_h, of `azimuths` directions each. @param degrees theta_i.
inline Rgb ringAlbedo(const Brdf& brdf, double degrees, int rings, int azimuths) {
  constexpr double first = -9, last = 4;
  const double theta = degrees * pi / 180;
  const Direction wi{std::sin(theta), 0, std::cos(theta)};
  Rgb sum(0);
  for (int i = 0; i < rings; ++i) {
    const double tangent = std::exp(first + (last - first) * (i + 0.5) / rings), cosine = 1 / std::hypot(1, tangent);
    for (int k = 0; k < azimuths; ++k) {
      const double phi = 2 * pi * (k + 0.5) / azimuths;
      const Direction h = cosine * Direction(tangent * std::cos(phi), tangent * std::sin(phi), 1);
      const Direction wo = 2 * glm::dot(wi, h) * h - wi;
      if (!(glm::dot(wi, h) > 0 && wo.z > 0)) continue;
      const double area = tangent * tangent * cosine * cosine * cosine * ((last - first) / rings) * (2 * pi / azimuths);
      sum += brdf.evaluate(wi, wo) * (wo.z * 4 * glm::dot(wi, h) * area);
    }
  }
  return sum;
}

}  // namespace gonio::test
