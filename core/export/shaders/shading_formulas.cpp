// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/shading_formulas.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/parallel.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::exports {

namespace {

constexpr std::size_t cosineCount = 64, widthCount = 48;
constexpr double minCosine = 1e-3, minRoot = 0.04;  // of cosines and of sqrt(alpha)
constexpr int strata = 24;

/// Linear between nodes in the cosine and in sqrt(alpha), which spreads the narrow lobes.
class AlbedoTable {
 public:
  explicit AlbedoTable(GgxAlbedo (*integrate)(double cosine, double alpha)) : values_(cosineCount * widthCount) {
    parallelForBlocks(widthCount, 1, [&](std::size_t width, std::size_t) {
      for (std::size_t k = 0; k < cosineCount; ++k) {
        const double root = minRoot + (1 - minRoot) * double(width) / double(widthCount - 1);
        const double cosine = std::max(minCosine, double(k) / double(cosineCount - 1));
        values_[width * cosineCount + k] = integrate(cosine, root * root);
      }
    });
  }

  GgxAlbedo at(double cosine, double alpha) const {
    const double root = std::clamp((std::sqrt(std::max(0.0, alpha)) - minRoot) / (1 - minRoot), 0.0, 1.0);
    const double y = root * double(widthCount - 1), x = std::clamp(cosine, 0.0, 1.0) * double(cosineCount - 1);
    const std::size_t row = std::min(std::size_t(y), widthCount - 2),
                      column = std::min(std::size_t(x), cosineCount - 2);
    const GgxAlbedo* lower = &values_[row * cosineCount + column];
    const GgxAlbedo* upper = lower + cosineCount;
    return mixed(mixed(lower[0], lower[1], x - double(column)), mixed(upper[0], upper[1], x - double(column)),
                 y - double(row));
  }

 private:
  static GgxAlbedo mixed(const GgxAlbedo& a, const GgxAlbedo& b, double t) {
    return {a.normal + t * (b.normal - a.normal), a.edge + t * (b.edge - a.edge)};
  }

  std::vector<GgxAlbedo> values_;
};

/// By samples of visible normals, of which each counts G_2 / G_1(wo).
GgxAlbedo integrateGgx(double cosine, double alpha) {
  const Direction wo(std::sqrt(1 - cosine * cosine), 0, cosine);
  const VisibleNormalDensity lobe(alpha);
  GgxAlbedo sum{0, 0};
  for (int i = 0; i < strata * strata; ++i) {
    const int row = i / strata, column = i % strata;
    const Direction wi = lobe.sample(wo, {(column + 0.5) / strata, (row + 0.5) / strata});
    if (!models::isAboveSurface({wi, wo})) continue;
    const models::SurfaceGeometry g = models::surfaceGeometry({wi, wo});
    const double weight = correlatedGgx(g, GgxAlpha(alpha)) * wi.z / lobe.density(wi, wo), s = schlickWeight(g.cosD);
    sum.normal += weight * (1 - s);
    sum.edge += weight * s;
  }
  return {sum.normal / (strata * strata), sum.edge / (strata * strata)};
}

/// By directions of the light that are cosine-weighted: the sheen is wide. In `normal`.
GgxAlbedo integrateCharlie(double cosine, double alpha) {
  const Direction wo(std::sqrt(1 - cosine * cosine), 0, cosine);
  double sum = 0;
  for (int i = 0; i < strata * strata; ++i) {
    const int row = i / strata, column = i % strata;
    const double r2 = (column + 0.5) / strata, phi = pi * (row + 0.5) / strata, r = std::sqrt(r2);
    const Direction wi(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r2));
    if (!models::isAboveSurface({wi, wo})) continue;
    const models::SurfaceGeometry g = models::surfaceGeometry({wi, wo});
    sum += pi * charlieDensity(g.sin2H, alpha) / (4 * (g.cosI + g.cosO - g.cosI * g.cosO));
  }
  return {std::min(1.0, sum / (strata * strata)), 0};
}

}  // namespace

GgxAlbedo ggxAlbedo(double cosine, double alpha) {
  static const AlbedoTable table(integrateGgx);
  return table.at(cosine, alpha);
}

double scatteringCompensation(const GgxAlbedo& albedo, double fresnel) {
  const double white = albedo.at(1);
  return 1 + fresnel * (1 - white) / white;
}

double charlieDensity(double sin2H, double alpha) {
  const double exponent = 1 / std::max(alpha, 1e-3);
  return (2 + exponent) * std::pow(sin2H, exponent / 2) / (2 * pi);
}

double charlieAlbedo(double cosine, double alpha) {
  static const AlbedoTable table(integrateCharlie);
  return table.at(cosine, alpha).normal;
}

}  // namespace gonio::exports
