// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/metric_domain.h"

namespace gonio::metrics {

namespace {

/// CIE 15:2004, equations 8.6 and following.
double labRoot(double t) {
  constexpr double edge = 6.0 / 29;
  return t > edge * edge * edge ? std::cbrt(t) : t / (3 * edge * edge) + 4.0 / 29;
}

}  // namespace

Rgb labOf(const Rgb& reflectance) {
  const Rgb c = reflectance * pi;
  // XYZ of the sRGB primaries (IEC 61966-2-1), each over that of the white (1, 1, 1).
  const double x = (0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z) / (0.4124 + 0.3576 + 0.1805);
  const double y = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
  const double z = (0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z) / (0.0193 + 0.1192 + 0.9505);
  const double fx = labRoot(x), fy = labRoot(y), fz = labRoot(z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

}  // namespace gonio::metrics
