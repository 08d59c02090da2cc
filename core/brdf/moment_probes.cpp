// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/moment_probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gonio {

namespace {

constexpr std::array fittedDegrees{10.0, 40.0, 65.0};

/// Of one viewer, each ring turned against the last.
void addProbes(const Brdf& brdf, const Direction& wo, int spokes, std::vector<MomentProbe>& probes) {
  constexpr int rings = 44;
  constexpr double firstRing = 5e-5, goldenTurn = 0.6180339887498949;
  const auto edge = [](int ring) {
    return ring == 0 ? 0.0 : firstRing * std::pow(halfPi / firstRing, double(ring) / rings);
  };
  std::vector<DirectionPair> pairs;
  std::vector<double> solidAngles;  // of wi
  for (int ring = 0; ring < rings; ++ring) {
    const double low = edge(ring), high = edge(ring + 1), middle = (low + high) / 2;
    const double normalSolidAngle = 2 * std::sin(middle) * std::sin((high - low) / 2) * 2 * pi / spokes;
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const Direction half = fromSpherical(middle, 2 * pi * (spoke + ring * goldenTurn) / spokes);
      const double cosD = glm::dot(half, wo);
      const Direction wi = 2 * cosD * half - wo;
      if (cosD <= 0 || wi.z <= 0) continue;
      pairs.push_back({wi, wo});
      solidAngles.push_back(normalSolidAngle * 4 * cosD);
    }
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  const std::size_t first = probes.size();
  double total = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double reflected = std::max(0.0, values[i].x + values[i].y + values[i].z) / 3 * pairs[i].wi.z;
    total += reflected * solidAngles[i];
    if (reflected > 0) probes.push_back({pairs[i], reflected * reflected * solidAngles[i]});
  }
  for (std::size_t i = first; i < probes.size(); ++i) probes[i].energy /= total * total;
}

std::vector<MomentProbe> probesOf(const Brdf& brdf, std::span<const double> viewerDegrees, int azimuths, int spokes) {
  // Not evenly over the turn: the two sides of a surface mostly look the same.
  constexpr double azimuthStep = 2 * pi * 0.381966011250105, first = 0.2;
  std::vector<MomentProbe> probes;
  for (const double degrees : viewerDegrees)
    for (int azimuth = 0; azimuth < azimuths; ++azimuth)
      addProbes(brdf, fromSpherical(radians(degrees), first + azimuth * azimuthStep), spokes, probes);
  for (MomentProbe& probe : probes) probe.energy /= double(viewerDegrees.size()) * azimuths;
  return probes;
}

}  // namespace

std::vector<MomentProbe> momentProbes(const Brdf& brdf) {
  return brdf.isIsotropic() ? probesOf(brdf, std::array{10.0, 40.0, 65.0, 80.0}, 1, 8)
                            : probesOf(brdf, fittedDegrees, 5, 32);
}

std::vector<MomentProbe> isotropicMomentProbes(const Brdf& brdf) { return probesOf(brdf, fittedDegrees, 1, 8); }

}  // namespace gonio
