// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_readings_file.h"

#include <algorithm>
#include <map>

#include "core/acquisition/plan_file.h"
#include "core/acquisition/sample_rows.h"
#include "core/acquisition/values_file.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/file_in_errors.h"
#include "core/support/number_text.h"

namespace gonio::acquisition {

namespace {

constexpr int angleDecimals = 6;

std::string fieldsOf(const Rgb& value) {
  return "," + numberText(value.x) + "," + numberText(value.y) + "," + numberText(value.z);
}

std::string rowOf(const PlannedSample& sample, FactorCurve curve) {
  const auto& [wi, wo] = sample.directions;
  std::string text = std::to_string(sample.index) + "," + std::string(factorCurveNames[std::size_t(curve)]);
  for (const double angle : {polarAngle(wi), azimuth(wi), polarAngle(wo), azimuth(wo)})
    text += "," + io::decimalText(degrees(angle), angleDecimals);
  return text + "," + std::to_string(sample.order);
}

FactorCurve curveOf(const io::CsvText::Row& row, const std::string& name) {
  const auto found = std::ranges::find(factorCurveNames, name);
  if (found == factorCurveNames.end())
    throw Error(io::lineText(row) + ": found '" + name + "' in the column curve, expected along or across");
  return FactorCurve(found - factorCurveNames.begin());
}

}  // namespace

std::string factorReadingsCsv(const FactorPlan& plan, const MeasuredValues& values) {
  std::string text = io::csvComment("method: " + plan.plan.method) + "index,curve,theta_i,phi_i,theta_o,phi_o,order";
  if (!values.rgb.empty()) text += ",r,g,b";
  if (!values.noise.empty()) text += ",noise_r,noise_g,noise_b";
  text += "\n";
  for (std::size_t i = 0; i < plan.plan.samples.size(); ++i) {
    text += rowOf(plan.plan.samples[i], plan.curves[i]);
    if (!values.rgb.empty()) text += fieldsOf(values.rgb[i]);
    if (!values.noise.empty()) text += fieldsOf(values.noise[i]);
    text += "\n";
  }
  return text;
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
