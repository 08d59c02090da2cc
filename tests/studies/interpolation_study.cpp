// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies interpolation: the first table of docs/results/interpolation.md. Half way between two GGX materials of
// different roughness (or colour) the truth is known. For each space: the rendered SNR of what it gives against the
// material whose roughness is the geometric mean, and against the GGX material that comes nearest, with that one's
// roughness.
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/interpolation/interpolation.h"
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

int study(int, char**) {
  const Rgb grey(0.1), red(0.3, 0.05, 0.05), blue(0.05, 0.1, 0.3);
  for (const Ends& ends :
       {Ends{0.1, 0.2, grey, grey}, Ends{0.1, 0.4, grey, grey}, Ends{0.05, 0.6, grey, grey}, Ends{0.2, 0.2, red, blue}})
    print(ends);
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::interpolation_study
