// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/fitted_densities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/brdf/density_mixture.h"
#include "core/sampling/tabulated_density.h"

namespace gonio {

namespace {

constexpr std::array fittedDegrees{10.0, 40.0, 65.0};

/// Adds probes of one viewer on rings, each rotated against the one before.
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

std::vector<MomentProbe> probesOf(const Brdf& brdf, std::span<const double> viewerDegrees, int azimuthCount,
                                  int spokes) {
  // Not evenly over the turn: the two sides of a surface mostly look the same.
  constexpr double azimuthStep = 2 * pi * 0.381966011250105, first = 0.2;
  std::vector<MomentProbe> probes;
  for (const double degrees : viewerDegrees)
    for (int azimuth = 0; azimuth < azimuthCount; ++azimuth)
      addProbes(brdf, fromSpherical(radians(degrees), first + azimuth * azimuthStep), spokes, probes);
  for (MomentProbe& probe : probes) probe.energy /= double(viewerDegrees.size()) * azimuthCount;
  return probes;
}

constexpr double minAlpha = 1e-3, maxAlpha = 1, maxSpecularFraction = 0.95;
/// A fraction while the widths are optimised.
constexpr double searchFraction = 0.7;
constexpr std::array grainFractions{0.2, 0.4, 0.6, 0.75, 0.9};
/// Fraction of the second moment that an anisotropic density must save: if it saves less, pictures under an
/// environment, which also sample the light, have no less noise.
constexpr double minGrainGain = 0.5;

/// The second moment of the estimator as a function of the grain.
class GrainMoment {
 public:
  GrainMoment(const Brdf& brdf, const TabulatedDensity& mean, double cosineFraction)
      : cosineShare_(cosineFraction), probes_(momentProbes(brdf)) {
    for (const MomentProbe& probe : probes_) means_.push_back(mean.density(probe.pair.wi, probe.pair.wo));
  }

  double operator()(const GrainDensity& grain) const {
    const RotatedDensity<VisibleNormalDensity> density = grain.rotated();
    return secondMoment(probes_, [&, mean = means_.begin()](const MomentProbe& probe) mutable {
      const double along = grain.fraction > 0 ? density.density(probe.pair.wi, probe.pair.wo) : 0;
      const double rest = (1 - grain.fraction) * *mean++ + grain.fraction * along;
      return cosineShare_ * probe.pair.wi.z / pi + (1 - cosineShare_) * rest;
    });
  }

 private:
  double cosineShare_;
  std::vector<MomentProbe> probes_;
  std::vector<double> means_;  ///< densities of the azimuths' mean
};

struct RatedGrain {
  GrainDensity grain;
  double moment = std::numeric_limits<double>::infinity();

  void consider(const GrainMoment& moments, GrainDensity other) {
    other.alphaX = std::clamp(other.alphaX, minAlpha, maxAlpha);
    other.alphaY = std::clamp(other.alphaY, minAlpha, maxAlpha);
    const double found = moments(other);
    if (found < moment) *this = {other, found};
  }
};

/// The best of round densities, then of those drawn apart in some directions.
RatedGrain coarseGrain(const GrainMoment& moments) {
  constexpr int widths = 12, rotations = 8;
  RatedGrain best;
  for (int i = 0; i < widths; ++i) {
    const double alpha = minAlpha * std::pow(maxAlpha / minAlpha, double(i) / (widths - 1));
    best.consider(moments, {alpha, alpha, 0, searchFraction});
  }
  const double round = best.grain.alphaX;
  for (const double stretch : {1.6, 3.0})
    for (int step = 0; step < rotations; ++step)
      best.consider(moments, {round / stretch, round * stretch, pi * step / rotations, searchFraction});
  return best;
}

/// Steps along the widths and the rotation, halved where none helps.
void refineGrain(const GrainMoment& moments, RatedGrain& best) {
  constexpr double firstStep = 0.5, lastStep = 0.05;
  for (double step = firstStep; step > lastStep;) {
    const GrainDensity from = best.grain;
    const double before = best.moment, factor = std::exp(step), turn = step * pi / 8;
    for (const double along : {factor, 1 / factor}) {
      best.consider(moments, {from.alphaX * along, from.alphaY, from.rotation, from.fraction});
      best.consider(moments, {from.alphaX, from.alphaY * along, from.rotation, from.fraction});
      best.consider(moments, {from.alphaX * along, from.alphaY * along, from.rotation, from.fraction});
    }
    for (const double angle : {turn, -turn})
      best.consider(moments, {from.alphaX, from.alphaY, from.rotation + angle, from.fraction});
    if (!(best.moment < before * (1 - 1e-3))) step /= 2;
  }
}

}  // namespace

std::vector<MomentProbe> momentProbes(const Brdf& brdf) {
  return brdf.isIsotropic() ? probesOf(brdf, std::array{10.0, 40.0, 65.0, 80.0}, 1, 8)
                            : probesOf(brdf, fittedDegrees, 5, 32);
}

std::vector<MomentProbe> isotropicMomentProbes(const Brdf& brdf) { return probesOf(brdf, fittedDegrees, 1, 8); }

DirectionSample SamplingDensity::sample(const Direction& wo, const glm::dvec3& u) const {
  const glm::dvec2 point(u.y, u.z);
  const Direction wi =
      u.x < specularFraction ? VisibleNormalDensity{roughness}.sample(wo, point) : CosineDensity{}.sample(wo, point);
  return {wi, pdf(wi, wo)};
}

double SamplingDensity::pdf(const Direction& wi, const Direction& wo) const {
  if (!(wi.z > 0)) return 0;
  return (1 - specularFraction) * CosineDensity{}.density(wi, wo) +
         specularFraction * VisibleNormalDensity{roughness}.density(wi, wo);
}

bool areSimilar(const SamplingDensity& a, const SamplingDensity& b) {
  constexpr double sameFraction = 0.15, sameWidth = 0.4;  // more than a step of the fit
  return std::abs(a.specularFraction - b.specularFraction) < sameFraction &&
         std::abs(std::log(a.roughness / b.roughness)) < sameWidth;
}

SamplingDensity estimateSamplingDensity(const Brdf& brdf) {
  constexpr int roughnessSteps = 25;
  constexpr std::array fractions{0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, maxSpecularFraction};

  // The second moment of the estimator is what the fit makes small.
  const std::vector<MomentProbe> probes = isotropicMomentProbes(brdf);
  std::array<std::array<double, fractions.size()>, roughnessSteps> moments{};
  const auto roughnessAt = [](int step) {
    return minAlpha * std::pow(maxAlpha / minAlpha, double(step) / (roughnessSteps - 1));
  };
  for (int step = 0; step < roughnessSteps; ++step)
    for (const MomentProbe& probe : probes) {
      const double specularPdf = VisibleNormalDensity{roughnessAt(step)}.density(probe.pair.wi, probe.pair.wo);
      for (std::size_t fraction = 0; fraction < fractions.size(); ++fraction) {
        const double density = (1 - fractions[fraction]) * probe.pair.wi.z / pi + fractions[fraction] * specularPdf;
        moments[std::size_t(step)][fraction] += probe.energy / density;
      }
    }
  SamplingDensity best{.roughness = 0.3, .specularFraction = 0};
  double smallest = moments[0][0];
  for (int step = 0; step < roughnessSteps; ++step)
    for (std::size_t fraction = 0; fraction < fractions.size(); ++fraction)
      if (moments[std::size_t(step)][fraction] < smallest * (1 - 1e-9)) {
        smallest = moments[std::size_t(step)][fraction];
        best = {.roughness = roughnessAt(step), .specularFraction = fractions[fraction]};
      }
  return best;
}

GrainDensity estimateGrainDensity(const Brdf& brdf, const TabulatedDensity& azimuthMean, double cosineFraction) {
  if (brdf.isIsotropic()) return {};
  const GrainMoment moments(brdf, azimuthMean, cosineFraction);
  const double without = moments({});
  RatedGrain best = coarseGrain(moments);
  refineGrain(moments, best);
  for (const double fraction : grainFractions) {
    GrainDensity other = best.grain;
    other.fraction = fraction;
    best.consider(moments, other);
  }
  return best.moment < (1 - minGrainGain) * without ? best.grain : GrainDensity{};
}

bool areSimilar(const GrainDensity& a, const GrainDensity& b) {
  constexpr double sameFraction = 0.1, sameWidth = 0.25;
  if (a.fraction == 0 && b.fraction == 0) return true;
  if (std::abs(a.fraction - b.fraction) > sameFraction) return false;
  const auto apart = [](double one, double other) { return std::abs(std::log(one / other)); };
  if (std::max(apart(a.alphaX, b.alphaX), apart(a.alphaY, b.alphaY)) > sameWidth) return false;
  // A long ridge is missed where it is turned by its own width.
  const double ratio = std::min(a.alphaX, a.alphaY) / std::max(a.alphaX, a.alphaY);
  const double turned = std::abs(std::remainder(a.rotation - b.rotation, pi));
  return turned < sameWidth * ratio || ratio > 1 - sameWidth;
}

}  // namespace gonio
