// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies interpolation: the tables of docs/results/interpolation.md. Half way between two GGX materials of
// different roughness (or colour) the truth is known. For each space: the rendered SNR of what it gives against the
// material whose roughness is the geometric mean, and against the GGX material that comes nearest, with that one's
// roughness.
//
// gonio_studies interpolation detail (3 minutes): the spaces that lose detail, with and without the measured detail:
// at these GGX materials; at near-measured paints, whose highlight an edit by lobes makes narrower for one end and
// wider for the other, so that the paint itself is the truth in between; and near the ends, at a weight of 0.995.
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/editing/edit.h"
#include "core/fitting/fit.h"
#include "core/interpolation/interpolation.h"
#include "core/materials/bundled_library.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/metrics/image_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "core/sampling/fitted_densities.h"
#include "tests/studies/study_program.h"

namespace gonio::study::interpolation_study {
namespace {

using interpolation::InterpolationSpace;

struct Ends {
  double firstRoughness, secondRoughness;
  Rgb firstDiffuse, secondDiffuse;
};

std::unique_ptr<const Brdf> ggx(const Rgb& diffuse, double roughness) {
  const models::ModelSpec& spec = models::ggx().spec();
  models::ParameterValues parameters = models::defaultParameters(spec);
  parameters.values[*spec.find("diffuse")] = diffuse;
  parameters.values[*spec.find("specular")] = Rgb(0.6);
  parameters.values[*spec.find("roughness")] = Rgb(roughness);
  parameters.values[*spec.find("f0")] = Rgb(0.1);
  return models::ggx().instantiate(parameters);
}

struct Row {
  const char* name;
  interpolation::InterpolationSpace space;
  const char* model;
  int terms;
};
constexpr Row rows[] = {{"linear", interpolation::InterpolationSpace::linear, "ggx", 0},
                        {"parameters, GGX", interpolation::InterpolationSpace::parameters, "ggx", 0},
                        {"parameters, Ward", interpolation::InterpolationSpace::parameters, "ward", 0},
                        {"differential, GGX", interpolation::InterpolationSpace::differential, "ggx", 0},
                        {"differential, Ward", interpolation::InterpolationSpace::differential, "ward", 0},
                        {"factors, 1 term", interpolation::InterpolationSpace::factors, "ggx", 1},
                        {"factors, 10 terms", interpolation::InterpolationSpace::factors, "ggx", 10}};

/// What the space of dictionaries is where codes leave nothing out.
std::shared_ptr<const TabulatedBrdf> transformedMean(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  std::vector<TabulatedBrdf::Value> values(a.grid().size());
  for (std::size_t cell = 0; cell < values.size(); ++cell)
    for (int c = 0; c < 3; ++c)
      values[cell][c] =
          float(std::expm1((std::log1p(double(a.values()[cell][c])) + std::log1p(double(b.values()[cell][c]))) / 2));
  return std::make_shared<const TabulatedBrdf>(a.grid(), std::move(values),
                                               std::vector<std::uint8_t>(a.valid().begin(), a.valid().end()));
}

/// Pictures of the family between the ends: all share their noise.
struct Family {
  std::vector<double> roughnesses;
  std::vector<Image> pictures;
};

void print(const Ends& ends) {
  const Rgb diffuse = (ends.firstDiffuse + ends.secondDiffuse) / 2.0;
  const double middle = std::sqrt(ends.firstRoughness * ends.secondRoughness);
  const auto truth = ggx(diffuse, middle);
  const rendering::Scene scene = rendering::comparisonScene();
  const rendering::RenderOptions render{
      .width = 160, .height = 160, .samples = 48, .density = estimateSamplingDensity(*truth)};
  const Image picture = rendering::renderPicture(*truth, scene, render);
  Family family;
  constexpr int members = 25;
  for (int m = 0; m < members; ++m) {
    family.roughnesses.push_back(ends.firstRoughness *
                                 std::pow(ends.secondRoughness / ends.firstRoughness, double(m) / (members - 1)));
    family.pictures.push_back(rendering::renderPicture(*ggx(diffuse, family.roughnesses.back()), scene, render));
  }
  const std::vector<interpolation::InterpolationMaterial> materials{
      {.table = bakeTable(*ggx(ends.firstDiffuse, ends.firstRoughness))},
      {.table = bakeTable(*ggx(ends.secondDiffuse, ends.secondRoughness))}};
  std::printf("\n| roughness %g and %g, truth %.3g | SNR, dB | nearest: roughness | SNR, dB |\n|---|---|---|---|\n",
              ends.firstRoughness, ends.secondRoughness, middle);
  const auto printRow = [&](const char* name, const Brdf& between) {
    const Image result = rendering::renderPicture(between, scene, render);
    std::size_t nearest = 0;
    std::vector<double> snr;
    for (const Image& member : family.pictures) snr.push_back(metrics::signalToNoiseRatio(member, result));
    for (std::size_t m = 1; m < snr.size(); ++m)
      if (snr[m] > snr[nearest]) nearest = m;
    std::printf("| %s | %.1f | %.3f | %.1f |\n", name, metrics::signalToNoiseRatio(picture, result),
                family.roughnesses[nearest], snr[nearest]);
    std::fflush(stdout);
  };
  for (const Row& row : rows) {
    interpolation::InterpolationOptions options;
    options.preserveDetail = false;
    options.model = &models::findModel(row.model);
    if (row.terms > 0) options.pdv.terms = row.terms;
    const auto between = interpolation::prepareInterpolation(row.space, materials, options);
    printRow(row.name, *between->table(std::vector{0.5, 0.5}));
  }
  printRow("dictionary, log-plus, all coefficients", *transformedMean(*materials[0].table, *materials[1].table));
}

/// A blend with a known middle.
struct Truth {
  std::string name;
  std::vector<interpolation::InterpolationMaterial> ends;
  std::shared_ptr<const Brdf> middle;
};

Truth ggxTruth(double first, double second) {
  const Rgb grey(0.1);
  char name[32];
  std::snprintf(name, sizeof name, "GGX %g, %g", first, second);
  return {name,
          {{.table = bakeTable(*ggx(grey, first))}, {.table = bakeTable(*ggx(grey, second))}},
          bakeTable(*ggx(grey, std::sqrt(first * second)))};
}

/// A near-measured paint between two that an edit by lobes made from it: `factor` times as narrow, and as wide.
Truth paintTruth(const char* paint, double factor) {
  const materials::Material material = materials::readMaterial(std::string("library:merl-copy/") + paint);
  const models::Model& model = models::ggx();
  editing::DifferentialEdit edit = editing::unchangedEdit(model, fitting::fit(*material.tabulated(), model).parameters);
  Truth truth{std::string(paint), {}, material.tabulated()};
  for (const double roughness : {1 / factor, factor}) {
    edit.controls.values[std::size_t(editing::ArtistControl::roughness)] = Rgb(roughness);
    truth.ends.push_back({.table = editing::bakeEdits(material.tabulated(), editing::EditList{{edit}})});
  }
  return truth;
}

constexpr Row lossyRows[] = {{"parameters, GGX", InterpolationSpace::parameters, "ggx", 0},
                             {"parameters, Ward", InterpolationSpace::parameters, "ward", 0},
                             {"factors, 3 terms", InterpolationSpace::factors, "ggx", 3},
                             {"factors, 10 terms", InterpolationSpace::factors, "ggx", 10},
                             {"dictionary, 1,024 coefficients", InterpolationSpace::dictionary, "ggx", 0}};

std::shared_ptr<const interpolation::Interpolation> prepared(
    const Row& row, const std::vector<interpolation::InterpolationMaterial>& ends, bool preserveDetail) {
  interpolation::InterpolationOptions options{.preserveDetail = preserveDetail, .model = &models::findModel(row.model)};
  if (row.terms > 0) options.pdv.terms = row.terms;
  const auto dictionary = materials::bundledEnsemble();
  options.ensemble = {dictionary, &dictionary->ensemble};
  return interpolation::prepareInterpolation(row.space, ends, options);
}

/// Rendered SNR against a material, of pictures that share their noise.
class Pictures {
 public:
  explicit Pictures(const Brdf& truth)
      : render_{.width = 128, .height = 128, .samples = 32, .density = estimateSamplingDensity(truth)},
        picture_(rendering::renderPicture(truth, scene_, render_)) {}
  double snr(const Brdf& brdf) const {
    return metrics::signalToNoiseRatio(picture_, rendering::renderPicture(brdf, scene_, render_));
  }

 private:
  rendering::Scene scene_ = rendering::comparisonScene();
  rendering::RenderOptions render_;
  Image picture_;
};

void printDetail(const Truth& truth) {
  const Pictures middle(*truth.middle), first(*truth.ends[0].table);
  std::printf("\n| %s | middle: off | on | weight 0.995: off | on |\n|---|---|---|---|---|\n", truth.name.c_str());
  const auto linear = interpolation::prepareInterpolation(InterpolationSpace::linear, truth.ends);
  const std::vector<double> half{0.5, 0.5}, begun{0.995, 0.005};
  std::printf("| linear | %.1f | | %.1f | |\n", middle.snr(*linear->brdf(half)), first.snr(*linear->brdf(begun)));
  for (const Row& row : lossyRows) {
    const auto off = prepared(row, truth.ends, false), on = prepared(row, truth.ends, true);
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", row.name, middle.snr(*off->brdf(half)),
                middle.snr(*on->brdf(half)), first.snr(*off->brdf(begun)), first.snr(*on->brdf(begun)));
    std::fflush(stdout);
  }
}

int detail() {
  for (const auto& [first, second] : {std::pair{0.1, 0.2}, {0.1, 0.4}}) printDetail(ggxTruth(first, second));
  for (const char* paint : {"blue-metallic-paint", "gold-paint", "dark-red-paint"}) printDetail(paintTruth(paint, 1.5));
  return 0;
}

int study(int count, char** arguments) {
  if (count > 1 && std::string_view(arguments[1]) == "detail") return detail();
  const Rgb grey(0.1), red(0.3, 0.05, 0.05), blue(0.05, 0.1, 0.3);
  for (const Ends& ends :
       {Ends{0.1, 0.2, grey, grey}, Ends{0.1, 0.4, grey, grey}, Ends{0.05, 0.6, grey, grey}, Ends{0.2, 0.2, red, blue}})
    print(ends);
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::interpolation_study
