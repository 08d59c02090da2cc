// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/directional_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/math/sampling.h"
#include "core/sampling/narrow_peaks.h"

namespace gonio {

namespace {

/// Finds the set that contains a half vector, by the polar angle.
class PeakIndex {
 public:
  PeakIndex(const std::vector<NarrowPeak>& peaks, bool isotropic) : isotropic_(isotropic) {
    for (const NarrowPeak& peak : peaks)
      for (std::size_t i = bucket(peak.box.thetaH.low); i <= bucket(peak.box.thetaH.high); ++i)
        buckets_[i].push_back(&peak);
  }

  /// @param pair with the viewer at azimuth 0.
  bool contains(const DirectionPair& pair) const {
    const Direction half = glm::normalize(pair.wi + pair.wo);
    const double thetaH = polarAngle(half), phi = std::atan2(half.y, half.x), psi = isotropic_ ? std::abs(phi) : phi;
    return std::ranges::any_of(buckets_[bucket(thetaH)], [&](const NarrowPeak* peak) {
      const PairBox& box = peak->box;
      return thetaH >= box.thetaH.low && thetaH < box.thetaH.high && psi >= box.psi.low && psi < box.psi.high;
    });
  }

 private:
  static constexpr std::size_t count = 256;
  static std::size_t bucket(double thetaH) {
    return std::min(count - 1, std::size_t(std::sqrt(thetaH / halfPi) * double(count)));
  }

  bool isotropic_;
  std::array<std::vector<const NarrowPeak*>, count> buckets_;
};

/// The integral over the sets, each by points in proportion to the light that it may reflect.
Rgb integralOfPeaks(const Brdf& brdf, const std::vector<NarrowPeak>& peaks) {
  constexpr double points = 1 << 17;
  constexpr std::uint32_t fewest = 16;
  double total = 0;
  for (const NarrowPeak& peak : peaks) total += peak.most;
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  std::uint32_t seed = 13;
  for (const NarrowPeak& peak : peaks) {
    const std::uint32_t count = std::max(fewest, std::uint32_t(points * (peak.most / total)));
    ++seed;  // sets side by side have different patterns
    for (std::uint32_t i = 0; i < count; ++i) {
      const PeakPair point = pairInPeak(peak, brdf.isIsotropic(), scrambledSobol(i, seed), {0, 0});
      if (!(point.weight > 0)) continue;
      pairs.push_back(point.pair);
      weights.push_back(point.weight / count);
    }
  }
  std::vector<Rgb> values(pairs.size());
  brdf.evaluate(pairs, values);
  Rgb sum(0);
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * weights[i];
  return sum;
}

}  // namespace

DirectionalAlbedo::DirectionalAlbedo(const Brdf& brdf, std::uint32_t sampleCount, Peaks peaks)
    : brdf_(brdf),
      density_(estimateSamplingDensity(brdf)),
      sampleCount_(sampleCount),
      bound_(peaks == Peaks::found ? brdf.valueBound() : nullptr) {}

Rgb DirectionalAlbedo::operator()(double theta) const {
  // A fixed number of points for each of the density's two parts, each stratified on its own (multiple importance
  // sampling with the balance heuristic): the choice of a part adds no noise.
  SamplingDensity density = density_;
  const auto specularCount = static_cast<std::uint32_t>(density.specularFraction * sampleCount_);
  density.specularFraction = double(specularCount) / sampleCount_;
  const Direction wo = fromSpherical(theta, 0);
  std::vector<DirectionPair> pairs;
  std::vector<double> weights;
  pairs.reserve(sampleCount_);
  weights.reserve(sampleCount_);
  for (std::uint32_t i = 0; i < sampleCount_; ++i) {
    const bool specular = i < specularCount;
    const glm::dvec2 u = specular ? scrambledSobol(i, 11) : scrambledSobol(i - specularCount, 12);
    const DirectionSample sample = density.sample(wo, {specular ? 0.0 : density.specularFraction, u.x, u.y});
    if (!(sample.pdf > 0)) continue;
    pairs.push_back({sample.wi, wo});
    weights.push_back(sample.wi.z / sample.pdf);
  }
  std::vector<Rgb> values(pairs.size());
  brdf_.evaluate(pairs, values);

  std::vector<NarrowPeak> peaks;
  if (bound_) {
    std::vector<double> brightest(sampleCount_);  // failed samples count as 0
    for (std::size_t i = 0; i < values.size(); ++i) brightest[i] = maxChannel(values[i]) * weights[i];
    const PeakSearch search{.thetaO = theta, .albedo = albedoWithoutPeaks(brightest)};
    peaks = narrowPeaks(*bound_, brdf_.isIsotropic(), search,
                        [&](const DirectionPair& pair) { return density.pdf(pair.wi, pair.wo); });
  }
  const PeakIndex index(peaks, brdf_.isIsotropic());
  Rgb sum(0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (peaks.empty() || !index.contains(pairs[i])) sum += values[i] * weights[i];
  sum /= double(sampleCount_);
  return peaks.empty() ? sum : sum + integralOfPeaks(brdf_, peaks);
}

double DirectionalAlbedo::mostOfPeaks(const Range& theta, double albedo) const {
  if (!bound_) return 0;
  constexpr int steps = 400;
  const bool isotropic = brdf_.isIsotropic();
  double most = 0;
  for (const NarrowPeak& peak :
       narrowPeaks(*bound_, isotropic,
                   {.thetaO = theta, .phiO = isotropic ? Range(0) : Range(0, 2 * pi), .albedo = albedo, .steps = steps},
                   [&](const DirectionPair& pair) { return density_.pdf(pair.wi, pair.wo); }))
    most += peak.most;
  return most;
}

Rgb directionalAlbedo(const Brdf& brdf, double theta) { return DirectionalAlbedo(brdf)(theta); }

}  // namespace gonio
