// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>
#include <algorithm>

#include "core/editing/artist_controls.h"
#include "core/editing/edit.h"
#include "core/interpolation/interpolation.h"
#include "core/materials/dictionary_file.h"
#include "core/models/parameters_json.h"
#include "core/models/registry.h"
#include "core/study/accuracy_study.h"
#include "core/study/picture_search.h"
#include "python/bindings/materials.h"
#include "python/bindings/representations.h"

namespace gonio::python {

namespace {

using namespace editing;

/// The material with one more edit.
PyMaterialPtr edited(const PyMaterial& material, Edit edit, const py::object& progress) {
  materials::EditedMaterial result = material.edited();
  result.edits.push_back(std::move(edit));
  result.shown = resultOf(
      progress, [&](const TaskControl& control) { return materials::withEdits(result.base, result.edits, control); });
  result.shown.name = material.shown().name;
  return std::make_shared<PyMaterial>(std::move(result));
}

/// Parameters are JSON text.
PyMaterialPtr edit(const PyMaterial& material, const std::string& id, const std::string& fitted,
                   const std::string& changed, const std::string& controls, const std::string& composition,
                   double strength, bool keepsAlbedo, const py::object& progress) {
  const models::Model& model = models::findModel(id);
  const auto parameters = [&](const std::string& text, const models::ModelSpec& spec) {
    return models::parametersFromJson(spec, nlohmann::json::parse(text), std::string(spec.id));
  };
  DifferentialEdit change = unchangedEdit(model, parameters(fitted, model.spec()));
  change.edited = parameters(changed, model.spec());
  change.controls = parameters(controls, artistControls());
  change.keepsAlbedo = keepsAlbedo;
  if (!composition.empty()) {
    const auto found = std::ranges::find(compositionIds, composition);
    if (found == compositionIds.end())
      throw Error("composition: found '" + composition + "', expected additive, log-plus or lobes");
    change.composition = Composition(found - compositionIds.begin());
    if (change.composition == Composition::lobes && !model.hasLobes())
      throw Error("composition: lobes needs a model that is a sum of lobes (" + models::modelsWithLobes() +
                  "), found " + id);
  }
  if (!(strength >= 0 && strength <= 1)) throw Error("strength: expected a number from 0 to 1");
  models::checkHardRange(model.spec(), change.edited);
  models::checkHardRange(artistControls(), change.controls);
  return edited(material, {.content = change, .strength = strength}, progress);
}

PyMaterialPtr editFactors(const PyMaterial& material, const PyFactors& original, const PyFactors& changed,
                          bool preserveDetail, double strength, const py::object& progress) {
  if (!(strength >= 0 && strength <= 1)) throw Error("strength: expected a number from 0 to 1");
  return edited(material,
                {.content = FactorEdit{original.factors, changed.factors, preserveDetail}, .strength = strength},
                progress);
}

using Blends = std::shared_ptr<const interpolation::Interpolation>;

/// The input of an interpolation for a material, with its factors or code if it consists of them.
/// @param bundled whether the interpolation uses bundled dictionaries; the code is left out otherwise.
interpolation::InterpolationMaterial endOf(const PyMaterial& material, bool bundled, const TaskControl& control) {
  interpolation::InterpolationMaterial end{.table = material.table(control)};
  end.factors = factorization::pdvFactorsOf(*material.brdf());
  if (const materials::Material& shown = material.shown(); bundled && shown.code) {
    end.code = shown.code;
    end.ensemble = {shown.dictionary, &shown.dictionary->ensemble};
  }
  if (!material.shown().table) end.base = material.brdf();
  return end;
}

Blends prepare(const std::vector<PyMaterialPtr>& materials, const std::string& space, const std::string& model,
               int terms, std::size_t coefficients, const PyDictionaryPtr& dictionary, bool preserveDetail,
               const py::object& progress) {
  const auto found = std::ranges::find(interpolation::interpolationSpaceNames, space);
  if (found == interpolation::interpolationSpaceNames.end())
    throw Error("space: found '" + space + "', expected linear, parameters, differential, factors or dictionary");
  const auto chosen = interpolation::InterpolationSpace(found - interpolation::interpolationSpaceNames.begin());
  interpolation::InterpolationOptions options;
  options.model = &models::findModel(model);
  options.pdv.terms = terms;
  options.preserveDetail = preserveDetail;
  options.encode.coefficients = options.codeCoefficients = coefficients;
  return resultOf(progress, [&](const TaskControl& control) {
    if (chosen == interpolation::InterpolationSpace::dictionary) {
      const auto ensemble = dictionary ? dictionary : materials::bundledEnsemble();
      options.ensemble = {ensemble, &ensemble->ensemble};
    }
    std::vector<interpolation::InterpolationMaterial> ends;
    for (const PyMaterialPtr& material : materials) ends.push_back(endOf(*material, !dictionary, {control.stop, {}}));
    return interpolation::prepareInterpolation(chosen, ends, options, control);
  });
}

}  // namespace

void bindEdits(py::module_& module) {
  module.def("edit", edit);
  module.def("edit_factors", editFactors);
  py::class_<interpolation::Interpolation, std::shared_ptr<interpolation::Interpolation>>(module, "Interpolation");
  module.def("prepare_interpolation",
             [](const std::vector<PyMaterialPtr>& materials, const std::string& space, const std::string& model,
                int terms, std::size_t coefficients, const std::shared_ptr<materials::NamedEnsemble>& dictionary,
                bool preserveDetail, const py::object& progress) {
               return std::const_pointer_cast<interpolation::Interpolation>(
                   prepare(materials, space, model, terms, coefficients, dictionary, preserveDetail, progress));
             });
  module.def(
      "blend",
      [](const interpolation::Interpolation& interpolation, const std::vector<double>& weights,
         const std::string& name) {
        std::shared_ptr<const Brdf> brdf = interpolation.brdf(weights);
        if (const TabulatedBrdf* table = formOf<TabulatedBrdf>(*brdf))
          return newMaterial(name, "blend", std::shared_ptr<const TabulatedBrdf>(brdf, table));
        return newMaterial(name, "blend", std::move(brdf));
      },
      py::call_guard<py::gil_scoped_release>());
}

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
  const auto values = models::parametersFromJson(model.spec(), nlohmann::json::parse(parameters), id);
  models::checkHardRange(model.spec(), values);
  return newMaterial(name, std::string(model.spec().name), model.instantiate(values));
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
