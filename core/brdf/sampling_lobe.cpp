// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/sampling_lobe.h"

#include <array>
#include <cmath>
#include <vector>

#include "core/brdf/lobe_mixture.h"
#include "core/brdf/moment_probes.h"
#include "core/brdf/visible_normal_lobe.h"

namespace gonio {

namespace {

constexpr double minRoughness = 1e-3, maxRoughness = 1, maxSpecularFraction = 0.95;

}  // namespace

DirectionSample SamplingLobe::sample(const Direction& wo, const glm::dvec3& u) const {
  const glm::dvec2 point(u.y, u.z);
  const Direction wi =
      u.x < specularFraction ? VisibleNormalLobe{roughness}.sample(wo, point) : CosineLobe{}.sample(wo, point);
  return {wi, pdf(wi, wo)};
}

double SamplingLobe::pdf(const Direction& wi, const Direction& wo) const {
  if (!(wi.z > 0)) return 0;
  return (1 - specularFraction) * CosineLobe{}.density(wi, wo) +
         specularFraction * VisibleNormalLobe{roughness}.density(wi, wo);
}

bool areSimilar(const SamplingLobe& a, const SamplingLobe& b) {
  constexpr double sameFraction = 0.15, sameWidth = 0.4;  // more than a step of the fit
  return std::abs(a.specularFraction - b.specularFraction) < sameFraction &&
         std::abs(std::log(a.roughness / b.roughness)) < sameWidth;
}

SamplingLobe estimateSamplingLobe(const Brdf& brdf) {
  constexpr int roughnessSteps = 25;
  constexpr std::array fractions{0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, maxSpecularFraction};

  // The second moment of the estimator is what the fit makes small.
  const std::vector<MomentProbe> probes = isotropicMomentProbes(brdf);
  std::array<std::array<double, fractions.size()>, roughnessSteps> moments{};
  const auto roughnessAt = [](int step) {
    return minRoughness * std::pow(maxRoughness / minRoughness, double(step) / (roughnessSteps - 1));
  };
  for (int step = 0; step < roughnessSteps; ++step)
    for (const MomentProbe& probe : probes) {
      const double lobePdf = VisibleNormalLobe{roughnessAt(step)}.density(probe.pair.wi, probe.pair.wo);
      for (std::size_t fraction = 0; fraction < fractions.size(); ++fraction) {
        const double density = (1 - fractions[fraction]) * probe.pair.wi.z / pi + fractions[fraction] * lobePdf;
        moments[std::size_t(step)][fraction] += probe.energy / density;
      }
    }
  SamplingLobe best{.roughness = 0.3, .specularFraction = 0};
  double smallest = moments[0][0];
  for (int step = 0; step < roughnessSteps; ++step)
    for (std::size_t fraction = 0; fraction < fractions.size(); ++fraction)
      if (moments[std::size_t(step)][fraction] < smallest * (1 - 1e-9)) {
        smallest = moments[std::size_t(step)][fraction];
        best = {.roughness = roughnessAt(step), .specularFraction = fractions[fraction]};
      }
  return best;
}

}  // namespace gonio
