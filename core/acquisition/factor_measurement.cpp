// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_measurement.h"

#include <algorithm>
#include <cmath>
#include <string>

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
  // theta_d of a reading beside the mirror direction is not the fixed angle: theta_R is.
  const FactorAxes axes = plan.axes == FactorAxes::symmetricDeviation ? FactorAxes::projectedDeviation : plan.axes;
  const auto angleOf = [&](const Reading& reading) {
    const auto sample = std::ranges::find(plan.plan.samples, reading.index, &PlannedSample::index);
    return toFactorCoordinates(axes, sample->directions).angle;
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
  if (plan.axes == FactorAxes::symmetricDeviation) divideByDifference(m, across);
  return m;
}

FactorMeasurement measureFactors(const Brdf& material, const FactorPlanOptions& options,
                                 const MeasurementNoise& noise) {
  const FactorPlan plan = planFactors(options);
  return factorMeasurement(plan, measure(material, plan.plan, noise));
}

}  // namespace gonio::acquisition
