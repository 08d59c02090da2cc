// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/research/acquisition/factor_measurement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/math/monotone_cubic.h"
#include "core/support/error.h"

namespace gonio::acquisition {

namespace {

constexpr double minScale = 1e-12, headroom = 2;
const double maxAngle = radians(89);

struct Place {
  double angle, distance;
};

Place placeOf(FactorAxes axes, const DirectionPair& pair) {
  if (axes == FactorAxes::projectedDeviation) {
    const ProjectedDeviation at = toProjectedDeviation(pair.wi, pair.wo);
    return {at.thetaR, at.deviation};
  }
  if (axes == FactorAxes::halfOut) {
    const HalfOut at = toHalfOut(pair.wi, pair.wo);
    return {at.thetaO, at.thetaH};
  }
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  if (axes == FactorAxes::symmetricDeviation) return {at.thetaD, toProjectedDeviation(pair.wi, pair.wo).deviation};
  return {at.thetaD, at.thetaH};
}

bool isDeviation(FactorAxes axes) {
  return axes == FactorAxes::projectedDeviation || axes == FactorAxes::symmetricDeviation;
}

/// Both arms in the plane of incidence; none where the light would be below the horizon.
std::optional<DirectionPair> armsAt(FactorAxes axes, const Place& at) {
  DirectionPair pair;
  if (isDeviation(axes)) {
    const ProjectedDirections found = fromProjectedDeviation({at.angle, at.distance, 0});
    if (!found.valid) return std::nullopt;
    pair = found.pair;
  } else if (axes == FactorAxes::halfOut) {
    const HalfOutDirections found = fromHalfOut({.thetaO = at.angle, .thetaH = at.distance, .phiH = 0, .valid = true});
    if (!found.valid) return std::nullopt;
    pair = found.pair;
  } else {
    pair = fromHalfDifference(at.distance, at.angle, 0);
  }
  if (pair.wi.z < std::cos(maxAngle) * (1 - 1e-9) || pair.wo.z < std::cos(maxAngle) * (1 - 1e-9)) return std::nullopt;
  return pair;
}

class Goniometer {
 public:
  Goniometer(const Brdf& material, const FactorMeasurementOptions& options)
      : material_(material), options_(options), random_(options.seed) {}

  /// ln(1 + rho), unless something stands in the way.
  std::optional<Rgb> read(const Place& at) {
    const std::optional<DirectionPair> arms = armsAt(options_.axes, at);
    if (!arms || glm::length(arms->wi - arms->wo) < 2 * std::sin(options_.blockedAngle / 2)) return std::nullopt;
    Rgb rho = material_.evaluate(arms->wi, arms->wo);
    for (int channel = 0; channel < 3; ++channel) {
      if (options_.noise > 0) rho[channel] *= 1 + options_.noise * gaussian_(random_);
      rho[channel] = std::log1p(std::max(0.0, rho[channel]));
    }
    return rho;
  }

 private:
  const Brdf& material_;
  const FactorMeasurementOptions& options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> gaussian_;
};

void checkOptions(const FactorMeasurementOptions& o) {
  if (!(o.fixedAngle >= 0 && o.fixedAngle <= maxAngle)) throw Error("the fixed angle must be 0 to 89 degrees");
  if (o.angles < 2 || o.distances < 2) throw Error("each curve needs two readings or more");
  if (!(o.noise >= 0) || !std::isfinite(o.noise)) throw Error("the noise must be a number, 0 or more");
}

void store(std::array<std::vector<double>, 3>& curves, const Rgb& z) {
  for (int channel = 0; channel < 3; ++channel) curves[std::size_t(channel)].push_back(z[channel]);
}

/// Takes out of the curve across what it owes to theta_d, which is not the fixed angle beside the mirror direction.
void divideByDifference(FactorMeasurement& m, double fixedAngle) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (m.unscaled[channel]) continue;
    const std::vector<double> slopes = monotoneSlopes(m.angles, m.along[channel]);
    const auto along = [&](double angle) { return evaluateMonotoneCubic(m.angles, m.along[channel], slopes, angle); };
    for (std::size_t j = 0; j < m.distances.size(); ++j) {
      const auto arms = armsAt(m.axes, {fixedAngle, m.distances[j]});
      const double there = along(placeOf(m.axes, *arms).angle);
      if (there > minScale) m.across[channel][j] *= along(fixedAngle) / there;
    }
  }
}

class PredictedBrdf final : public Brdf {
 public:
  explicit PredictedBrdf(const FactorMeasurement& m) : m_(m) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      alongSlopes_[channel] = monotoneSlopes(m.angles, m.along[channel]);
      acrossSlopes_[channel] = monotoneSlopes(m.distances, m.across[channel]);
    }
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = evaluatePair(pairs[i]);
  }
  bool isReciprocal() const override { return false; }

 private:
  Rgb evaluatePair(const DirectionPair& pair) const {
    if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return Rgb(0);
    const Place at = placeOf(m_.axes, pair);
    Rgb result;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double z = evaluateMonotoneCubic(m_.angles, m_.along[channel], alongSlopes_[channel], at.angle) *
                       evaluateMonotoneCubic(m_.distances, m_.across[channel], acrossSlopes_[channel], at.distance);
      result[int(channel)] = std::expm1(std::clamp(z, 0.0, m_.highest));
    }
    return result;
  }

  FactorMeasurement m_;
  std::array<std::vector<double>, 3> alongSlopes_, acrossSlopes_;
};

}  // namespace

FactorMeasurement measureFactors(const Brdf& material, const FactorMeasurementOptions& options) {
  checkOptions(options);
  Goniometer goniometer(material, options);
  FactorMeasurement m{.axes = options.axes};
  for (int i = 0; i < options.angles; ++i) {
    const double angle = maxAngle * i / (options.angles - 1);
    const std::optional<Rgb> z = goniometer.read({angle, 0});
    if (!z) continue;
    m.angles.push_back(angle);
    store(m.along, *z);
  }
  const double last = isDeviation(options.axes) ? 2 : halfPi;
  for (int j = 0; j < options.distances; ++j) {
    const double fraction = double(j) / (options.distances - 1), distance = last * fraction * fraction;
    const std::optional<Rgb> z = goniometer.read({options.fixedAngle, distance});
    if (!z) continue;
    m.distances.push_back(distance);
    store(m.across, *z);
  }
  m.unreadable = options.angles + options.distances - int(m.angles.size() + m.distances.size());
  if (m.angles.empty() || m.distances.empty()) throw Error("the arms stand in each other's way at the fixed angle");
  for (const auto* curves : {&m.along, &m.across})
    for (const std::vector<double>& curve : *curves)
      for (const double z : curve) m.highest = std::max(m.highest, z + headroom);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double scale = m.across[channel].front();
    m.unscaled[channel] = !(scale > minScale);
    if (m.unscaled[channel])
      std::fill(m.along[channel].begin(), m.along[channel].end(), 1.0);
    else
      for (double& z : m.across[channel]) z /= scale;
  }
  if (options.axes == FactorAxes::symmetricDeviation) divideByDifference(m, options.fixedAngle);
  return m;
}

std::shared_ptr<const Brdf> predictFromFactors(const FactorMeasurement& measurement) {
  return std::make_shared<const PredictedBrdf>(measurement);
}

}  // namespace gonio::acquisition
