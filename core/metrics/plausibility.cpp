// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/plausibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/brdf/statistics.h"
#include "core/math/sampling.h"

namespace gonio::metrics {

namespace {

constexpr double reciprocityTolerance = 0.02, energyTolerance = 0.01;
/// Values below this share of the mean are judged against it: relative noise of almost black is nobody's concern.
constexpr double smallShare = 0.05;
constexpr std::uint32_t pairCount = 1 << 14;
constexpr std::array albedoDegrees{0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0};

std::string describe(const DirectionPair& pair) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "theta_i " << degrees(polarAngle(pair.wi)) << ", phi_i "
       << degrees(azimuth(pair.wi)) << ", theta_o " << degrees(polarAngle(pair.wo)) << ", phi_o "
       << degrees(azimuth(pair.wo)) << " degrees";
  return text.str();
}

void worsen(PlausibilityCheck& check, double violation, const DirectionPair& pair) {
  if (!(violation > check.worst)) return;
  check.worst = violation;
  check.where = describe(pair);
}

/// Half of the pairs spread over both hemispheres up to 85 degrees, half about the mirror direction.
std::vector<DirectionPair> probePairs() {
  std::vector<DirectionPair> pairs;
  for (std::uint32_t i = 0; i < pairCount; ++i) {
    const glm::dvec2 u = scrambledSobol(i, 21), v = scrambledSobol(i, 22);
    const Direction wo = fromSpherical(radians(85) * u.x, 2 * pi * u.y);
    Direction wi = fromSpherical(radians(85) * v.x, 2 * pi * v.y);
    if (i % 2) {
      const Direction half = fromSpherical(radians(20) * v.x * v.x * v.x, 2 * pi * v.y);
      wi = 2 * glm::dot(wo, half) * half - wo;
      if (polarAngle(wi) > radians(85)) continue;
    }
    pairs.push_back({wi, wo});
  }
  return pairs;
}

bool finite(const Rgb& value) { return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z); }

PlausibilityCheck reciprocity(const std::vector<DirectionPair>& pairs, const std::vector<Rgb>& forth,
                              const std::vector<Rgb>& back) {
  PlausibilityCheck check{.name = "reciprocity"};
  double mean = 0;
  for (const Rgb& value : forth)
    if (finite(value)) mean += std::max(0.0, maxChannel(value)) / double(forth.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!finite(forth[i]) || !finite(back[i])) continue;
    const double scale = std::max({maxChannel(forth[i]), maxChannel(back[i]), smallShare * mean});
    if (scale > 0) worsen(check, maxChannel(glm::abs(forth[i] - back[i])) / scale, pairs[i]);
  }
  check.passed = check.worst <= reciprocityTolerance;
  return check;
}

PlausibilityCheck energy(const Brdf& brdf) {
  PlausibilityCheck check{.name = "energy"};
  for (const double angle : albedoDegrees) {
    const double albedo = maxChannel(directionalAlbedo(brdf, radians(angle)));
    if (!(albedo > check.worst)) continue;
    check.worst = albedo;
    check.where = "theta_o " + std::to_string(int(angle)) + " degrees";
  }
  check.passed = check.worst <= 1 + energyTolerance;
  return check;
}

PlausibilityCheck negative(const std::vector<DirectionPair>& pairs, const std::vector<Rgb>& values) {
  PlausibilityCheck check{.name = "negative"};
  for (std::size_t i = 0; i < pairs.size(); ++i) worsen(check, maxChannel(-values[i]), pairs[i]);
  check.passed = !(check.worst > 0);
  return check;
}

PlausibilityCheck nonFinite(const std::vector<DirectionPair>& pairs, const std::vector<Rgb>& values) {
  PlausibilityCheck check{.name = "non-finite"};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (finite(values[i])) continue;
    if (check.worst == 0) check.where = describe(pairs[i]);
    check.worst += 1;
  }
  check.passed = check.worst == 0;
  return check;
}

}  // namespace

std::vector<PlausibilityCheck> checkPlausibility(const Brdf& brdf) {
  const std::vector<DirectionPair> pairs = probePairs();
  std::vector<DirectionPair> exchanged;
  for (const auto& [wi, wo] : pairs) exchanged.push_back({wo, wi});
  std::vector<Rgb> forth(pairs.size()), back(pairs.size());
  brdf.evaluate(pairs, forth);
  brdf.evaluate(exchanged, back);
  return {reciprocity(pairs, forth, back), energy(brdf), negative(pairs, forth), nonFinite(pairs, forth)};
}

}  // namespace gonio::metrics
