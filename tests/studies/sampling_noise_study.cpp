// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies sampling_noise [MATERIAL ...]: noise of the path tracer at equal time, by representation: directions
// from the density that is chosen for the representation (RenderMaterial) against one fitted GGX lobe. Pictures of the
// scene of every rendered SNR, 128 x 128, 16 samples, against 512 of the chosen density; root mean square error over
// the root mean square of the picture. Time is processor time, so that other work on the machine counts little.
// Columns: error of the lobe in the time that the chosen density takes, error of the latter, their ratio; with lights
// sampled too (as pictures are rendered), then from the material alone. MATERIAL are bundled RGL files.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "core/brdf/utia_brdf.h"
#include "core/editing/edit.h"
#include "core/factorization/pdv_factors.h"
#include "core/fitting/fit.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "core/rendering/path_tracer.h"
#include "core/rendering/render_picture.h"
#include "tests/studies/study_program.h"

namespace gonio::study::sampling_noise_study {
namespace {

using Strategy = rendering::PathTracer::Strategy;

constexpr int side = 128, samples = 16, referenceSamples = 512;

struct Picture {
  rendering::Film film{side, side};
  double seconds = 0;
};

Picture render(const rendering::Scene& scene, const std::shared_ptr<const rendering::RenderMaterial>& material,
               Strategy strategy, int count, std::uint64_t seed) {
  const rendering::RenderMaterials materials =
      rendering::bindMaterials(scene, rendering::materialsInSlots(scene, material));
  const rendering::PathTracer tracer(scene, materials, rendering::planEffects(scene, materials, {}), seed, strategy);
  Picture picture;
  const std::clock_t start = std::clock();
  tracer.accumulate(picture.film, count, {});
  picture.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  return picture;
}

double errorOf(const rendering::Film& film, const rendering::Film& reference) {
  double difference = 0, total = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const Rgb truth = reference.radiance[i] / double(reference.samples);
    const Rgb error = film.radiance[i] / double(film.samples) - truth;
    difference += glm::dot(error, error);
    total += glm::dot(truth, truth);
  }
  return std::sqrt(difference / total);
}

/// What a table, a file of an anisotropic grid and so on make of one material.
std::vector<std::pair<std::string, std::shared_ptr<const Brdf>>> representations(
    const std::shared_ptr<const Brdf>& file) {
  const auto table = bakeTable(*file);
  const auto circle = bakeTable(*file, {.phiDCount = 360, .reciprocal = false});
  std::vector<glm::vec3> values;
  const auto direction = [](std::size_t i) {
    return fromSpherical(double(i / UtiaBrdf::azimuthCount) * UtiaBrdf::polarStep,
                         double(i % UtiaBrdf::azimuthCount) * UtiaBrdf::azimuthStep);
  };
  for (std::size_t i = 0; i < UtiaBrdf::directionCount; ++i)
    for (std::size_t v = 0; v < UtiaBrdf::directionCount; ++v)
      values.emplace_back(file->evaluate(direction(v), direction(i)));
  const auto factors = factorization::factorizePdv(*table, {.terms = 10}).factors;
  const fitting::FitResult fit = fitting::fit(*table, models::ggx(), {});
  editing::DifferentialEdit change{fit.model, fit.parameters, fit.parameters, editing::defaultComposition(*fit.model)};
  const auto roughness = *fit.model->spec().find("roughness");
  change.edited.values[roughness] = glm::min(Rgb(1), change.edited.values[roughness] * 2.0);
  return {{"RGL file", file},
          {"RGL file, roughness x 2", editing::applyEdits(file, editing::EditList{{change}})},
          {"table 90 x 90 x 180", table},
          {"table 90 x 90 x 360", circle},
          {"UTIA grid", std::make_shared<const UtiaBrdf>(std::move(values))},
          {"PDV factors, 10 terms", factorization::makePdvBrdf(factors)},
          {"GGX model", fit.model->instantiate(fit.parameters)}};
}

int run(const std::vector<std::string>& names) {
  const rendering::Scene scene = rendering::comparisonScene();
  std::printf(
      "material, representation, closed form, chosen, ratio, closed form (material alone), chosen (material alone), "
      "ratio\n");
  for (const std::string& name : names)
    for (const auto& [kind, brdf] : representations(materials::readMaterial("library:rgl/" + name).brdf)) {
      const auto own = std::make_shared<const rendering::RenderMaterial>(brdf);
      const auto closedForm = std::make_shared<const rendering::RenderMaterial>(
          brdf, estimateSamplingDensity(*brdf), rendering::RenderMaterial::DensityUse::always);
      const rendering::Film reference = render(scene, own, Strategy::both, referenceSamples, 2).film;
      std::printf("%s, %s", name.c_str(), kind.c_str());
      for (const Strategy strategy : {Strategy::both, Strategy::materials}) {
        const Picture a = render(scene, closedForm, strategy, samples, 1), b = render(scene, own, strategy, samples, 1);
        const double fitted = errorOf(a.film, reference) * std::sqrt(a.seconds / b.seconds),
                     density = errorOf(b.film, reference);
        std::printf(", %.4f, %.4f, %.2f", fitted, density, fitted / density);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  return 0;
}

int study(int count, char** values) {
  std::vector<std::string> names(values + 1, values + count);
  if (names.empty()) names = {"satin_purple", "vch_golden_yellow", "cc_iris_purple_gem", "acrylic_felt_green"};
  return run(names);
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::sampling_noise_study
