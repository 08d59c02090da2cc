// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include <algorithm>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/factor_prediction.h"
#include "python/bindings/materials.h"

namespace gonio::python {

namespace {

using namespace acquisition;

std::vector<std::string> curveNames(const FactorPlan& plan) {
  std::vector<std::string> names;
  for (const FactorCurve curve : plan.curves) names.emplace_back(factorCurveNames[std::size_t(curve)]);
  return names;
}

py::tuple planParts(const FactorPlan& plan) { return py::make_tuple(plan.plan, curveNames(plan), plan.blocked); }

py::tuple planOfCurves(const std::string& axes, double fixedAngle, int angles, int distances, double maxPolar,
                       double minSeparation) {
  return planParts(planFactors({.axes = factorAxesNamed(axes),
                                .fixedAngle = fixedAngle,
                                .angles = angles,
                                .distances = distances,
                                .maxPolarAngle = maxPolar,
                                .minSeparation = minSeparation}));
}

FactorPlan planOf(const SamplingPlan& plan, const std::string& axes, const std::vector<std::string>& curves) {
  FactorPlan result{.axes = factorAxesNamed(axes), .plan = plan, .curves = {}};
  for (const std::string& name : curves) {
    const auto found = std::ranges::find(factorCurveNames, name);
    if (found == factorCurveNames.end()) throw Error("curves: found '" + name + "', expected along or across");
    result.curves.push_back(FactorCurve(found - factorCurveNames.begin()));
  }
  return result;
}

MeasuredValues readingsOf(const Vectors& rgb, const py::object& noise) {
  MeasuredValues values{.rgb = toRgb(rgb, "values"), .noise = {}};
  if (!noise.is_none()) values.noise = toRgb(noise.cast<Vectors>(), "noise");
  return values;
}

/// One row per node, one column per channel: (nodes, 3).
py::array_t<double> columnsOf(const std::array<std::vector<double>, 3>& curves) {
  std::vector<Rgb> rows;
  for (std::size_t i = 0; i < curves[0].size(); ++i) rows.emplace_back(curves[0][i], curves[1][i], curves[2][i]);
  return toArray(rows);
}

py::dict predict(const SamplingPlan& plan, const std::string& axes, const std::vector<std::string>& curves,
                 const Vectors& rgb, const py::object& noise, const std::string& bound, const std::string& name) {
  const FactorMeasurement m = factorMeasurement(planOf(plan, axes, curves), readingsOf(rgb, noise));
  const FactorSupport support = supportOf(m);
  py::dict row;
  row["material"] = newMaterial(name, "prediction", predictFromFactors(m, factorBoundNamed(bound)));
  row["angles"] = toArray(m.angles);
  row["along"] = columnsOf(m.along);
  row["distances"] = toArray(m.distances);
  row["across"] = columnsOf(m.across);
  row["contradicted"] = support.contradicted;
  row["extrapolated"] = support.extrapolated;
  row["bounded"] = support.bounded;
  row["unscaled"] = py::make_tuple(m.unscaled[0], m.unscaled[1], m.unscaled[2]);
  row["warnings"] = support.warnings;
  return row;
}

void writeReadings(const SamplingPlan& plan, const std::string& axes, const std::vector<std::string>& curves,
                   const Vectors& rgb, const py::object& noise, const std::string& path) {
  const FactorPlan factorPlan = planOf(plan, axes, curves);
  const MeasuredValues values = readingsOf(rgb, noise);
  if (values.rgb.size() != factorPlan.curves.size())
    throw Error("values: expected one row for each direction of the plan");
  acquisition::writeFactorReadings(factorPlan, values, path);
}

py::tuple readReadings(const std::string& path, const std::string& axes) {
  const acquisition::FactorReadings readings = acquisition::readFactorReadings(path, factorAxesNamed(axes));
  const MeasuredValues& values = readings.values;
  return py::make_tuple(planParts(readings.plan), toArray(values.rgb),
                        values.noise.empty() ? py::object(py::none()) : py::object(toArray(values.noise)));
}

}  // namespace

void bindFactorMeasurement(py::module_& module) {
  module.def("plan_factors", planOfCurves);
  module.def("predict_from_factors", predict);
  module.def("write_factor_readings", writeReadings);
  module.def("read_factor_readings", readReadings);
}

}  // namespace gonio::python
