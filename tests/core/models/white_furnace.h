// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/math/quadrature.h"

namespace gonio::models::test_support {

/// White-furnace albedo, the integral of the BRDF times cos theta_i over wi, by quadrature over the half vector: there
/// a highlight of any width lies at the pole. The radius r = tan theta_h runs over decades, the azimuth is periodic.
/// Half vectors that put wi below the horizon add nothing. `width` is about the narrowest feature in r, `panels` the
/// effort. Where the BRDF is not isotropic, wo may have any azimuth; else it lies in the plane y = 0.
inline double whiteFurnaceAlbedo(const Brdf& brdf, const Direction& wo, double width = 0.1, int panels = 40) {
  const QuadratureRule logRadius = compositeGaussLegendre(16, panels, std::log(width * 1e-4), std::log(1e4));
  const bool halfCircle = brdf.isIsotropic();  // the other half mirrors it
  const QuadratureRule azimuth =
      compositeGaussLegendre(16, (halfCircle ? 2 : 4) * panels / 5, 0, halfCircle ? pi : 2 * pi);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  for (std::size_t i = 0; i < logRadius.nodes.size(); ++i)
    for (std::size_t j = 0; j < azimuth.nodes.size(); ++j) {
      const double r = std::exp(logRadius.nodes[i]), cosH = 1 / std::sqrt(1 + r * r);
      const Direction h = Direction(r * std::cos(azimuth.nodes[j]), r * std::sin(azimuth.nodes[j]), 1) * cosH;
      const double cosD = glm::dot(wo, h);
      const Direction wi = 2 * cosD * h - wo;
      if (cosD <= 0 || wi.z <= 0) continue;
      // d omega_i = 4 cos theta_d d omega_h, d omega_h = r cos^3 theta_h dr dphi, dr = r d(ln r).
      pairs.push_back({wi, wo});
      weights.push_back((halfCircle ? 2 : 1) * logRadius.weights[i] * azimuth.weights[j] * r * r * cosH * cosH * cosH *
                        4 * cosD * wi.z);
    }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weights[i] * values[i].x;
  return sum;
}

}  // namespace gonio::models::test_support
