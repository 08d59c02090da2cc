// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_prediction.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/acquisition/reading_surface.h"
#include "core/acquisition/sample_rows.h"
#include "core/io/csv_text.h"
#include "core/math/monotone_cubic.h"
#include "core/support/error.h"

namespace gonio::acquisition {

namespace {

constexpr double smallestScale = 1e-12;
constexpr double placeTolerance = radians(0.1);  ///< of an angle, and of a distance in the mirror direction
constexpr double samePlace = 1e-9;

struct Reading {
  int index;
  FactorCoordinates place;
  Rgb z;
};

std::string sampleText(const Reading& reading) { return "sample " + std::to_string(reading.index) + ": "; }

std::vector<Reading> readingsOf(const FactorPlan& plan, const MeasuredValues& values, FactorCurve curve) {
  std::vector<Reading> readings;
  for (std::size_t i = 0; i < plan.curves.size(); ++i) {
    if (plan.curves[i] != curve) continue;
    Rgb z;
    for (int channel = 0; channel < 3; ++channel) z[channel] = std::log1p(std::max(0.0, values.rgb[i][channel]));
    readings.push_back(
        {plan.plan.samples[i].index, toFactorCoordinates(plan.axes, plan.plan.samples[i].directions), z});
  }
  if (readings.empty())
    throw Error("found no reading of the curve \"" + std::string(factorCurveNames[std::size_t(curve)]) +
                "\", expected one or more");
  return readings;
}

/// Sorts by a coordinate. @throws Error if two readings are at the same place.
void sortBy(double FactorCoordinates::*coordinate, std::vector<Reading>& readings) {
  std::ranges::stable_sort(readings, {}, [&](const Reading& reading) { return reading.place.*coordinate; });
  const auto same = std::ranges::adjacent_find(readings, [&](const Reading& a, const Reading& b) {
    return b.place.*coordinate - a.place.*coordinate < samePlace;
  });
  if (same != readings.end())
    throw Error(sampleText(*(same + 1)) + "found the same position on the curve as sample " +
                std::to_string(same->index) + ", expected each position once");
}

/// The angle of the `across` readings: that of the one nearest to the mirror direction.
double checkAcross(const FactorPlan& plan, const std::vector<Reading>& across) {
  const auto angleOf = [&](const Reading& reading) {
    const auto sample = std::ranges::find(plan.plan.samples, reading.index, &PlannedSample::index);
    return toFactorCoordinates(readAxes(plan.axes), sample->directions).angle;
  };
  const double fixed = angleOf(across.front());
  for (const Reading& reading : across)
    if (const double angle = angleOf(reading); std::abs(angle - fixed) > placeTolerance)
      throw Error(sampleText(reading) + "found the angle " + io::decimalText(degrees(angle), 2) +
                  " degrees on the curve \"across\", expected " + io::decimalText(degrees(fixed), 2) +
                  ", as in sample " + std::to_string(across.front().index));
  return fixed;
}

void checkAlong(const std::vector<Reading>& along) {
  for (const Reading& reading : along)
    if (reading.place.distance > placeTolerance)
      throw Error(sampleText(reading) + "found the distance " + io::decimalText(reading.place.distance, 4) +
                  " from the mirror direction on the curve \"along\", expected 0");
}

void store(std::array<std::vector<double>, 3>& curves, const Rgb& z) {
  for (int channel = 0; channel < 3; ++channel) curves[std::size_t(channel)].push_back(z[channel]);
}

/// The `along` curve of one channel as a function.
class Along {
 public:
  Along(const FactorMeasurement& m, std::size_t channel)
      : angles_(m.angles), values_(m.along[channel]), slopes_(monotoneSlopes(angles_, values_)) {}
  double operator()(double angle) const { return evaluateMonotoneCubic(angles_, values_, slopes_, angle); }

 private:
  const std::vector<double>&angles_, &values_;
  std::vector<double> slopes_;
};

/// z_m1: the reading in the mirror direction at the fixed angle; without it the `along` curve, or the nearest reading.
double scaleOf(const FactorMeasurement& m, std::size_t channel) {
  const bool isRead = m.distances.front() <= placeTolerance;
  const bool isAlong = m.fixedAngle >= m.angles.front() && m.fixedAngle <= m.angles.back();
  return isRead || !isAlong ? m.across[channel].front() : Along(m, channel)(m.fixedAngle);
}

/// Divides the `across` curve by z_m1.
void normalise(FactorMeasurement& m) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double scale = scaleOf(m, channel);
    m.unscaled[channel] = !(scale > smallestScale);
    if (m.unscaled[channel])
      std::ranges::fill(m.along[channel], 1.0);
    else
      for (double& z : m.across[channel]) z /= scale;
  }
}

/// Removes from the `across` curve the change that is due to theta_d, which differs from the fixed angle beside the
/// mirror direction.
void divideByDifference(FactorMeasurement& m, const std::vector<Reading>& across) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (m.unscaled[channel]) continue;
    const Along along(m, channel);
    for (std::size_t j = 0; j < m.distances.size(); ++j)
      if (const double there = along(across[j].place.angle); there > smallestScale)
        m.across[channel][j] *= along(m.fixedAngle) / there;
  }
}

}  // namespace

FactorMeasurement factorMeasurement(const FactorPlan& plan, const MeasuredValues& values) {
  if (values.rgb.size() != plan.plan.samples.size() || plan.curves.size() != values.rgb.size())
    throw Error("found " + std::to_string(values.rgb.size()) + " values, expected one for each of the " +
                std::to_string(plan.plan.samples.size()) + " readings");
  checkMeasured(plan.plan, values);
  std::vector<Reading> along = readingsOf(plan, values, FactorCurve::along);
  std::vector<Reading> across = readingsOf(plan, values, FactorCurve::across);
  checkAlong(along);
  sortBy(&FactorCoordinates::angle, along);
  sortBy(&FactorCoordinates::distance, across);
  FactorMeasurement m{.axes = plan.axes, .fixedAngle = checkAcross(plan, across)};
  if (plan.axes == FactorAxes::adaptive) m.all = {plan, values};
  for (const Reading& reading : along) {
    m.angles.push_back(reading.place.angle);
    store(m.along, reading.z);
  }
  for (const Reading& reading : across) {
    m.distances.push_back(reading.place.distance);
    store(m.across, reading.z);
  }
  for (std::size_t channel = 0; channel < 3; ++channel)
    m.highest[channel] = std::max(std::ranges::max(m.along[channel]), std::ranges::max(m.across[channel]));
  m.acrossRead = m.across;
  normalise(m);
  if (plan.axes != readAxes(plan.axes)) divideByDifference(m, across);
  return m;
}

FactorMeasurement measureFactors(const Brdf& material, const FactorPlanOptions& options,
                                 const MeasurementNoise& noise) {
  const FactorPlan plan = planFactors(options);
  return factorMeasurement(plan, measure(material, plan.plan, noise));
}

namespace {

class PredictedBrdf final : public Brdf {
 public:
  PredictedBrdf(const FactorMeasurement& m, FactorBound bound) : m_(m), bound_(bound) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      alongSlopes_[channel] = monotoneSlopes(m.angles, m.along[channel]);
      acrossSlopes_[channel] = monotoneSlopes(m.distances, m.across[channel]);
      readSlopes_[channel] = monotoneSlopes(m.distances, m.acrossRead[channel]);
    }
  }

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = evaluatePair(pairs[i]);
  }
  bool isReciprocal() const override { return bound_ == FactorBound::readings || areReciprocal(m_.axes); }

  struct Product {
    Rgb z, limit;  ///< of ln(1 + rho): the product without bound, the larger of the two interpolated readings
  };
  Product product(const DirectionPair& pair) const {
    const FactorCoordinates at = toFactorCoordinates(m_.axes, pair);
    Product result;
    for (std::size_t c = 0; c < 3; ++c) {
      const double along = evaluateMonotoneCubic(m_.angles, m_.along[c], alongSlopes_[c], at.angle);
      const double read = evaluateMonotoneCubic(m_.distances, m_.acrossRead[c], readSlopes_[c], at.distance);
      result.z[int(c)] = along * evaluateMonotoneCubic(m_.distances, m_.across[c], acrossSlopes_[c], at.distance);
      // The `along` curve of an unscaled channel is not its readings.
      result.limit[int(c)] = m_.unscaled[c] ? read : std::max(along, read);
    }
    return result;
  }

 private:
  Rgb evaluatePair(const DirectionPair& pair) const {
    if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return Rgb(0);
    const Product found = product(pair);
    Rgb z = found.z;
    if (bound_ == FactorBound::readings) {
      z = glm::min(z, found.limit);
      if (!areReciprocal(m_.axes)) {
        const Product exchanged = product({pair.wo, pair.wi});
        z = glm::min(z, glm::min(exchanged.z, exchanged.limit));
      }
    }
    for (int c = 0; c < 3; ++c) z[c] = inverseTransformed(DataTransform::logPlus, z[c], 1);
    return z;
  }

  FactorMeasurement m_;
  FactorBound bound_;
  std::array<std::vector<double>, 3> alongSlopes_, acrossSlopes_, readSlopes_;
};

/// Whether rho of the logarithm z is more than twice that of the logarithm `limit`, in a channel that is not dark.
bool isFarAbove(const Rgb& z, const Rgb& limit) {
  constexpr double dark = 1e-4;  // 1/sr
  for (int c = 0; c < 3; ++c)
    if (const double rho = std::expm1(z[c]); rho > dark && rho > 2 * std::expm1(limit[c])) return true;
  return false;
}

void addFractions(const FactorMeasurement& m, int stepDegrees, FactorSupport& support) {
  const PredictedBrdf predicted(m, FactorBound::none);
  double total = 0;
  const int thetas = 90 / stepDegrees, phis = 180 / stepDegrees;
  const auto angle = [&](int step) { return radians(stepDegrees * (step + 0.5)); };
  for (int thetaI = 0; thetaI < thetas; ++thetaI)
    for (int thetaO = 0; thetaO < thetas; ++thetaO)
      for (int phi = 0; phi < phis; ++phi) {
        const double i = angle(thetaI), o = angle(thetaO);
        const DirectionPair pair{fromSpherical(i, angle(phi)), fromSpherical(o, 0)};
        const double weight = std::sin(2 * i) * std::sin(2 * o);
        const FactorCoordinates at = toFactorCoordinates(m.axes, pair);
        total += weight;
        if (at.angle < m.angles.front() || at.angle > m.angles.back() || at.distance > m.distances.back())
          support.extrapolated += weight;
        if (m.axes == FactorAxes::adaptive) continue;
        const auto [z, limit] = predicted.product(pair);
        const Rgb exchanged = areReciprocal(m.axes) ? z : predicted.product({pair.wo, pair.wi}).z;
        if (isFarAbove(z, exchanged) || isFarAbove(exchanged, z)) support.contradicted += weight;
        if (isFarAbove(z, limit)) support.bounded += weight;
      }
  for (double* fraction : {&support.contradicted, &support.extrapolated, &support.bounded}) *fraction /= total;
}

std::string percent(double fraction) { return std::to_string(int(std::lround(100 * fraction))) + " %"; }

/// Whether the second `across` reading is already below half of the first, in the channel with the largest reading.
bool isHighlightMissed(const FactorMeasurement& m) {
  const auto brightest = std::size_t(std::ranges::max_element(m.highest) - m.highest.begin());
  const std::vector<double>& across = m.across[brightest];
  return across.size() < 2 || across[1] < 0.5 * across[0];
}

bool hasFurther(const FactorPlan& plan) {
  return std::ranges::find(plan.curves, FactorCurve::further) != plan.curves.end();
}

void addWarnings(const FactorMeasurement& m, FactorSupport& support) {
  constexpr double many = 0.1, blowUp = 0.01;
  if (support.contradicted > many)
    support.warnings.push_back("Unreliable for " + percent(support.contradicted) +
                               " of the directions: the product of the curves is not reciprocal (exchanging light and "
                               "viewer changes it by more than a "
                               "factor of 2). Use the axes symmetric deviation or half-difference.");
  if (support.extrapolated > many)
    support.warnings.push_back(
        "Unreliable for " + percent(support.extrapolated) +
        " of the directions: they lie outside the two curves, where the last reading is used. Use "
        "another fixed angle.");
  if (m.axes == FactorAxes::adaptive && !hasFurther(m.all.plan))
    support.warnings.push_back(
        "The readings lie on two curves only: how the highlight changes with the angle is not known. Add readings at "
        "further angles.");
  if (support.bounded > blowUp)
    support.warnings.push_back(
        "Unreliable for " + percent(support.bounded) +
        " of the directions: the product of the curves is more than twice as large as the readings "
        "at the same angle and at the same distance.");
  if (isHighlightMissed(m))
    support.warnings.push_back(
        "The highlight is narrower than the spacing of its readings. Use more readings around the mirror direction.");
  for (std::size_t c = 0; c < 3; ++c)
    if (m.unscaled[c] && m.highest[c] > 0 && m.axes != FactorAxes::adaptive)
      support.warnings.push_back(std::string("Unreliable in ") + channelNames[c] +
                                 ": the mirror direction is black at the fixed angle, so the readings around the "
                                 "mirror direction are used for all angles. Use another fixed angle.");
}

/// Curves from 0: the first value is constant down to there.
void startAtZero(std::vector<double>& nodes, std::array<std::vector<double>, 3>& curves) {
  if (nodes.front() <= 0) return;
  nodes.insert(nodes.begin(), 0.0);
  for (std::vector<double>& curve : curves) curve.insert(curve.begin(), curve.front());
}

}  // namespace

FactorBound factorBoundNamed(std::string_view name) {
  const auto found = std::ranges::find(factorBoundNames, name);
  if (found == factorBoundNames.end())
    throw Error("found the bound '" + std::string(name) + "', expected readings or none");
  return FactorBound(found - factorBoundNames.begin());
}

std::shared_ptr<const Brdf> predictFromFactors(const FactorMeasurement& measurement, FactorBound bound) {
  if (measurement.axes == FactorAxes::adaptive) return fitReadings(measurement.all, bound == FactorBound::readings);
  return std::make_shared<const PredictedBrdf>(measurement, bound);
}

FactorSupport supportOf(const FactorMeasurement& measurement, int stepDegrees) {
  if (stepDegrees < 1 || 90 % stepDegrees != 0)
    throw Error("found a step of " + std::to_string(stepDegrees) + " degrees, expected a divisor of 90");
  FactorSupport support;
  addFractions(measurement, stepDegrees, support);
  addWarnings(measurement, support);
  return support;
}

factorization::PdvFactors pdvFactorsOfCurves(const FactorMeasurement& measurement) {
  if (measurement.axes != FactorAxes::projectedDeviation)
    throw Error("PDV factors have the axes projected-deviation, found " +
                std::string(factorAxesNames[std::size_t(measurement.axes)]));
  FactorMeasurement m = measurement;
  startAtZero(m.angles, m.along);
  startAtZero(m.distances, m.across);
  factorization::PdvFactors factors{.form = factorization::PdvForm::twoFactors,
                                    .transform = DataTransform::logPlus,
                                    .thetaNodes = m.angles,
                                    .deviationNodes = m.distances,
                                    .phiNodes = {0},
                                    .channels = {},
                                    .highest = std::ranges::max(m.highest)};
  for (std::size_t c = 0; c < 3; ++c) {
    const double scale = std::max(1e-12, std::ranges::max(m.across[c]));
    for (double& f1 : m.along[c]) f1 *= scale;
    for (double& f2 : m.across[c]) f2 /= scale;
    factors.channels[c].push_back({.f1 = m.along[c], .f2 = m.across[c], .f3 = {1}});
  }
  return factors;
}

}  // namespace gonio::acquisition
