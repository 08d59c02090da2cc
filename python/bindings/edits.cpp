// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include <algorithm>

#include "core/editing/edit.h"
#include "core/interpolation/interpolation.h"
#include "core/materials/dictionary_file.h"
#include "core/models/parameters_json.h"
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

/// Parameters are JSON text. The second result lists the ids of the parameters and controls that were clamped to their
/// hard ranges.
py::tuple edit(const PyMaterial& material, const std::string& id, const std::string& fitted, const std::string& changed,
               const std::string& controls, const std::string& composition, double strength,
               const py::object& progress) {
  const models::Model& model = models::findModel(id);
  const auto parameters = [&](const std::string& text, const models::ModelSpec& spec) {
    return models::parametersFromJson(spec, nlohmann::json::parse(text), std::string(spec.id));
  };
  DifferentialEdit change{&model, parameters(fitted, model.spec()), parameters(changed, model.spec()),
                          defaultComposition(model), parameters(controls, artistControls())};
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
  auto clamped = models::clampToHardRange(model.spec(), change.edited);
  std::ranges::copy(models::clampToHardRange(artistControls(), change.controls), std::back_inserter(clamped));
  std::vector<std::string> cut;
  for (const models::ClampedParameter& one : clamped) cut.emplace_back(one.id);
  return py::make_tuple(edited(material, {.content = change, .strength = strength}, progress), cut);
}

PyMaterialPtr editFactors(const PyMaterial& material, const PyFactors& original, const PyFactors& changed,
                          bool preserveDetail, double strength, const py::object& progress) {
  if (!(strength >= 0 && strength <= 1)) throw Error("strength: expected a number from 0 to 1");
  return edited(material,
                {.content = FactorEdit{original.factors, changed.factors, preserveDetail}, .strength = strength},
                progress);
}

using Blends = std::shared_ptr<const Interpolation>;

/// The input of an interpolation for a material, with its factors or code if it consists of them.
/// @param bundled whether the interpolation uses the bundled dictionary; the code is left out otherwise.
InterpolationMaterial endOf(const PyMaterial& material, bool bundled, const TaskControl& control) {
  InterpolationMaterial end{.table = material.table(control)};
  end.factors = factorization::pdvFactorsOf(*material.brdf());
  if (bundled) end.code = material.shown().code;
  if (!material.shown().table) end.base = material.brdf();
  return end;
}

Blends prepare(const std::vector<PyMaterialPtr>& materials, const std::string& space, const std::string& model,
               int terms, std::size_t coefficients, const PyDictionaryPtr& dictionary, const py::object& progress) {
  const auto found = std::ranges::find(interpolationSpaceNames, space);
  if (found == interpolationSpaceNames.end())
    throw Error("space: found '" + space + "', expected linear, parameters, differential, factors or dictionary");
  const auto chosen = InterpolationSpace(found - interpolationSpaceNames.begin());
  InterpolationOptions options;
  options.model = &models::findModel(model);
  options.pdv.terms = terms;
  options.encode.coefficients = options.codeCoefficients = coefficients;
  return resultOf(progress, [&](const TaskControl& control) {
    if (chosen == InterpolationSpace::dictionary) {
      const auto ensemble = dictionary ? dictionary : materials::bundledEnsemble();
      options.ensemble = {ensemble, &ensemble->ensemble};
    }
    std::vector<InterpolationMaterial> ends;
    for (const PyMaterialPtr& material : materials) ends.push_back(endOf(*material, !dictionary, {control.stop, {}}));
    return prepareInterpolation(chosen, ends, options, control);
  });
}

}  // namespace

void bindEdits(py::module_& module) {
  module.def("edit", edit);
  module.def("edit_factors", editFactors);
  py::class_<Interpolation, std::shared_ptr<Interpolation>>(module, "Interpolation");
  module.def("prepare_interpolation",
             [](const std::vector<PyMaterialPtr>& materials, const std::string& space, const std::string& model,
                int terms, std::size_t coefficients, const std::shared_ptr<materials::NamedEnsemble>& dictionary,
                const py::object& progress) {
               return std::const_pointer_cast<Interpolation>(
                   prepare(materials, space, model, terms, coefficients, dictionary, progress));
             });
  module.def(
      "blend",
      [](const Interpolation& interpolation, const std::vector<double>& weights, const std::string& name) {
        std::shared_ptr<const Brdf> brdf = interpolation.brdf(weights);
        if (const TabulatedBrdf* table = formOf<TabulatedBrdf>(*brdf))
          return newMaterial(name, "blend", std::shared_ptr<const TabulatedBrdf>(brdf, table));
        return newMaterial(name, "blend", std::move(brdf));
      },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace gonio::python
