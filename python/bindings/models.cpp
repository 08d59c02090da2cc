// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include "core/editing/artist_controls.h"
#include "core/models/parameters_json.h"
#include "core/models/registry.h"
#include "core/study/fit_ranking.h"
#include "core/study/gamma_selection.h"
#include "python/bindings/materials.h"

namespace gonio::python {

py::dict errorsOf(const std::vector<double>& errors) {
  py::dict result;
  const auto metrics = metrics::allBrdfMetrics();
  for (std::size_t i = 0; i < errors.size(); ++i)
    result[py::str(std::string(metrics::metricId(metrics[i])))] = errors[i];
  return result;
}

namespace {

constexpr const char* scaleNames[] = {"linear", "logarithmic", "angle", "lightness"};
constexpr const char* familyNames[] = {"empirical", "analytic", "series"};

py::dict describe(const models::ParameterSpec& parameter) {
  py::dict row;
  row["name"] = parameter.id;
  row["label"] = parameter.label;
  row["symbol"] = parameter.symbol;
  row["unit"] = parameter.unit;
  row["soft_range"] = py::make_tuple(parameter.softMin, parameter.softMax);
  row["hard_range"] = py::make_tuple(parameter.hardMin, parameter.hardMax);
  row["default"] = parameter.defaultValue;
  row["scale"] = scaleNames[std::size_t(parameter.scale)];
  row["per_channel"] = parameter.perChannel;
  row["linear"] = parameter.linear;
  row["description"] = parameter.description;
  row["formula"] = parameter.formula;
  row["reference"] = parameter.reference;
  py::list choices;
  for (const std::string_view choice : parameter.choices) choices.append(choice);
  row["choices"] = py::tuple(choices);
  return row;
}

py::dict describe(const models::ModelSpec& spec) {
  py::dict row;
  row["id"] = spec.id;
  row["name"] = spec.name;
  row["description"] = spec.description;
  row["formula"] = spec.formula;
  row["reference"] = spec.reference;
  row["family"] = familyNames[std::size_t(spec.family)];
  row["is_reciprocal"] = spec.reciprocal;
  row["conserves_energy"] = spec.conservesEnergy;
  py::list parameters;
  for (const models::ParameterSpec& parameter : spec.parameters) parameters.append(describe(parameter));
  row["parameters"] = parameters;
  return row;
}

py::list allModels() {
  py::list list;
  for (const models::Model* model : models::allModels()) list.append(describe(model->spec()));
  return list;
}

/// @param parameters JSON text.
PyMaterialPtr instantiate(const std::string& id, const std::string& parameters, const std::string& name) {
  const models::Model& model = models::findModel(id);
  return newMaterial(
      name, std::string(model.spec().name),
      model.instantiate(models::parametersFromJson(model.spec(), nlohmann::json::parse(parameters), id)));
}

py::dict describe(const fitting::FitResult& fit) {
  py::dict row;
  row["model"] = fit.model->spec().id;
  row["parameters"] = toPython(models::parametersToJson(fit.model->spec(), fit.parameters));
  row["errors"] = errorsOf(fit.errors);
  row["seconds"] = fit.seconds;
  row["used_cells"] = fit.usedCells;
  row["warnings"] = fit.warnings;
  return row;
}

fitting::FitOptions fitOptions(const std::string& metric, double gamma, double maxPolarAngle) {
  return {.metric = metrics::metricByName(metric), .gamma = gamma, .maxPolarAngle = maxPolarAngle};
}

py::dict fit(const PyMaterial& material, const std::string& id, const std::string& metric, double gamma,
             double maxPolarAngle, const py::object& progress) {
  const models::Model& model = models::findModel(id);
  const auto options = fitOptions(metric, gamma, maxPolarAngle);
  return describe(resultOf(progress, [&](const TaskControl& control) {
    const auto base = fitting::fitBase(material.brdf(), material.table(control.between(0, 0.3)));
    return fitting::fit(base, model, options, control.between(0.3, 1));
  }));
}

py::list fitAll(const PyMaterial& material, const std::vector<std::string>& ids, const std::string& metric,
                double gamma, double maxPolarAngle, int size, int samples, const py::object& progress) {
  study::RankingOptions options;
  options.fit = fitOptions(metric, gamma, maxPolarAngle);
  for (const std::string& id : ids) options.models.push_back(&models::findModel(id));
  options.picture.width = options.picture.height = size;
  options.picture.samples = samples;
  const auto ranking = resultOf(progress, [&](const TaskControl& control) {
    auto fits =
        study::rankFits({material.table(control.between(0, 0.02)), material.brdf()}, options, control.between(0.02, 1));
    study::sortRanking(fits, options.fit.metric);
    return fits;
  });
  py::list list;
  for (const study::RankedFit& one : ranking) {
    py::dict row = describe(one.fit);
    row["rendered_snr"] = one.renderedSnr;
    list.append(row);
  }
  return list;
}

py::list allMetrics() {
  py::list list;
  for (const metrics::MetricRecord& metric : metrics::metricRecords())
    list.append(
        py::make_tuple(metric.id, metric.name, metric.formula, metric.unit, metric.reference, metric.minimisable));
  return list;
}

}  // namespace

void bindModels(py::module_& module) {
  module.def("models", allModels);
  module.def("artist_controls", [] { return describe(editing::artistControls()); });
  module.def("instantiate", instantiate);
  module.def("fit", fit);
  module.def("fit_all", fitAll);
  module.def("metrics", allMetrics);
}

}  // namespace gonio::python
