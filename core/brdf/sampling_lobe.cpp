// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/sampling_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/brdf/lobe_mixture.h"
#include "core/brdf/visible_normal_lobe.h"

namespace gonio {

namespace {

constexpr double minRoughness = 1e-3, maxRoughness = 1, maxSpecularShare = 0.95;

/// Where a BRDF is looked at for the fit: one viewer, half vectors on logarithmic rings about the normal.
struct ProbeSet {
  std::vector<DirectionPair> pairs;
  std::vector<double> solidAngles;  ///< of wi, sr
};

void addProbes(double thetaO, ProbeSet& probes) {
  constexpr int rings = 44, spokes = 8;
  constexpr double firstRing = 5e-5;
  const Direction wo = fromSpherical(thetaO, 0);
  const auto edge = [](int ring) {
    return ring == 0 ? 0.0 : firstRing * std::pow(halfPi / firstRing, double(ring) / rings);
  };
  for (int ring = 0; ring < rings; ++ring) {
    const double low = edge(ring), high = edge(ring + 1), middle = (low + high) / 2;
    const double normalSolidAngle = 2 * std::sin(middle) * std::sin((high - low) / 2) * 2 * pi / spokes;
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const Direction half = fromSpherical(middle, 2 * pi * (spoke + 0.5) / spokes);
      const double cosD = glm::dot(half, wo);
      const Direction wi = 2 * cosD * half - wo;
      if (cosD <= 0 || wi.z <= 0) continue;
      probes.pairs.push_back({wi, wo});
      probes.solidAngles.push_back(normalSolidAngle * 4 * cosD);
    }
  }
}

/// Of one viewer: what the estimator integrates, squared, and the two densities that the lobe mixes.
struct ProbeTerms {
  std::vector<double> energy;  ///< (f cos theta_i)^2 times the solid angle
  std::vector<double> cosinePdf;
};

ProbeTerms probeTerms(const Brdf& brdf, const ProbeSet& probes) {
  std::vector<Rgb> values(probes.pairs.size());
  brdf.evaluate(probes.pairs, values);
  ProbeTerms terms;
  double total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double cosI = probes.pairs[i].wi.z;
    const double reflected = std::max(0.0, values[i].x + values[i].y + values[i].z) / 3 * cosI;
    total += reflected * probes.solidAngles[i];
    terms.energy.push_back(reflected * reflected * probes.solidAngles[i]);
    terms.cosinePdf.push_back(cosI / pi);
  }
  // Relative to the squared mean: every viewer counts alike.
  if (total > 0)
    for (double& energy : terms.energy) energy /= total * total;
  return terms;
}

}  // namespace

DirectionSample SamplingLobe::sample(const Direction& wo, const glm::dvec3& u) const {
  const glm::dvec2 point(u.y, u.z);
  const Direction wi =
      u.x < specularShare ? VisibleNormalLobe{roughness}.sample(wo, point) : CosineLobe{}.sample(wo, point);
  return {wi, pdf(wi, wo)};
}

double SamplingLobe::pdf(const Direction& wi, const Direction& wo) const {
  if (!(wi.z > 0)) return 0;
  return (1 - specularShare) * CosineLobe{}.density(wi, wo) +
         specularShare * VisibleNormalLobe{roughness}.density(wi, wo);
}

SamplingLobe estimateSamplingLobe(const Brdf& brdf) {
  constexpr std::array viewerDegrees{10.0, 40.0, 65.0};
  constexpr int roughnessSteps = 25;
  constexpr std::array shares{0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, maxSpecularShare};

  // The second moment of the estimator f cos / pdf, summed over the viewers, is what the fit makes small.
  std::array<std::array<double, shares.size()>, roughnessSteps> moments{};
  const auto roughnessAt = [](int step) {
    return minRoughness * std::pow(maxRoughness / minRoughness, double(step) / (roughnessSteps - 1));
  };
  for (const double viewer : viewerDegrees) {
    ProbeSet probes;
    addProbes(radians(viewer), probes);
    const ProbeTerms terms = probeTerms(brdf, probes);
    for (int step = 0; step < roughnessSteps; ++step)
      for (std::size_t i = 0; i < terms.energy.size(); ++i) {
        const double lobePdf = VisibleNormalLobe{roughnessAt(step)}.density(probes.pairs[i].wi, probes.pairs[i].wo);
        for (std::size_t share = 0; share < shares.size(); ++share) {
          const double density = (1 - shares[share]) * terms.cosinePdf[i] + shares[share] * lobePdf;
          moments[std::size_t(step)][share] += terms.energy[i] / density;
        }
      }
  }
  SamplingLobe best{.roughness = 0.3, .specularShare = 0};
  double smallest = moments[0][0];
  for (int step = 0; step < roughnessSteps; ++step)
    for (std::size_t share = 0; share < shares.size(); ++share)
      if (moments[std::size_t(step)][share] < smallest * (1 - 1e-9)) {
        smallest = moments[std::size_t(step)][share];
        best = {.roughness = roughnessAt(step), .specularShare = shares[share]};
      }
  return best;
}

}  // namespace gonio
