// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// Factors over PDV coordinates, importance sampling, and differential editing: figures 4.3, 4.4, 4.8.
#include <algorithm>
#include <cmath>

#include "core/editing/differential_edit.h"
#include "core/fitting/fit.h"
#include "core/materials/edited_material.h"
#include "core/metrics/image_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/effect_plan.h"
#include "core/rendering/error_maps.h"
#include "core/rendering/path_tracer.h"
#include "core/rendering/sampling_method.h"
#include "core/rendering/scene_file.h"
#include "core/reproduction/charts.h"
#include "core/reproduction/figure_record.h"
#include "core/sampling/fitted_densities.h"
#include "core/study/representation_builder.h"
#include "core/support/text.h"

namespace gonio::reproduction {

namespace {

// Figures 4.3 and 4.4: three spheres side by side.

/// The bundled scene "row" without its ground, the spheres as large as the picture allows.
rendering::Scene rowScene() {
  rendering::Scene scene = rendering::openScene("row", 3);
  std::erase_if(scene.objects, [](const rendering::SceneObject& object) {
    return !std::holds_alternative<rendering::MaterialSlot>(object.material);
  });
  constexpr double halfHeight = 1.2;
  scene.camera.distance = halfHeight / std::tan(scene.camera.fieldOfView / 2);
  scene.camera.target = Direction(0);
  return scene;
}
constexpr int rowAspect = 3;

std::vector<InputMaterial> subjectsOf(const FigureRecord& record, const Inputs& inputs) {
  std::vector<InputMaterial> materials;
  for (const Subject& subject : record.subjects) materials.push_back(inputs.find(subject));
  return materials;
}

std::string listedNames(const std::vector<InputMaterial>& materials) {
  std::string text;
  for (const InputMaterial& material : materials) text += (text.empty() ? "" : ", ") + shownName(material);
  return text;
}

Image rowPicture(const rendering::RenderMaterials& materials, const rendering::RenderOptions& options,
                 rendering::PathTracer::Strategy strategy, const TaskControl& control) {
  const rendering::Scene scene = rowScene();
  const rendering::RenderMaterials bound = rendering::bindMaterials(scene, materials);
  rendering::EffectOverrides overrides;
  overrides[std::size_t(rendering::Effect::anisotropicFrames)] = true;
  rendering::Film film(options.width, options.height);
  rendering::PathTracer(scene, bound, rendering::planEffects(scene, bound, overrides), options.seed, strategy)
      .accumulate(film, options.samples, control);
  return film.image();
}

rendering::RenderOptions rowOptions(int height, int samples) {
  return {.width = rowAspect * height, .height = height, .samples = samples, .density = {}};
}

/// Two pictures with independent noise; all materials of a slot are sampled with the density of its measurement.
metrics::PicturePair rowPair(const std::vector<std::shared_ptr<const Brdf>>& brdfs,
                             const std::vector<SamplingDensity>& densities, const rendering::RenderOptions& options,
                             const TaskControl& control) {
  metrics::PicturePair pair;
  for (std::size_t half = 0; half < 2; ++half) {
    rendering::RenderOptions own = options;
    own.seed = options.seed + half;
    rendering::RenderMaterials materials;
    for (std::size_t i = 0; i < brdfs.size(); ++i) {
      own.density = densities[i];
      materials.push_back(rendering::pictureMaterial(*brdfs[i], own));
    }
    pair[half] = rowPicture(materials, own, rendering::PathTracer::Strategy::both, {control.stop, {}});
  }
  return pair;
}

/// A picture as 8-bit displays show it, channels in [0, 1].
Image asDisplayed(const Image& picture) {
  const figures::Raster raster = shownPicture(picture);
  Image shown(raster.width, raster.height);
  for (std::size_t i = 0; i < shown.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) shown.pixels[i][c] = float(raster.rgba[4 * i + std::size_t(c)]) / 255.f;
  return shown;
}

MadeFigure makeModels(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  struct Method {
    const char* name;
    study::Representation representation;
  };
  const auto factors = study::representationById("factors-3d-published", 10);
  std::vector<Method> methods{{"Lawrence et al. 2004", {}},
                              {"Bilgili et al. 2011", {}},
                              {"PDV factors, 10 terms", factors},
                              {"PDV factors, 10 terms, weighted", study::representationById("factors-3d", 10)}};
  const auto materials = subjectsOf(record, inputs);
  std::vector<std::shared_ptr<const Brdf>> references;
  std::vector<SamplingDensity> densities;
  std::vector<std::vector<std::shared_ptr<const Brdf>>> models(methods.size());
  std::vector<std::size_t> bytes(methods.size());
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto table = inputs.table(materials[m], control);
    references.push_back(table);
    densities.push_back(estimateSamplingDensity(*table));
    const auto built = [&](const study::Representation& representation) {
      study::RepresentationBuilder builder({table, table}, {}, std::array{representation});
      return builder.build(representation, {control.stop, {}});
    };
    const study::BuiltRepresentation ours = built(factors);
    methods[0].representation = study::representationById("lawrence", double(ours.bytes));
    methods[1].representation = study::representationById("bilgili", double(ours.bytes));
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const auto model = methods[i].representation == factors ? ours : built(methods[i].representation);
      models[i].push_back(model.brdf);
      bytes[i] = std::max(bytes[i], model.bytes);
      control.report(0.7 * double(m * methods.size() + i + 1) / double(materials.size() * methods.size()));
    }
  }
  const rendering::RenderOptions options = inputs.quick() ? rowOptions(64, 32) : rowOptions(192, 128);
  const metrics::PicturePair reference = rowPair(references, densities, options, control);
  const Image shownReference = asDisplayed(reference[0]);
  MadeFigure made;
  std::vector<std::string> columns{"Reference"}, names;
  std::vector<Image> pictures;
  std::vector<double> ratios, linear;
  PictureRow shown{"pictures", {{shownPicture(reference[0])}}}, errors{"difference", {{}}};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const metrics::PicturePair pair = rowPair(models[i], densities, options, control);
    ratios.push_back(metrics::decibels(1, metrics::meanSquaredError(shownReference, asDisplayed(pair[0]))));
    linear.push_back(metrics::peakSignalToNoiseRatio(reference, pair));
    pictures.push_back(pair[0]);
    names.emplace_back(methods[i].name);
    columns.push_back(names.back());
    shown.cells.push_back(
        {shownPicture(pair[0]),
         {"PSNR " + shortText(ratios.back()) + " dB", shortText(double(bytes[i]) / 1000, 3) + " kB"}});
    made.values.push_back({names.back() + ", PSNR", "dB", ratios.back()});
    made.values.push_back({names.back() + ", PSNR of linear pictures, without their noise", "dB", linear.back()});
    control.report(0.7 + 0.3 * double(i + 1) / double(methods.size()));
  }
  const double range = rendering::errorRange(reference[0], pictures);
  for (const Image& picture : pictures) errors.cells.push_back({errorPicture(reference[0], picture, range)});
  errors.cells.front().lines = {"luminance from 0 (dark) to " + shortText(range, 3)};
  made.drawing = drawPictures(std::string(record.title), columns, std::array{shown, errors},
                              "Three spheres in the studio environment: " + listedNames(materials) + ".");
  made.table.columns = {{"method", {}, names},
                        {"PSNR [dB]", ratios},
                        {"PSNR of linear pictures [dB]", linear},
                        {"bytes of a material", {}}};
  for (const std::size_t size : bytes) made.table.columns.back().values.push_back(double(size));
  return made;
}

MadeFigure makeSampling(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const auto materials = subjectsOf(record, inputs);
  struct Method {
    const char *id, *name;
  };
  constexpr std::array<Method, 6> methods{{{"lawrence", "Lawrence et al. 2004"},
                                           {"bilgili", "Bilgili et al. 2011"},
                                           {"published", "PDV, as published"},
                                           {"pdv", "PDV, normalised"},
                                           {"ggx", "GGX"},
                                           {"cosine", "cosine"}}};
  constexpr int printedSamples = 256;
  rendering::RenderOptions options = rowOptions(inputs.quick() ? 48 : 96, 0);
  rendering::RenderMaterials sampled;
  for (const InputMaterial& material : materials)
    sampled.push_back(rendering::sampledBy("auto", inputs.table(material, control), {control.stop, {}}));
  options.samples = inputs.quick() ? 2048 : 8192;
  // The mean of two pictures, whose difference is its noise.
  Image reference = rowPicture(sampled, options, rendering::PathTracer::Strategy::both, control.between(0, 0.1));
  options.seed = runSeed + 2;
  const Image second = rowPicture(sampled, options, rendering::PathTracer::Strategy::both, control.between(0.1, 0.2));
  const double noise = metrics::meanSquaredError(reference, second) / 4;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    reference.pixels[i] = 0.5f * (reference.pixels[i] + second.pixels[i]);
  Chart chart{.title = "error over samples",
              .xTitle = "samples per pixel",
              .yTitle = "ln of the mean squared error",
              .series = {},
              .logX = true,
              .xRange = std::array{1., 512.}};
  MadeFigure made;
  std::vector<std::string> names;
  std::vector<double> counts, errors;
  std::vector<double> atPrinted;
  double lowest = 0, highest = -1e9;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    sampled.clear();
    for (const InputMaterial& material : materials)
      sampled.push_back(rendering::sampledBy(methods[i].id, inputs.table(material, control), {control.stop, {}}));
    ChartSeries series{.name = methods[i].name, .points = {}, .hasMarkers = true};
    for (int samples = 1; samples <= printedSamples; samples *= 2) {
      options.samples = samples;
      options.seed = 2;  // the noise of the reference is independent
      // Of the density alone: lights are not sampled.
      const Image picture =
          rowPicture(sampled, options, rendering::PathTracer::Strategy::materials, {control.stop, {}});
      const double error = std::log(metrics::meanSquaredError(reference, picture));
      series.points.emplace_back(samples, error);
      names.emplace_back(methods[i].name);
      counts.push_back(samples);
      errors.push_back(error);
      lowest = std::min(lowest, error);
      highest = std::max(highest, error);
    }
    atPrinted.push_back(errors.back());
    chart.series.push_back(std::move(series));
    control.report(0.2 + 0.8 * double(i + 1) / double(methods.size()));
  }
  chart.yRange = std::array{std::floor(lowest), std::ceil(highest)};
  for (std::size_t i = 0; i < methods.size(); ++i)
    if (i != 2)
      made.values.push_back({std::string(methods[i].name) + ", log MSE minus that of PDV as published, 256 samples", "",
                             atPrinted[i] - atPrinted[2]});
  made.values.push_back({"reference, log MSE by its own noise minus that of PDV as published, 256 samples", "",
                         std::log(noise) - atPrinted[2]});
  made.drawing = drawCharts(std::string(record.title) + ": " + listedNames(materials), std::array{chart}, 1);
  made.table.columns = {{"method", {}, names}, {"samples per pixel", counts}, {"ln of the mean squared error", errors}};
  return made;
}

// Figure 4.8.

MadeFigure makeEditing(const FigureRecord& record, Inputs& inputs, const TaskControl& control) {
  const InputMaterial subject = inputs.find(record.subjects[0]);
  const auto table = inputs.table(subject, control);
  const models::Model& model = models::ggx();
  const auto fit = fitting::fit(*table, model, {}, control.between(0, 0.6));
  control.throwIfStopped();
  editing::DifferentialEdit change = editing::unchangedEdit(model, fit.parameters);
  change.composition = editing::Composition::additive;
  const std::size_t roughness = *model.spec().find("roughness");
  constexpr double factor = 2;
  change.edited.values[roughness] = glm::min(Rgb(1), factor * fit.parameters.values[roughness]);
  const materials::Material base{subject.name, {}, table, table, nullptr, nullptr};
  const std::array edits{editing::Edit{change, "", 1}};
  const materials::Material edited = materials::withEdits(base, edits, {control.stop, {}});
  const std::array<std::pair<const char*, std::shared_ptr<const Brdf>>, 4> shown{
      {{"Measured", table},
       {"Fitted (GGX)", model.instantiate(fit.parameters)},
       {"Edited model", model.instantiate(change.target())},
       {"Edited measurement", edited.brdf}}};
  const rendering::RenderOptions options = inputs.picture();
  const rendering::Scene scene = rendering::comparisonScene();
  rendering::RenderOptions own = options;
  own.density = estimateSamplingDensity(*edited.brdf);
  MadeFigure made;
  PictureRow row{shownName(subject), {}};
  std::vector<std::string> columns;
  std::vector<Image> pictures;
  for (const auto& [label, brdf] : shown) {
    pictures.push_back(rendering::renderPicture(*brdf, scene, own, {control.stop, {}}));
    columns.emplace_back(label);
    row.cells.push_back({shownPicture(pictures.back())});
  }
  // Eq. 4.41 is linear in the BRDF where nothing is clamped: so are the pictures.
  Image sum = pictures[0];
  for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += pictures[2].pixels[i] - pictures[1].pixels[i];
  const double range = rendering::errorRange(pictures[1], std::array{pictures[2]});
  PictureRow residual{"residual", {{}, {}, {errorPicture(pictures[1], pictures[2], range)}, {}}};
  residual.cells[2].lines = {"edited minus fitted, luminance from 0 (dark) to " + shortText(range, 3)};
  made.drawing = drawPictures(std::string(record.title), columns, std::array{row, residual});
  const double before = fit.parameters.values[roughness].x, after = change.edited.values[roughness].x;
  const double agreement = metrics::signalToNoiseRatio(sum, pictures[3]);
  made.values = {{"roughness of the fit", "", before},
                 {"roughness of the edited model", "", after},
                 {"edited picture against measured + edited model - fitted model, SNR", "dB", agreement}};
  made.table.columns = {{"quantity", {}, {"roughness of the fit", "roughness of the edited model", "SNR [dB]"}},
                        {"value", {before, after, agreement}}};
  return made;
}

}  // namespace

std::vector<FigureRecord> factorFigures() {
  const std::vector<Subject> three{{MaterialSet::merl, "blue-metallic-paint", {"blue-metallic-paint2"}},
                                   {MaterialSet::merl, "nickel", {"aluminium", "chrome-steel"}},
                                   {MaterialSet::merl, "yellow-matte-plastic", {"yellow-plastic"}}};
  return {
      {.id = "4.3",
       .title = "Factor models at equal size",
       .shows =
           "Three materials by the factors of Lawrence et al., Bilgili et al. and PDV factors of ten terms, each in "
           "at most the bytes of the last.",
       .source = "figure 4.3, captions",
       .printed = {{"Lawrence et al. 2004, PSNR", 33.40},
                   {"Bilgili et al. 2011, PSNR", 35.27},
                   {"PDV factors, 10 terms, PSNR", 37.37}},
       .differences =
           "PSNR of pictures in 8 bits (peak 1), which the print does not define; all pictures share their "
           "random numbers. The print renders the Princeton scene with PBRT; here the scene and its light are "
           "Gonio's.",
       .subjects = three,
       .fullMinutes = 6,
       .quickMinutes = 0.5,
       .make = makeModels},
      {.id = "4.4",
       .title = "Importance sampling: error over samples",
       .shows =
           "Three materials, directions sampled from the densities of each method and lights not sampled, against a "
           "picture of many samples.",
       .source = "figure 4.4, captions: log MSE 4.0662 (Lawrence), 3.6134 (Bilgili), 3.9474 (PDV) at 256 samples; "
                 "differences of logarithms depend on neither exposure nor scale of the pixels",
       .printed = {{"Lawrence et al. 2004, log MSE minus that of PDV as published, 256 samples", 4.0662 - 3.9474, true},
                   {"Bilgili et al. 2011, log MSE minus that of PDV as published, 256 samples", 3.6134 - 3.9474, true}},
       .differences =
           "The print states neither the base of its logarithm (here e) nor the scene's lights. The published "
           "density loses the samples off the disk.",
       .subjects = three,
       .fullMinutes = 5,
       .quickMinutes = 1.5,
       .make = makeSampling},
      {.id = "4.8",
       .title = "Differential editing",
       .shows =
           "A measurement, its GGX fit, the fit with twice the roughness, and the measurement plus the change of the "
           "model (eq. 4.40 and 4.41).",
       .source = "figure 4.8: a diagram, no numbers printed",
       .differences = "Eq. 4.40 prints the absolute value of the change; here it has its sign, otherwise an edit could "
                      "only brighten.",
       .subjects = {{MaterialSet::merl, "gold-metallic-paint", {"gold-metallic-paint2", "gold-metallic-paint3"}}},
       .fullMinutes = 0.2,
       .quickMinutes = 0.1,
       .make = makeEditing},
  };
}

}  // namespace gonio::reproduction
