// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/plausibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include "core/brdf/rgl_brdf.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/coordinates/half_difference.h"
#include "core/math/sampling.h"
#include "core/sampling/directional_albedo.h"

namespace gonio::metrics {

namespace {

constexpr double reciprocityTolerance = 0.02, energyTolerance = 0.01, coverageTolerance = 0.01;
/// Values below this fraction of the mean are judged against it: relative noise of almost black is nobody's concern.
constexpr double smallFraction = 0.05;
/// A negative value below this fraction of the mean is rounding.
constexpr double roundingFraction = 1e-6;
constexpr double steepest = radians(85);
constexpr std::uint32_t pairCount = 1 << 14;
constexpr int lastAlbedoDegrees = 85;
constexpr std::array albedoDegrees{0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0};

std::string describe(const DirectionPair& pair) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "theta_i " << degrees(polarAngle(pair.wi)) << ", phi_i "
       << degrees(azimuth(pair.wi)) << ", theta_o " << degrees(polarAngle(pair.wo)) << ", phi_o "
       << degrees(azimuth(pair.wo)) << " degrees";
  return text.str();
}

/// Takes in the violation of one pair.
void worsen(PlausibilityCheck& check, double violation, const DirectionPair& pair) {
  if (violation > check.limit) check.fraction += 1;
  if (!(violation > check.worst)) return;
  check.worst = violation;
  check.at = pair;
}

/// After all pairs.
void conclude(PlausibilityCheck& check, std::size_t tried) {
  check.passed = check.worst <= check.limit;
  if (tried > 0) check.fraction /= double(tried);
  if (check.at) check.where = describe(*check.at);
}

/// Half of the pairs spread over both hemispheres up to 85 degrees, half about the mirror direction.
std::vector<DirectionPair> probePairs() {
  std::vector<DirectionPair> pairs;
  for (std::uint32_t i = 0; i < pairCount; ++i) {
    const glm::dvec2 u = scrambledSobol(i, 21), v = scrambledSobol(i, 22);
    const Direction wo = fromSpherical(steepest * u.x, 2 * pi * u.y);
    Direction wi = fromSpherical(steepest * v.x, 2 * pi * v.y);
    if (i % 2) {
      const Direction half = fromSpherical(radians(20) * v.x * v.x * v.x, 2 * pi * v.y);
      wi = 2 * glm::dot(wo, half) * half - wo;
      if (polarAngle(wi) > steepest) continue;
    }
    pairs.push_back({wi, wo});
  }
  return pairs;
}

bool finite(const Rgb& value) { return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z); }

double meanValue(const std::vector<Rgb>& values) {
  double mean = 0;
  for (const Rgb& value : values)
    if (finite(value)) mean += std::max(0.0, maxChannel(value)) / double(values.size());
  return mean;
}

PlausibilityCheck reciprocity(const std::vector<DirectionPair>& pairs, const std::vector<Rgb>& forth,
                              const std::vector<Rgb>& back) {
  PlausibilityCheck check{.name = "reciprocity", .limit = reciprocityTolerance};
  const double mean = meanValue(forth);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!finite(forth[i]) || !finite(back[i])) continue;
    const double scale = std::max({maxChannel(forth[i]), maxChannel(back[i]), smallFraction * mean});
    if (scale > 0) worsen(check, maxChannel(glm::abs(forth[i] - back[i])) / scale, pairs[i]);
  }
  conclude(check, pairs.size());
  return check;
}

/// Whole degrees of the viewer beside which narrow peaks may raise the albedo above that of other viewers, those with
/// the largest peaks. Tables of Gonio and MERL have nodes at whole degrees of theta_d, which is the viewer's angle for
/// half vectors at the normal.
std::vector<double> anglesOfPeaks(const DirectionalAlbedo& albedo, double usual, double highest,
                                  const TaskControl& control) {
  constexpr std::size_t most = 8;
  std::vector<std::pair<double, double>> candidates;
  for (int angle = 0; angle < lastAlbedoDegrees; ++angle) {
    control.throwIfStopped();
    const double added = albedo.mostOfPeaks({radians(angle), radians(angle + 1)}, usual);
    if (usual + added <= highest) continue;
    candidates.emplace_back(-added, angle);
    candidates.emplace_back(-added, angle + 1);
  }
  std::ranges::sort(candidates);
  std::vector<double> angles;
  for (const auto& [negated, angle] : candidates)
    if (angles.size() < most && std::ranges::find(angles, angle) == angles.end()) angles.push_back(angle);
  return angles;
}

PlausibilityCheck energy(const Brdf& brdf, const TaskControl& control) {
  PlausibilityCheck check{.name = "energy", .limit = 1 + energyTolerance};
  const DirectionalAlbedo albedoAt(brdf);
  std::size_t tried = 0;
  const auto include = [&](double angle) {
    control.throwIfStopped();
    ++tried;
    const double albedo = maxChannel(albedoAt(radians(angle)));
    worsen(check, albedo, {{0, 0, 1}, fromSpherical(radians(angle), 0)});
    return albedo;
  };
  double darkest = std::numeric_limits<double>::infinity();
  for (const double angle : albedoDegrees) darkest = std::min(darkest, include(angle));
  for (const double angle : anglesOfPeaks(albedoAt, darkest, check.worst, control)) include(angle);
  conclude(check, tried);
  if (check.at)
    check.where = "theta_o " + std::to_string(int(std::lround(degrees(polarAngle(check.at->wo))))) + " degrees";
  return check;
}

PlausibilityCheck negative(const std::vector<DirectionPair>& pairs, const std::vector<Rgb>& values, double limit) {
  PlausibilityCheck check{.name = "negative", .limit = limit};
  for (std::size_t i = 0; i < pairs.size(); ++i) worsen(check, maxChannel(-values[i]), pairs[i]);
  conclude(check, pairs.size());
  return check;
}

PlausibilityCheck nonFinite(const std::vector<DirectionPair>& pairs, const std::vector<Rgb>& values) {
  PlausibilityCheck check{.name = "non-finite"};
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!finite(values[i])) worsen(check, check.worst + 1, check.at.value_or(pairs[i]));
  conclude(check, pairs.size());
  return check;
}

}  // namespace

std::vector<PlausibilityCheck> checkPlausibility(const Brdf& brdf, const TaskControl& control) {
  const std::vector<DirectionPair> pairs = probePairs();
  std::vector<DirectionPair> exchanged;
  exchanged.reserve(pairs.size());
  for (const auto& [wi, wo] : pairs) exchanged.push_back({wo, wi});
  std::vector<Rgb> forth(pairs.size()), back(pairs.size());
  brdf.evaluate(pairs, forth);
  control.throwIfStopped();
  brdf.evaluate(exchanged, back);
  std::vector<PlausibilityCheck> checks{
      reciprocity(pairs, forth, back), energy(brdf, control), {}, nonFinite(pairs, forth)};
  if (formOf<RglBrdf>(brdf))
    for (Rgb& value : forth) value = Rgb(luminance(value));
  checks[2] = negative(pairs, forth, 0);
  return checks;
}

PlausibilityCheck checkNegative(const Brdf& edited, const Brdf& base) {
  const std::vector<DirectionPair> pairs = probePairs();
  std::vector<Rgb> values(pairs.size()), unedited(pairs.size());
  edited.evaluate(pairs, values);
  base.evaluate(pairs, unedited);
  const double limit = roundingFraction * meanValue(values);
  for (std::size_t i = 0; i < pairs.size(); ++i) values[i] -= glm::min(unedited[i], Rgb(0));
  return negative(pairs, values, limit);
}

PlausibilityCheck checkCoverage(const TabulatedBrdf& table) {
  PlausibilityCheck check{.name = "extrapolated", .limit = coverageTolerance};
  double missing = 0, all = 0;
  for (const DirectionPair& pair : probePairs()) {
    bool valid = false;
    table.lookup(toHalfDifference(pair.wi, pair.wo), TableLookup::cell, &valid);
    const double weight = pair.wi.z * pair.wo.z;
    all += weight;
    if (valid) continue;
    missing += weight;
    if (!check.at || weight > check.at->wi.z * check.at->wo.z) check.at = pair;
  }
  check.worst = missing / all;
  conclude(check, 0);
  check.fraction = check.worst;
  return check;
}

}  // namespace gonio::metrics
