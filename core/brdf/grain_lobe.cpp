// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/grain_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/brdf/moment_probes.h"
#include "core/brdf/tabulated_lobe.h"

namespace gonio {

namespace {

constexpr double minAlpha = 1e-3, maxAlpha = 1;
/// A share while the widths are sought.
constexpr double searchFraction = 0.7;
constexpr std::array fractions{0.2, 0.4, 0.6, 0.75, 0.9};
/// What a grain must save of the second moment: where it saves less, pictures under an environment, which also sample
/// the light, have no less noise.
constexpr double minLobeGain = 0.5;

/// The second moment of the estimator as a function of the grain.
class Moment {
 public:
  Moment(const Brdf& brdf, const TabulatedLobe& mean, double cosineFraction)
      : cosineShare_(cosineFraction), probes_(momentProbes(brdf)) {
    for (const MomentProbe& probe : probes_) means_.push_back(mean.density(probe.pair.wi, probe.pair.wo));
  }

  double operator()(const GrainLobe& grain) const {
    const RotatedLobe<VisibleNormalLobe> lobe = grain.lobe();
    return secondMoment(probes_, [&, mean = means_.begin()](const MomentProbe& probe) mutable {
      const double along = grain.fraction > 0 ? lobe.density(probe.pair.wi, probe.pair.wo) : 0;
      const double rest = (1 - grain.fraction) * *mean++ + grain.fraction * along;
      return cosineShare_ * probe.pair.wi.z / pi + (1 - cosineShare_) * rest;
    });
  }

 private:
  double cosineShare_;
  std::vector<MomentProbe> probes_;
  std::vector<double> means_;  ///< densities of the azimuths' mean
};

struct Rated {
  GrainLobe grain;
  double moment = std::numeric_limits<double>::infinity();

  void consider(const Moment& moments, GrainLobe other) {
    other.alphaX = std::clamp(other.alphaX, minAlpha, maxAlpha);
    other.alphaY = std::clamp(other.alphaY, minAlpha, maxAlpha);
    const double found = moments(other);
    if (found < moment) *this = {other, found};
  }
};

/// The best of round lobes, then of those drawn apart in some directions.
Rated coarseGrain(const Moment& moments) {
  constexpr int widths = 12, directions = 8;
  Rated best;
  for (int i = 0; i < widths; ++i) {
    const double alpha = minAlpha * std::pow(maxAlpha / minAlpha, double(i) / (widths - 1));
    best.consider(moments, {alpha, alpha, 0, searchFraction});
  }
  const double round = best.grain.alphaX;
  for (const double stretch : {1.6, 3.0})
    for (int direction = 0; direction < directions; ++direction)
      best.consider(moments, {round / stretch, round * stretch, pi * direction / directions, searchFraction});
  return best;
}

/// Steps along the widths and the rotation, halved where none helps.
void refine(const Moment& moments, Rated& best) {
  constexpr double firstStep = 0.5, lastStep = 0.05;
  for (double step = firstStep; step > lastStep;) {
    const GrainLobe from = best.grain;
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

GrainLobe estimateGrainLobe(const Brdf& brdf, const TabulatedLobe& azimuthMean, double cosineFraction) {
  if (brdf.isIsotropic()) return {};
  const Moment moments(brdf, azimuthMean, cosineFraction);
  const double without = moments({});
  Rated best = coarseGrain(moments);
  refine(moments, best);
  for (const double fraction : fractions) {
    GrainLobe other = best.grain;
    other.fraction = fraction;
    best.consider(moments, other);
  }
  return best.moment < (1 - minLobeGain) * without ? best.grain : GrainLobe{};
}

bool areSimilar(const GrainLobe& a, const GrainLobe& b) {
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
