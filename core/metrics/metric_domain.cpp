// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/metric_domain.h"

namespace gonio::metrics {

namespace {

/// CIE 15:2004, equations 8.6 and following.
inline double labRoot(double t) {
  constexpr double edge = 6.0 / 29;
  return t > edge * edge * edge ? fastCbrt(t) : t / (3 * edge * edge) + 4.0 / 29;
}

inline Rgb lab(double red, double green, double blue) {
  red *= pi;
  green *= pi;
  blue *= pi;
  // XYZ of the sRGB primaries (IEC 61966-2-1), each over that of the white (1, 1, 1).
  const double x = (0.4124 * red + 0.3576 * green + 0.1805 * blue) / (0.4124 + 0.3576 + 0.1805);
  const double y = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  const double z = (0.0193 * red + 0.1192 * green + 0.9505 * blue) / (0.0193 + 0.1192 + 0.9505);
  const double fx = labRoot(x), fy = labRoot(y), fz = labRoot(z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

}  // namespace

Rgb labOf(const Rgb& reflectance) { return lab(reflectance.x, reflectance.y, reflectance.z); }

void labDifferences(const Eigen::Array3Xd& reference, const Eigen::Array3Xd& test, Eigen::Array3Xd& differences) {
  const double *r = reference.data(), *t = test.data();
  double* d = differences.data();
  for (Eigen::Index i = 0; i < reference.cols(); ++i, r += 3, t += 3, d += 3) {
    const Rgb a = lab(r[0], r[1], r[2]), b = lab(t[0], t[1], t[2]);
    d[0] = a.x - b.x;
    d[1] = a.y - b.y;
    d[2] = a.z - b.z;
  }
}

}  // namespace gonio::metrics
