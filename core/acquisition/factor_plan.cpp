// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_plan.h"

#include <algorithm>
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
                "', expected projected-deviation, symmetric-deviation, half-difference or half-out");
  return FactorAxes(found - factorAxesNames.begin());
}

FactorCoordinates toFactorCoordinates(FactorAxes axes, const DirectionPair& pair) {
  switch (axes) {
    case FactorAxes::projectedDeviation: {
      const ProjectedDeviation at = toProjectedDeviation(pair.wi, pair.wo);
      return {at.thetaR, at.deviation};
    }
    case FactorAxes::symmetricDeviation:
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

/// Appends the reading at a place, or counts it as blocked.
void plan(FactorCurve curve, const FactorCoordinates& place, const FactorPlanOptions& options, FactorPlan& result) {
  const std::optional<DirectionPair> arms = fromFactorCoordinates(options.axes, place);
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

}  // namespace

FactorPlan planFactors(const FactorPlanOptions& options) {
  checkOptions(options);
  FactorPlan result{.axes = options.axes, .plan = {}, .curves = {}};
  result.plan.method = factorMethod(options.axes);
  for (int i = 0; i < options.angles; ++i)
    plan(FactorCurve::along, {options.maxPolarAngle * i / (options.angles - 1), 0}, options, result);
  const std::size_t along = result.curves.size();
  const double last = isDeviation(options.axes) ? 2 : halfPi;
  for (int j = 0; j < options.distances; ++j) {
    const double fraction = double(j) / (options.distances - 1);
    plan(FactorCurve::across, {options.fixedAngle, last * fraction * fraction}, options, result);
  }
  if (along == 0 || along == result.curves.size())
    throw Error("factor measurement: the rig reaches no reading of the curve \"" +
                std::string(factorCurveNames[std::size_t(along == 0 ? FactorCurve::along : FactorCurve::across)]) +
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
    throw Error(io::lineText(row) + ": found '" + name + "' in the column curve, expected along or across");
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
