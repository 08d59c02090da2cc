// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "core/acquisition/measured_values.h"
#include "core/acquisition/sample_rows.h"
#include "core/acquisition/sampling_plan.h"
#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

FactorAxes factorAxesNamed(std::string_view name) {
  const auto found = std::ranges::find(factorAxesNames, name);
  if (found == factorAxesNames.end())
    throw Error("factor axes: found '" + std::string(name) +
                "', expected projected-deviation, symmetric-deviation, half-difference, half-out or adaptive");
  return FactorAxes(found - factorAxesNames.begin());
}

FactorCoordinates toFactorCoordinates(FactorAxes axes, const DirectionPair& pair) {
  switch (axes) {
    case FactorAxes::projectedDeviation: {
      const ProjectedDeviation at = toProjectedDeviation(pair.wi, pair.wo);
      return {at.thetaR, at.deviation};
    }
    case FactorAxes::symmetricDeviation:
    case FactorAxes::adaptive:
      return {toHalfDifference(pair.wi, pair.wo).thetaD, toProjectedDeviation(pair.wi, pair.wo).deviation};
    case FactorAxes::halfDifference: {
      const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
      return {at.thetaD, at.thetaH};
    }
    default: {
      const HalfOut at = toHalfOut(pair.wi, pair.wo);
      return {at.thetaO, at.thetaH};
    }
  }
}

std::optional<DirectionPair> fromFactorCoordinates(FactorAxes axes, const FactorCoordinates& place) {
  if (isDeviation(axes)) {
    const ProjectedDirections found = fromProjectedDeviation({place.angle, place.distance, 0});
    return found.valid ? std::optional(found.pair) : std::nullopt;
  }
  if (axes == FactorAxes::halfOut) {
    const HalfOutDirections found =
        fromHalfOut({.thetaO = place.angle, .thetaH = place.distance, .phiH = 0, .valid = true});
    return found.valid ? std::optional(found.pair) : std::nullopt;
  }
  const DirectionPair pair = fromHalfDifference(place.distance, place.angle, 0);
  if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) return std::nullopt;
  return pair;
}

namespace {

constexpr int maxReadings = 2'000;
constexpr std::string_view methodPrefix = "factors, ";

void checkOptions(const FactorPlanOptions& o) {
  if (!(o.maxPolarAngle > 0 && o.maxPolarAngle < halfPi))
    throw Error("factor measurement: found the maximum polar angle " + numberText(degrees(o.maxPolarAngle)) +
                " degrees, expected above 0 and below 90");
  if (!(o.fixedAngle >= 0 && o.fixedAngle <= o.maxPolarAngle))
    throw Error("factor measurement: found the fixed angle " + numberText(degrees(o.fixedAngle)) +
                " degrees, expected from 0 to the maximum polar angle, " + numberText(degrees(o.maxPolarAngle)));
  for (const int count : {o.angles, o.distances})
    if (count < 2 || count > maxReadings)
      throw Error("factor measurement: found " + std::to_string(count) + " readings of a curve, expected 2 to " +
                  std::to_string(maxReadings));
  if (!(o.minSeparation >= 0 && o.minSeparation <= pi))
    throw Error("factor measurement: found the minimum separation of the arms " + numberText(degrees(o.minSeparation)) +
                " degrees, expected from 0 to 180");
}

/// Appends a reading, or counts it as blocked.
void append(FactorCurve curve, const std::optional<DirectionPair>& arms, const FactorPlanOptions& options,
            FactorPlan& result) {
  const double lowest = std::cos(options.maxPolarAngle) * (1 - 1e-9);
  if (!arms || arms->wi.z < lowest || arms->wo.z < lowest ||
      glm::length(arms->wi - arms->wo) < 2 * std::sin(options.minSeparation / 2)) {
    ++result.blocked;
    return;
  }
  const int index = int(result.plan.samples.size()) + 1;
  result.plan.samples.push_back({index, *arms, index});
  result.curves.push_back(curve);
}

void appendCurves(int angles, int distances, const FactorPlanOptions& options, FactorPlan& result) {
  for (int i = 0; i < angles; ++i)
    append(FactorCurve::along, fromFactorCoordinates(options.axes, {options.maxPolarAngle * i / (angles - 1), 0}),
           options, result);
  const double last = isDeviation(options.axes) ? 2 : halfPi;
  for (int j = 0; j < distances; ++j) {
    const double fraction = double(j) / (distances - 1);
    append(FactorCurve::across, fromFactorCoordinates(options.axes, {options.fixedAngle, last * fraction * fraction}),
           options, result);
  }
}

/// Readings with the viewer at one angle, three tenths of them between the mirror direction and the horizon: evenly
/// spaced in the square root of the distance, without the mirror direction itself.
void appendFurther(double viewer, int count, const FactorPlanOptions& options, FactorPlan& result) {
  constexpr double farthestLight = radians(80);  // beyond the viewer
  const double mirror = -std::sin(viewer), highest = std::sin(options.maxPolarAngle);
  const int beyond = int(std::lround(0.3 * count));
  const auto appendSide = [&](int readings, double end) {
    for (int i = 1; i <= readings; ++i) {
      const double fraction = double(i) / readings;
      const double x = mirror + (end - mirror) * fraction * fraction;
      const DirectionPair arms{{x, 0, std::sqrt(std::max(0.0, 1 - x * x))}, fromSpherical(viewer, 0)};
      append(FactorCurve::further, arms, options, result);
    }
  };
  appendSide(count - beyond, std::min(highest, std::sin(farthestLight)));
  appendSide(beyond, -highest);
}

/// The angles of the viewer for `further` readings: as many as the number of readings allows.
std::vector<double> furtherAngles(int readings, double fixedAngle) {
  constexpr std::array angles{25.0, 75.0, 42.0, 10.0, 52.0};  // by importance
  constexpr int readingsPerAngle = 20;
  const int count = std::clamp(readings / readingsPerAngle, 1, int(angles.size()));
  std::vector<double> result;
  for (int i = 0; i < count; ++i)
    if (const double angle = radians(angles[std::size_t(i)]); std::abs(angle - fixedAngle) > radians(5))
      result.push_back(angle);
  std::ranges::sort(result);
  return result;
}

}  // namespace

FactorPlan planFactors(const FactorPlanOptions& options) {
  checkOptions(options);
  FactorPlan result{.axes = options.axes, .plan = {}, .curves = {}};
  result.plan.method = factorMethod(options.axes);
  if (options.axes == FactorAxes::adaptive) {
    const int readings = options.angles + options.distances;
    const std::vector<double> viewers = furtherAngles(readings, options.fixedAngle);
    const int along = std::max(2, int(std::lround(readings * 2.0 / 9)));
    const int each = std::max(0, (readings - 2 * along) / int(viewers.size()));
    appendCurves(along, std::max(2, readings - along - each * int(viewers.size())), options, result);
    for (const double viewer : viewers) appendFurther(viewer, each, options, result);
  } else {
    appendCurves(options.angles, options.distances, options, result);
  }
  for (const FactorCurve curve : {FactorCurve::along, FactorCurve::across})
    if (std::ranges::find(result.curves, curve) == result.curves.end())
      throw Error("factor measurement: the rig reaches no reading of the curve \"" +
                  std::string(factorCurveNames[std::size_t(curve)]) +
                  "\": each is below the horizon, beyond the maximum polar angle or obstructed by the other arm");
  return result;
}

std::string factorMethod(FactorAxes axes) {
  return std::string(methodPrefix) + std::string(factorAxesNames[std::size_t(axes)]);
}

std::optional<FactorAxes> axesOfFactorMethod(std::string_view method) {
  if (!method.starts_with(methodPrefix)) return std::nullopt;
  const auto found = std::ranges::find(factorAxesNames, method.substr(methodPrefix.size()));
  if (found == factorAxesNames.end()) return std::nullopt;
  return FactorAxes(found - factorAxesNames.begin());
}

int plannedReadings(std::span<const double> angles) {
  constexpr double tolerance = 0.01;  // of the spacing
  const int count = int(angles.size());
  if (count < 2) return count;
  const double spacing = (angles.back() - angles.front()) / (count - 1);
  for (int i = 0; i < count; ++i)
    if (std::abs(angles[std::size_t(i)] - angles.front() - i * spacing) > tolerance * spacing) return count;
  const double before = angles.front() / spacing;
  return std::abs(before - std::round(before)) > tolerance ? count : count + int(std::lround(before));
}

namespace {

constexpr int angleDecimals = 6;

void writeSample(io::CsvWriter& csv, const PlannedSample& sample, FactorCurve curve) {
  const auto& [wi, wo] = sample.directions;
  csv.integer(sample.index).text(factorCurveNames[std::size_t(curve)]);
  for (const double angle : {polarAngle(wi), azimuth(wi), polarAngle(wo), azimuth(wo)})
    csv.literal(io::decimalText(degrees(angle), angleDecimals));
  csv.integer(sample.order);
}

FactorCurve curveOf(const io::CsvText::Row& row, const std::string& name) {
  const auto found = std::ranges::find(factorCurveNames, name);
  if (found == factorCurveNames.end())
    throw Error(io::lineText(row) + ": found '" + name + "' in the column curve, expected along, across or further");
  return FactorCurve(found - factorCurveNames.begin());
}

}  // namespace

std::string factorReadingsCsv(const FactorPlan& plan, const MeasuredValues& values) {
  io::CsvWriter csv;
  csv.comment("method: " + plan.plan.method);
  csv.texts({"index", "curve", "theta_i", "phi_i", "theta_o", "phi_o", "order"});
  if (!values.rgb.empty()) csv.texts({"r", "g", "b"});
  if (!values.noise.empty()) csv.texts({"noise_r", "noise_g", "noise_b"});
  csv.endLine();
  for (std::size_t i = 0; i < plan.plan.samples.size(); ++i) {
    writeSample(csv, plan.plan.samples[i], plan.curves[i]);
    if (!values.rgb.empty()) csv.colour(values.rgb[i]);
    if (!values.noise.empty()) csv.colour(values.noise[i]);
    csv.endLine();
  }
  return csv.str();
}

void writeFactorReadings(const FactorPlan& plan, const MeasuredValues& values, const std::filesystem::path& path) {
  if (!values.rgb.empty()) checkMeasured(plan.plan, values);
  io::writeFileAtomically(path, factorReadingsCsv(plan, values));
}

FactorReadings parseFactorReadings(std::string_view text, FactorAxes axes) {
  FactorReadings readings{.plan = {.axes = axes, .plan = parsePlan(text), .curves = {}}, .values = {}};
  readings.values = parseValues(text, readings.plan.plan);
  const io::CsvText csv = io::readCsvText(text);
  const std::size_t indexColumn = csv.requiredColumn("index"), curveColumn = csv.requiredColumn("curve");
  std::map<int, FactorCurve> curves;
  for (const io::CsvText::Row& row : csv.rows)
    curves[csv.integer(row, indexColumn)] = curveOf(row, row.fields[curveColumn]);
  for (const PlannedSample& sample : readings.plan.plan.samples)
    readings.plan.curves.push_back(curves.at(sample.index));
  return readings;
}

FactorReadings readFactorReadings(const std::filesystem::path& path, FactorAxes axes) {
  return withFileInErrors(path, [&] { return parseFactorReadings(io::readText(path), axes); });
}

}  // namespace gonio::acquisition
