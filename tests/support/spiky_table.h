// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/brdf/tabulated_brdf.h"

namespace gonio::test {

/// A MERL-like table of `base` with the value `peak` in some cells: all with these numbers of theta_h and theta_d, and
/// one number of phi_d or, if it is -1, all.
inline std::shared_ptr<const TabulatedBrdf> spikyTable(int i, int j, int k, float peak, float base = 1e-4f) {
  const HalfDifferenceGrid grid;
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(base));
  for (int phi = 0; phi < grid.phiDCount; ++phi)
    if (k < 0 || phi == k) values[grid.index(i, j, phi)] = TabulatedBrdf::Value(peak);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::vector<std::uint8_t>(grid.size(), 1));
}

/// The directional albedo (red) for a viewer at a polar angle (rad), by a midpoint rule over half vectors whose polar
/// angles are between those of two nodes of theta_h, plus the Lambertian `base` elsewhere.
inline double albedoOfSpike(const TabulatedBrdf& table, double theta, int firstNode, int lastNode, float base = 1e-4f) {
  constexpr int rings = 160, sectors = 24000;
  const Direction wo = fromSpherical(theta, 0);
  const auto node = [&](int i) { return halfPi * (double(i) / 90) * (double(i) / 90); };
  const double first = node(firstNode), last = node(lastNode);
  std::vector<DirectionPair> pairs(sectors);
  std::vector<double> weights(sectors);
  std::vector<Rgb> values(sectors);
  double sum = pi * double(base);
  for (int ring = 0; ring < rings; ++ring) {
    const double low = first + (last - first) * ring / rings, high = first + (last - first) * (ring + 1) / rings;
    for (int sector = 0; sector < sectors; ++sector) {
      const Direction half = fromSpherical((low + high) / 2, 2 * pi * (sector + 0.5) / sectors);
      const double cosD = glm::dot(half, wo);
      pairs[std::size_t(sector)] = {2 * cosD * half - wo, wo};
      const double z = pairs[std::size_t(sector)].wi.z;
      weights[std::size_t(sector)] = cosD > 0 && z > 0 ? z * 4 * cosD : 0;
    }
    table.evaluate(pairs, values);
    const double solidAngle = 2 * std::sin((low + high) / 2) * std::sin((high - low) / 2) * 2 * pi / sectors;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (weights[i] > 0) sum += (values[i].x - double(base)) * weights[i] * solidAngle;
  }
  return sum;
}

}  // namespace gonio::test
