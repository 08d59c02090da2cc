// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/directional_albedo.h"

#include <vector>

#include "core/math/sampling.h"

namespace gonio {

Rgb directionalAlbedo(const Brdf& brdf, double theta) {
  return directionalAlbedo(brdf, theta, estimateSamplingDensity(brdf), 1 << 14);
}

Rgb directionalAlbedo(const Brdf& brdf, double theta, SamplingDensity density, std::uint32_t sampleCount) {
  // A fixed number of points for each of the density's two parts, each stratified on its own (multiple importance
  // sampling with the balance heuristic): the choice of a part adds no noise.
  const auto specularCount = static_cast<std::uint32_t>(density.specularFraction * sampleCount);
  density.specularFraction = double(specularCount) / sampleCount;
  const Direction wo = fromSpherical(theta, 0);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  pairs.reserve(sampleCount);
  weights.reserve(sampleCount);
  for (std::uint32_t i = 0; i < sampleCount; ++i) {
    const bool specular = i < specularCount;
    const glm::dvec2 u = specular ? scrambledSobol(i, 11) : scrambledSobol(i - specularCount, 12);
    const DirectionSample sample = density.sample(wo, {specular ? 0.0 : density.specularFraction, u.x, u.y});
    if (!(sample.pdf > 0)) continue;
    pairs.push_back({sample.wi, wo});
    weights.push_back(sample.wi.z / sample.pdf);
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  Rgb sum(0);
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * weights[i];
  return sum / double(sampleCount);
}

}  // namespace gonio
