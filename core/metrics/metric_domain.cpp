// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/metric_domain.h"

#include "core/math/srgb.h"

namespace gonio::metrics {

namespace {

/// CIE 15:2004, equations 8.6 and following. Both branches are computed, so that loops over it become vector code.
[[gnu::always_inline]] inline double labRoot(double t) {
  constexpr double edge = 6.0 / 29;
  const double root = fastCbrt(t), line = t / (3 * edge * edge) + 4.0 / 29;
  return t > edge * edge * edge ? root : line;
}

/// XYZ of reflectances, each over that of the perfect diffuser.
[[gnu::always_inline]] inline Rgb diffuserRelative(double red, double green, double blue) {
  return whiteRelativeXyz(red * pi, green * pi, blue * pi);
}

}  // namespace

Rgb labOf(const Rgb& value) {
  const Rgb white = diffuserRelative(value.x, value.y, value.z);
  const double fx = labRoot(white.x), fy = labRoot(white.y), fz = labRoot(white.z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

void labDifferences(const Eigen::Array3Xd& reference, const Eigen::Array3Xd& test, Eigen::Array3Xd& differences) {
  constexpr Eigen::Index block = 128;
  double r[3 * block], t[3 * block];  // roots of XYZ
  for (Eigen::Index begin = 0; begin < reference.cols(); begin += block) {
    const Eigen::Index count = std::min(block, reference.cols() - begin);
    const double *a = reference.data() + 3 * begin, *b = test.data() + 3 * begin;
    for (Eigen::Index i = 0; i < 3 * count; i += 3) {
      const Rgb whiteA = diffuserRelative(a[i], a[i + 1], a[i + 2]),
                whiteB = diffuserRelative(b[i], b[i + 1], b[i + 2]);
      for (int c = 0; c < 3; ++c) {
        r[i + c] = whiteA[c];
        t[i + c] = whiteB[c];
      }
    }
    // The constants of L*, a* and b* cancel.
    for (Eigen::Index i = 0; i < 3 * count; ++i) r[i] = labRoot(r[i]) - labRoot(t[i]);
    double* d = differences.data() + 3 * begin;
    for (Eigen::Index i = 0; i < 3 * count; i += 3) {
      d[i] = 116 * r[i + 1];
      d[i + 1] = 500 * (r[i] - r[i + 1]);
      d[i + 2] = 200 * (r[i + 1] - r[i + 2]);
    }
  }
}

}  // namespace gonio::metrics
