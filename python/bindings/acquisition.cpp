// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>
#include <algorithm>

#include "core/acquisition/atom_components.h"
#include "core/acquisition/dictionary_reconstruction.h"
#include "core/acquisition/factor_plan.h"
#include "core/acquisition/factor_prediction.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sample_selection.h"
#include "core/acquisition/sampling_plan.h"
#include "core/materials/basis_file.h"
#include "core/materials/dictionary_file.h"
#include "core/study/learned_basis.h"
#include "core/study/training_files.h"
#include "python/bindings/materials.h"
#include "python/bindings/representations.h"

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

FactorPlan factorPlanOf(const SamplingPlan& plan, const std::string& axes, const std::vector<std::string>& curves) {
  FactorPlan result{.axes = factorAxesNamed(axes), .plan = plan, .curves = {}};
  for (const std::string& name : curves) {
    const auto found = std::ranges::find(factorCurveNames, name);
    if (found == factorCurveNames.end()) throw Error("curves: found '" + name + "', expected along, across or further");
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
  const FactorMeasurement m = factorMeasurement(factorPlanOf(plan, axes, curves), readingsOf(rgb, noise));
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
  const FactorPlan factorPlan = factorPlanOf(plan, axes, curves);
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

namespace {

using namespace acquisition;

PyBasis bundledBasis(const py::object& progress) {
  return resultOf(progress, [](const TaskControl& control) {
    const auto bundled = materials::bundledBasis(control);
    return PyBasis{{bundled, &bundled->components}, {}};
  });
}

PyBasis readBasis(const std::string& path) {
  const auto file = materials::readBasis(path);
  return {{file, &file->components}, file->learnedFrom};
}

PyBasis learnBasis(const std::vector<std::string>& sources, const std::vector<std::string>& excluded, int components,
                   const std::string& materialClass, const py::object& progress) {
  return resultOf(progress, [&](const TaskControl& control) {
    const auto files = study::filesOfClass(study::trainingFilesOrLibrary(sources, excluded),
                                           study::materialClassNamed(materialClass), {control.stop, {}});
    const auto basis = study::learnedBasis(files, components, materials::BasisPrecision::half, control).basis;
    return PyBasis{{basis, &basis->components}, basis->learnedFrom};
  });
}

/// The atoms of dictionaries as signals for plan().
PyBasis learnAtoms(const std::vector<std::string>& sources, const std::vector<std::string>& excluded,
                   const PyDictionaryPtr& given, int atoms, const py::object& progress) {
  return resultOf(progress, [&](const TaskControl& control) {
    const PyDictionaryPtr named = given ? given : materials::bundledEnsemble();
    const auto training =
        study::trainingMaterials(study::trainingFilesOrLibrary(sources, excluded), named->ensemble.grid);
    const auto prior = acquisition::learnDictionaryPrior(named->ensemble, training, {}, control.between(0, 0.7));
    auto components = std::make_shared<const dictionary::PrincipalComponents>(
        acquisition::atomComponents(named->ensemble, prior, atoms, control.between(0.7, 1)));
    return PyBasis{components, training.names, true};
  });
}

/// The diffuse and the specular part of a material.
py::tuple separateMaterial(const PyMaterial& material, const py::object& progress) {
  const auto parts = resultOf(progress, [&](const TaskControl& control) {
    return dictionary::separateDiffuse(*meanOfOrders(material.table({control.stop, {}})), control);
  });
  const std::string& name = material.shown().name;
  return py::make_tuple(newMaterial(name + " diffuse", "separation", parts.diffuse),
                        newMaterial(name + " specular", "separation", parts.specular));
}

/// (diffuse, specular).
py::tuple learnSeparatedBasis(const std::vector<std::string>& sources, const std::vector<std::string>& excluded,
                              int components, const py::object& progress) {
  std::vector<std::string> names;
  auto learned = resultOf(progress, [&](const TaskControl& control) {
    const auto training = study::trainingMaterials(study::trainingFilesOrLibrary(sources, excluded));
    names = training.names;
    return dictionary::learnSeparatedComponents(training.names.size(), training.load, {.maxComponents = components},
                                                control);
  });
  using dictionary::PrincipalComponents;
  return py::make_tuple(PyBasis{std::make_shared<const PrincipalComponents>(std::move(learned.diffuse)), names},
                        PyBasis{std::make_shared<const PrincipalComponents>(std::move(learned.specular)), names});
}

/// Codes of the first components: (3, components).
py::array_t<float> encodeComponents(const PyBasis& basis, const PyMaterial& material, int components,
                                    const py::object& progress) {
  const auto code = resultOf(progress, [&](const TaskControl& control) {
    return dictionary::encode(*basis.ofMaterials(), *meanOfOrders(material.table({control.stop, {}})), components,
                              control);
  });
  py::array_t<float> result({py::ssize_t(3), py::ssize_t(code.components())});
  float* out = result.mutable_data();
  for (const Eigen::VectorXf& channel : code.channels) out = std::copy_n(channel.data(), channel.size(), out);
  return result;
}

PyMaterialPtr decodeComponents(const PyBasis& basis,
                               const py::array_t<float, py::array::c_style | py::array::forcecast>& code,
                               const std::string& name, const py::object& progress) {
  if (code.ndim() != 2 || code.shape(0) != 3) throw Error("code: expected an array of shape (3, components)");
  dictionary::ComponentCode channels;
  for (int c = 0; c < 3; ++c)
    channels.channels[std::size_t(c)] = Eigen::Map<const Eigen::VectorXf>(code.data(c, 0), code.shape(1));
  return newMaterial(name, "components", resultOf(progress, [&](const TaskControl& control) {
                       return dictionary::decode(*basis.ofMaterials(), channels, control);
                     }));
}

struct Limits {
  double maxPolar, minSeparation;
  std::vector<std::array<double, 6>> forbidden;  ///< lowest and highest theta_i, theta_o, |phi_i - phi_o|
};

MeasurableDirections measurable(const Limits& limits) {
  MeasurableDirections result{.maxPolarAngle = limits.maxPolar, .minSeparation = limits.minSeparation, .forbidden = {}};
  for (const auto& box : limits.forbidden)
    result.forbidden.push_back({{box[0], box[1]}, {box[2], box[3]}, {box[4], box[5]}});
  result.check();
  return result;
}

py::tuple plan(const PyBasis& basis, int samples, const std::string& method, int components, double maxPolar,
               double minSeparation, const std::vector<std::array<double, 6>>& forbidden, std::uint64_t seed,
               int restarts, const py::object& progress) {
  const auto found = std::ranges::find(selectionMethodNames, method);
  if (found == selectionMethodNames.end()) {
    std::string message = "method: found '" + method + "', expected one of";
    for (const std::string_view name : selectionMethodNames) message.append(" ").append(name);
    throw Error(message);
  }
  const SelectionOptions options{.method = SelectionMethod(found - selectionMethodNames.begin()),
                                 .samples = samples,
                                 .components = components,
                                 .measurable = measurable({maxPolar, minSeparation, forbidden}),
                                 .seed = seed,
                                 .restarts = restarts};
  const SampleSelection selection = resultOf(
      progress, [&](const TaskControl& control) { return selectSamples(*basis.components, options, control); });
  SamplingPlan planned = planFor(basis.components->mapping.grid, selection.cells);
  planned.method = selection.method;
  return py::make_tuple(planned, selection.conditionNumber, selection.residuals, selection.warning);
}

py::tuple directionsOf(const SamplingPlan& plan) {
  std::vector<Rgb> wi, wo;
  for (const PlannedSample& sample : plan.samples) {
    wi.push_back(sample.directions.wi);
    wo.push_back(sample.directions.wo);
  }
  return py::make_tuple(toArray(wi), toArray(wo));
}

SamplingPlan planOf(const Vectors& wi, const Vectors& wo) {
  const std::vector<Direction> light = toRgb(wi, "wi"), viewer = toRgb(wo, "wo");
  if (light.size() != viewer.size() || light.empty())
    throw Error("wi and wo: expected the same number of directions, at least one");
  checkUnit(light, 0, "wi");
  checkUnit(viewer, 0, "wo");
  SamplingPlan plan;
  std::vector<DirectionPair> pairs;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (isBelowHorizon(light[i]) || isBelowHorizon(viewer[i]))
      throw Error("found a direction below the horizon (number " + std::to_string(i) + ")");
    pairs.push_back({light[i], viewer[i]});
    plan.samples.push_back({.index = int(i) + 1, .directions = pairs.back()});
  }
  int order = 0;
  for (const std::size_t next : shortPath(pairs)) plan.samples[next].order = ++order;
  return plan;
}

py::tuple measure(const PyMaterial& material, const SamplingPlan& plan, double relative, double absolute,
                  double misalignment, std::uint64_t seed) {
  const MeasuredValues values = resultOf(py::none(), [&](const TaskControl&) {
    return acquisition::measure(*material.brdf(), plan, {relative, absolute, misalignment, seed});
  });
  return py::make_tuple(toArray(values.rgb),
                        values.noise.empty() ? py::object(py::none()) : py::object(toArray(values.noise)));
}

MeasuredValues valuesOf(const Vectors& rgb, const py::object& noise) {
  MeasuredValues values{.rgb = toRgb(rgb, "values"), .noise = {}};
  if (!noise.is_none()) values.noise = toRgb(noise.cast<Vectors>(), "noise");
  return values;
}

/// The values of the cells of a basis in an array of shape (theta_h, theta_d, phi_d); NaN in all other cells.
py::array_t<float> onGrid(const dictionary::MappedCells& mapping, const std::vector<float>& deviation) {
  const HalfDifferenceGrid& grid = mapping.grid;
  py::array_t<float> array({grid.thetaHCount, grid.thetaDCount, grid.phiDCount});
  std::fill_n(array.mutable_data(), grid.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < deviation.size(); ++i) array.mutable_data()[mapping.cells[i]] = deviation[i];
  return array;
}

py::dict reconstruct(const PyBasis& basis, const SamplingPlan& plan, const Vectors& rgb, const py::object& noise,
                     const std::string& method, std::optional<double> ridge, int components, int atoms, bool equalNoise,
                     const std::string& name, const py::object& progress) {
  const auto found = std::ranges::find(reconstructionMethodNames, method);
  if (found == reconstructionMethodNames.end())
    throw Error("method: found '" + method + "', expected ridge, local-ridge, sparse or basis-pursuit");
  const MeasuredValues values = valuesOf(rgb, noise);
  const ReconstructionOptions options{.method = ReconstructionMethod(found - reconstructionMethodNames.begin()),
                                      .ridge = ridge,
                                      .components = components,
                                      .atoms = atoms,
                                      .equalNoise = equalNoise};
  const Reconstruction result = resultOf(progress, [&](const TaskControl& control) {
    return acquisition::reconstruct(*basis.ofMaterials(), plan, values, options, control);
  });
  py::dict row;
  row["material"] = newMaterial(name, "reconstruction", result.table);
  row["ridge"] = result.ridge;
  row["components"] = result.components;
  row["leave_one_out_error"] = result.leaveOneOutError;
  row["assumption"] = acquisition::assumedOrders;
  row["deviation"] = result.standardDeviation.empty()
                         ? py::object(py::none())
                         : py::object(onGrid(basis.components->mapping, result.standardDeviation));
  row["warnings"] = result.warnings;
  return row;
}

void bindBasis(py::module_& module) {
  py::class_<PyBasis>(module, "Basis")
      .def("__len__", [](const PyBasis& b) { return b.components->count(); })
      .def_property_readonly("singular_values",
                             [](const PyBasis& b) {
                               const auto& values = b.components->svd.singularValues;
                               return toArray(std::span<const double>(values.data(), std::size_t(values.size())));
                             })
      .def_property_readonly("learned_from", [](const PyBasis& b) { return toTexts(b.learnedFrom); })
      .def_property_readonly("grid",
                             [](const PyBasis& b) {
                               const HalfDifferenceGrid& grid = b.components->mapping.grid;
                               return py::make_tuple(grid.thetaHCount, grid.thetaDCount, grid.phiDCount);
                             })
      .def("encode", encodeComponents)
      .def("decode", decodeComponents)
      .def("save", [](const PyBasis& b, const std::string& path) {
        materials::writeBasis(*b.ofMaterials(), b.components->count(), b.learnedFrom, path);
      });
  module.def("bundled_basis", bundledBasis);
  module.def("read_basis", readBasis, py::call_guard<py::gil_scoped_release>());
  module.def("learn_basis", learnBasis);
  module.def("learn_atoms", learnAtoms);
  module.def("separate", separateMaterial);
  module.def("learn_separated_basis", learnSeparatedBasis);
}

}  // namespace

void bindAcquisition(py::module_& module) {
  bindBasis(module);
  py::class_<SamplingPlan>(module, "Plan")
      .def("__len__", [](const SamplingPlan& plan) { return plan.samples.size(); })
      .def_property_readonly("directions", directionsOf)
      .def_property_readonly("order", [](const SamplingPlan& plan) { return plan.measurementOrder(); })
      .def_readonly("method", &SamplingPlan::method)
      .def("save", [](const SamplingPlan& plan, const std::string& path) { acquisition::writePlan(plan, path); })
      .def("save_values", [](const SamplingPlan& plan, const Vectors& rgb, const py::object& noise,
                             const std::string& path) { acquisition::writeValues(plan, valuesOf(rgb, noise), path); })
      .def("read_values", [](const SamplingPlan& plan, const std::string& path) {
        const MeasuredValues values = acquisition::readValues(path, plan);
        return py::make_tuple(toArray(values.rgb),
                              values.noise.empty() ? py::object(py::none()) : py::object(toArray(values.noise)));
      });
  module.def("plan", plan);
  module.def("plan_of", planOf);
  module.def("read_plan", [](const std::string& path) { return acquisition::readPlan(path); });
  module.def("measure", measure);
  module.def("reconstruct", reconstruct);
}

}  // namespace gonio::python
