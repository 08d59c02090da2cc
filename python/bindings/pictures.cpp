// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include "core/export/export_target.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/npf_file.h"
#include "core/metrics/brdf_metrics.h"
#include "core/metrics/image_errors.h"
#include "core/models/registry.h"
#include "core/rendering/environment.h"
#include "core/rendering/plan_check.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/sampling_method.h"
#include "core/rendering/scene_file.h"
#include "core/study/accuracy_study.h"
#include "python/bindings/representations.h"

namespace gonio::python {

namespace {

/// A scene and the materials of its objects.
struct Filled {
  rendering::Scene scene;
  rendering::RenderMaterials materials;
};

Filled fill(const std::vector<PyMaterialPtr>& given, const std::string& name, const std::string& up,
            const std::string& environment, double rotation,
            std::string_view sampling = rendering::samplingMethods().front().id, const TaskControl& control = {}) {
  Filled filled{.scene = rendering::openScene(name, int(given.size()), rendering::upAxisOf(up)), .materials = {}};
  if (!environment.empty()) filled.scene.environment = rendering::openEnvironment(environment);
  filled.scene.environmentRotation += rotation;
  const auto places = std::size_t(std::max(1, rendering::materialSlotCount(filled.scene)));
  if (given.size() > places)
    throw Error("materials: found " + std::to_string(given.size()) + ", expected at most " + std::to_string(places) +
                ", as many as the scene '" + filled.scene.name + "' shows");
  for (const PyMaterialPtr& material : given)
    filled.materials.push_back(sampling == rendering::samplingMethods().front().id
                                   ? material->rendered()
                                   : rendering::sampledBy(sampling, material->brdf(), control));
  filled.materials = rendering::bindMaterials(filled.scene, filled.materials);
  return filled;
}

py::tuple render(const std::vector<PyMaterialPtr>& given, const std::string& scene, const std::string& up,
                 const std::string& environment, double rotation, int width, int height, int samples,
                 const std::string& sampling, std::uint64_t seed, const py::object& progress) {
  if (width < 1 || height < 1 || width > 8192 || height > 8192) throw Error("size: expected 1 to 8192 pixels");
  if (samples < 1) throw Error("samples: expected 1 or more");
  return toArrays(resultOf(progress, [&](const TaskControl& control) {
    const Filled filled = fill(given, scene, up, environment, rotation, sampling, {control.stop, {}});
    const rendering::PathTracer tracer(
        filled.scene, filled.materials,
        rendering::checkedPlan(filled.scene, filled.materials, {}, {}, {control.stop, {}}), seed);
    rendering::Film film(width, height);
    tracer.accumulate(film, samples, control);
    return film.image();
  }));
}

py::list effects(const std::vector<PyMaterialPtr>& given, const std::string& scene, const std::string& up,
                 const std::string& environment) {
  const rendering::EffectPlan plan = resultOf(py::none(), [&](const TaskControl& control) {
    const Filled filled = fill(given, scene, up, environment, 0);
    return rendering::checkedPlan(filled.scene, filled.materials, {}, {}, control);
  });
  py::list list;
  for (std::size_t i = 0; i < rendering::effectCount; ++i)
    list.append(py::make_tuple(rendering::effectId(rendering::Effect(i)), plan.decisions[i].simulated,
                               plan.decisions[i].reason));
  return list;
}

py::dict compare(const PyMaterial& a, const PyMaterial& b, double maxPolarAngle, int size, int samples, bool pictures,
                 const py::object& progress) {
  struct Result {
    std::vector<double> errors, imageErrors;
    double brdfSnr, renderedSnr, renderedPsnr;
    Image reference, test;
    std::array<study::UseCost, 2> costs;
  };
  Result result = resultOf(progress, [&](const TaskControl& control) {
    Result made;
    made.errors = metrics::brdfErrors(*a.brdf(), *b.brdf(), maxPolarAngle);
    made.brdfSnr = metrics::brdfSignalToNoiseRatio(*a.brdf(), *b.brdf());
    const rendering::RenderedComparison comparison(
        *a.brdf(), {.width = size, .height = size, .samples = samples, .density = {}}, control.between(0.2, 0.5));
    rendering::ComparisonPicture picture = comparison.render(*b.brdf(), control.between(0.5, 0.8));
    made.renderedSnr = comparison.signalToNoiseRatio(picture);
    made.renderedPsnr = comparison.peakSignalToNoiseRatio(picture);
    made.imageErrors = metrics::imageErrors(comparison.reference(), picture.image);
    made.reference = comparison.reference();
    made.test = std::move(picture.image);
    made.costs = {study::measureUse(*a.brdf(), control.between(0.8, 0.9)),
                  study::measureUse(*b.brdf(), control.between(0.9, 1))};
    return made;
  });
  py::dict row;
  row["errors"] = errorsOf(result.errors);
  row["brdf_snr"] = result.brdfSnr;
  row["rendered_snr"] = result.renderedSnr;
  row["rendered_psnr"] = result.renderedPsnr;
  py::dict imageMetrics;
  for (std::size_t i = 0; i < result.imageErrors.size(); ++i)
    imageMetrics[py::str(std::string(metrics::imageMetricRecords()[i].id))] = result.imageErrors[i];
  row["image_metrics"] = imageMetrics;
  row["evaluation_ns"] = py::make_tuple(result.costs[0].evaluation.median, result.costs[1].evaluation.median);
  row["frame_ms"] = py::make_tuple(result.costs[0].frameMilliseconds, result.costs[1].frameMilliseconds);
  row["pictures"] = py::none();
  if (pictures)
    row["pictures"] = py::make_tuple(toArrays(std::move(result.reference))[0], toArrays(std::move(result.test))[0]);
  return row;
}

struct StudyRequest {
  std::vector<std::string> names, models, baselines;
  std::vector<int> terms;
  std::vector<std::size_t> coefficients;
  std::vector<int> components;
  std::string npf;  ///< table of published non-parametric factors; "": none
};

std::vector<study::Representation> representations(const StudyRequest& request) {
  study::RepresentationChoice choice{.names = request.names,
                                     .terms = request.terms,
                                     .coefficients = request.coefficients,
                                     .components = request.components};
  choice.restrict("fits", request.models);
  choice.restrict("baselines", request.baselines);
  return study::representationsOf(choice);
}

/// Adds the published factors of the material, or removes them if the table has no row of its name.
void addPublished(StudyRequest& request, study::BuildOptions& build, const std::string& name) {
  const std::string id = "published-nonparametric";
  std::erase(request.names, id);
  const materials::NpfTable table = materials::readNpf(request.npf);
  const auto* factors = table.find(name);
  if (!factors) return;
  build.publishedNonparametric = std::make_shared<const factorization::NonparametricFactors>(*factors);
  request.names.push_back(id);
}

py::dict describe(const study::StudyRecord& record) {
  py::dict row;
  row["family"] = record.representation.kind->family->id;
  row["representation"] = record.representation.kind->id;
  row["label"] = record.representation.kind->label;
  row["budget"] = record.representation.budget;
  row["bytes"] = record.bytes;
  row["encode_seconds"] = record.encodeSeconds;
  row["evaluation_ns"] = record.evaluation.median;
  row["frame_ms"] = record.frameMilliseconds;
  row["errors"] = errorsOf(record.errors);
  row["rendered_snr"] = record.renderedSnr;
  return row;
}

py::list runStudy(const PyMaterial& material, StudyRequest request,
                  const std::shared_ptr<materials::NamedEnsemble>& dictionary, const PyBasis* basis,
                  const PyPatchDictionaryPtr& patches, int size, int samples, bool timed, const py::object& progress) {
  study::StudyOptions options;
  if (!request.npf.empty()) addPublished(request, options.build, material.shown().name);
  const auto planned = representations(request);
  options.build.dictionary = dictionary;
  if (basis) options.build.components = basis->ofMaterials();
  options.build.patches = patches;
  options.picture.width = options.picture.height = size;
  options.picture.samples = samples;
  options.timed = timed;
  const auto records = resultOf(progress, [&](const TaskControl& control) {
    return study::runStudy({material.table(control.between(0, 0.05)), material.brdf()}, planned, options,
                           control.between(0.05, 1));
  });
  py::list list;
  for (const study::StudyRecord& record : records) list.append(describe(record));
  return list;
}

const exports::ExportTarget& targetOf(const std::string& id) {
  if (const auto* target = exports::findExportTarget(id)) return *target;
  std::string ids;
  for (const exports::ExportTarget& target : exports::exportTargets())
    ids += (ids.empty() ? "" : ", ") + std::string(target.id);
  throw Error("target: found '" + id + "', expected one of " + ids);
}

py::dict exportMaterial(const PyMaterial& material, const std::string& path, const std::string& id, double snr,
                        std::size_t thetaCount, std::size_t size, const std::string& sceneName, const std::string& up,
                        const std::string& environment, bool overwrite, const py::object& progress, int blender) {
  const exports::ExportTarget& target = targetOf(id);
  if (blender != 3 && blender != 4) throw Error("blender: found " + std::to_string(blender) + ", expected 3 or 4");
  exports::ExportOptions options{.snr = snr, .blender = blender};
  if (thetaCount > 0) options.size = {thetaCount, size};
  if (options.size && !target.usesSize) throw Error("grid: only targets that write .bsdf files accept it, found " + id);
  if (!sceneName.empty() && !target.scene) throw Error("scene: the target " + id + " cannot write scenes");
  std::vector<exports::ExportFile> files;
  const exports::ExportResult made = resultOf(progress, [&](const TaskControl& control) {
    std::optional<rendering::Scene> scene;
    if (!sceneName.empty()) scene = rendering::openScene(sceneName, 1, rendering::upAxisOf(up));
    if (scene && !environment.empty()) scene->environment = rendering::openEnvironment(environment);
    const std::filesystem::path name = target.nameOf(path);
    std::vector<std::filesystem::path> sources;
    if (const auto& source = material.base().source.path; std::filesystem::exists(source)) sources.push_back(source);
    exports::checkTargets(target.paths(name, scene ? &*scene : nullptr), sources, overwrite);
    if (scene) exports::checkSceneName(*target.scene, name.filename().string());
    exports::ExportResult result = exports::makeExport(target, material.edited(), options, control);
    if (scene) exports::addScene(result, target, *scene, name);
    files = exports::exportedFiles(result, name);
    exports::writeExport(files);
    return result;
  });
  py::list paths;
  for (const exports::ExportFile& file : files) paths.append(toPath(file.path));
  py::dict facts, row;
  for (const exports::ExportFact& fact : made.facts)
    std::visit([&](const auto& value) { facts[py::str(std::string(fact.key))] = value; }, fact.value);
  row["files"] = paths;
  row["snr"] = made.snr;
  row["brdf_snr"] = made.brdfSnr;
  row["losses"] = made.losses;
  row["bytes"] = made.bytes();
  row["facts"] = facts;
  row["warnings"] = toTexts(made.warnings);
  row["material"] = py::none();
  if (made.brdf) row["material"] = newMaterial(material.shown().name, std::string(target.label), made.brdf);
  return row;
}

py::list targets() {
  py::list list;
  for (const exports::ExportTarget& target : exports::exportTargets())
    list.append(
        py::make_tuple(target.id, target.label, target.description, target.limitations, target.scene != nullptr));
  return list;
}

}  // namespace

void bindPictures(py::module_& module) {
  module.def("render", render);
  module.def("effects", effects);
  module.def("scenes", rendering::bundledSceneNames);
  module.def("compare", compare);
  py::class_<StudyRequest>(module, "StudyRequest")
      .def(py::init<>())
      .def_readwrite("representations", &StudyRequest::names)
      .def_readwrite("models", &StudyRequest::models)
      .def_readwrite("baselines", &StudyRequest::baselines)
      .def_readwrite("terms", &StudyRequest::terms)
      .def_readwrite("coefficients", &StudyRequest::coefficients)
      .def_readwrite("components", &StudyRequest::components)
      .def_readwrite("npf", &StudyRequest::npf);
  module.def("study", runStudy);
  module.def("export", exportMaterial);
  module.def("targets", targets);
}

}  // namespace gonio::python
