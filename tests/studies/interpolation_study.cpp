// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// interpolation_study: the table of docs/interpolation.md. Half way between two GGX materials of different roughness
// (or colour) the truth is known. For each space: the rendered SNR of what it gives against the material whose
// roughness is the geometric mean, and against the GGX material that comes nearest, with that one's roughness.
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/brdf/sampling_lobe.h"
#include "core/editing/interpolation/interpolation.h"
#include "core/metrics/image_metrics.h"
#include "core/models/registry.h"
#include "core/rendering/sphere_renderer.h"

using namespace gonio;

namespace {

using editing::InterpolationSpace;

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
  InterpolationSpace space;
  const char* model;
  int terms;
};
constexpr Row rows[] = {{"linear", InterpolationSpace::linear, "ggx", 0},
                        {"parameters, GGX", InterpolationSpace::parameters, "ggx", 0},
                        {"parameters, Ward", InterpolationSpace::parameters, "ward", 0},
                        {"differential, GGX", InterpolationSpace::differential, "ggx", 0},
                        {"differential, Ward", InterpolationSpace::differential, "ward", 0},
                        {"factors, 1 term", InterpolationSpace::factors, "ggx", 1},
                        {"factors, 10 terms", InterpolationSpace::factors, "ggx", 10}};

/// Pictures of the family between the ends: all share their noise.
struct Family {
  std::vector<double> roughnesses;
  std::vector<Image> pictures;
};

void print(const Ends& ends) {
  const Rgb diffuse = (ends.firstDiffuse + ends.secondDiffuse) / 2.0;
  const double middle = std::sqrt(ends.firstRoughness * ends.secondRoughness);
  const auto truth = ggx(diffuse, middle);
  const SphereScene scene = comparisonScene();
  const SphereRenderOptions render{.width = 160, .height = 160, .samples = 48, .lobe = estimateSamplingLobe(*truth)};
  const Image picture = renderSphere(*truth, scene, render);
  Family family;
  constexpr int members = 25;
  for (int m = 0; m < members; ++m) {
    family.roughnesses.push_back(ends.firstRoughness *
                                 std::pow(ends.secondRoughness / ends.firstRoughness, double(m) / (members - 1)));
    family.pictures.push_back(renderSphere(*ggx(diffuse, family.roughnesses.back()), scene, render));
  }
  const std::vector<editing::InterpolationEnd> materials{
      {.table = bakeTable(*ggx(ends.firstDiffuse, ends.firstRoughness))},
      {.table = bakeTable(*ggx(ends.secondDiffuse, ends.secondRoughness))}};
  std::printf("\n| roughness %g and %g, truth %.3g | SNR, dB | nearest: roughness | SNR, dB |\n|---|---|---|---|\n",
              ends.firstRoughness, ends.secondRoughness, middle);
  for (const Row& row : rows) {
    editing::InterpolationOptions options;
    options.model = &models::findModel(row.model);
    if (row.terms > 0) options.pdv.terms = row.terms;
    const auto between = editing::prepareInterpolation(row.space, materials, options);
    const Image result = renderSphere(*between->table(std::vector{0.5, 0.5}), scene, render);
    std::size_t nearest = 0;
    std::vector<double> snr;
    for (const Image& member : family.pictures) snr.push_back(metrics::signalToNoiseRatio(member, result));
    for (std::size_t m = 1; m < snr.size(); ++m)
      if (snr[m] > snr[nearest]) nearest = m;
    std::printf("| %s | %.1f | %.3f | %.1f |\n", row.name, metrics::signalToNoiseRatio(picture, result),
                family.roughnesses[nearest], snr[nearest]);
    std::fflush(stdout);
  }
}

}  // namespace

int main() {
  const Rgb grey(0.1), red(0.3, 0.05, 0.05), blue(0.05, 0.1, 0.3);
  for (const Ends& ends :
       {Ends{0.1, 0.2, grey, grey}, Ends{0.1, 0.4, grey, grey}, Ends{0.05, 0.6, grey, grey}, Ends{0.2, 0.2, red, blue}})
    print(ends);
}
