// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/brdf/sampling_lobe.h"
#include "core/math/sampling.h"

namespace gonio {

TableStatistics tableStatistics(const TabulatedBrdf& table) {
  TableStatistics statistics;
  const auto values = table.values();
  const auto valid = table.valid();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double smallest = infinity, largest = 0;
  if (table.validCount() > 0) statistics.channels.fill({infinity, -infinity});
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!valid[i]) continue;
    for (int channel = 0; channel < 3; ++channel) {
      const double value = values[i][channel];
      ChannelRange& range = statistics.channels[std::size_t(channel)];
      range.min = std::min(range.min, value);
      range.max = std::max(range.max, value);
      if (value > 0) smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  if (!values.empty()) statistics.invalidFraction = 1 - double(table.validCount()) / double(values.size());
  if (largest > 0) statistics.dynamicRange = largest / smallest;
  return statistics;
}

Rgb directionalAlbedo(const Brdf& brdf, double theta) {
  return directionalAlbedo(brdf, theta, estimateSamplingLobe(brdf), 1 << 14);
}

Rgb directionalAlbedo(const Brdf& brdf, double theta, SamplingLobe lobe, std::uint32_t sampleCount) {
  // A fixed number of points for each of the lobe's two parts, each stratified on its own (multiple importance
  // sampling with the balance heuristic): the choice of a part adds no noise.
  const auto specularCount = static_cast<std::uint32_t>(lobe.specularFraction * sampleCount);
  lobe.specularFraction = double(specularCount) / sampleCount;
  const Direction wo = fromSpherical(theta, 0);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  pairs.reserve(sampleCount);
  weights.reserve(sampleCount);
  for (std::uint32_t i = 0; i < sampleCount; ++i) {
    const bool specular = i < specularCount;
    const glm::dvec2 u = specular ? scrambledSobol(i, 11) : scrambledSobol(i - specularCount, 12);
    const DirectionSample sample = lobe.sample(wo, {specular ? 0.0 : lobe.specularFraction, u.x, u.y});
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
