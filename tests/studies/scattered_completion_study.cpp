// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies scattered_completion: materials of which values at scattered pairs of directions are known, completed
// by the principal components that files of points are read with, and by the prior of the bundled dictionary; both know
// the bundled materials. Every other point is given, the others are predicted: exp of the root mean square of the log
// of (predicted w + 1e-3) / (true w + 1e-3), w the cosines of max(cos, 0.001) multiplied, and rendered SNR of the whole
// material (128 x 128, 16 samples). Materials: models that neither has seen, then three bundled files, which both have.
// Directions: 205 pairs over the hemispheres as of CUReT, four angles of incidence in the plane as of ASTM files, and
// the hemisphere for one angle of incidence as of pgII files.
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include "core/acquisition/dictionary_reconstruction.h"
#include "core/acquisition/reconstruction.h"
#include "core/brdf/neural_brdf.h"
#include "core/materials/basis_file.h"
#include "core/materials/bundled_library.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/models/registry.h"
#include "core/rendering/render_picture.h"
#include "tests/studies/study_program.h"

namespace gonio::study::scattered_completion_study {
namespace {

using namespace gonio::rendering;
using namespace gonio::acquisition;

std::shared_ptr<const Brdf> model(const char* id, const Rgb& diffuse, double roughness, double f0) {
  const models::ModelSpec& spec = models::findModel(id).spec();
  models::ParameterValues values = models::defaultParameters(spec);
  const auto set = [&](const char* name, const Rgb& value) {
    if (const auto index = spec.find(name)) values.values[*index] = value;
  };
  set("diffuse", diffuse);
  set("specular", Rgb(0.8, 0.75, 0.7));
  set("roughness", Rgb(roughness));
  set("f0", Rgb(f0));
  return models::findModel(id).instantiate(values);
}

struct Tested {
  std::string name;
  std::shared_ptr<const Brdf> brdf;
};

std::vector<Tested> materials() {
  std::vector<Tested> all{{"GGX, matte red", model("ggx", {0.4, 0.05, 0.04}, 0.5, 0.04)},
                          {"GGX, glossy blue", model("ggx", {0.02, 0.05, 0.3}, 0.12, 0.05)},
                          {"GGX, metal", model("ggx", Rgb(0), 0.25, 0.9)},
                          {"Ward, green", model("ward", {0.05, 0.3, 0.1}, 0.2, 0.05)},
                          {"Oren-Nayar, clay", model("oren-nayar", {0.5, 0.3, 0.2}, 0.4, 0.04)},
                          {"Cook-Torrance, bronze", model("cook-torrance", {0.05, 0.03, 0.01}, 0.3, 0.6)}};
  for (const char* name : {"acrylic_felt_green", "satin_purple", "vch_golden_yellow"})
    all.push_back({name, materials::readMaterial(std::string("library:rgl/") + name).brdf});
  return all;
}

using Pairs = std::vector<DirectionPair>;

Pairs everywhere(std::size_t count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] {
    return fromSpherical(radians(85) * std::sqrt(uniform(random)), 2 * pi * uniform(random));
  };
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i) pairs.push_back({direction(), direction()});
  return pairs;
}

Pairs inPlane() {
  Pairs pairs;
  for (const double incident : {5.0, 25.0, 45.0, 65.0})
    for (double angle = -84; angle <= 84; angle += 3)
      pairs.push_back(
          {fromSpherical(radians(incident), 0), fromSpherical(radians(std::abs(angle)), angle < 0 ? 0 : pi)});
  return pairs;
}

Pairs oneIncidence() {
  Pairs pairs;
  for (double polar = 3; polar <= 84; polar += 3)
    for (double azimuth = 0; azimuth < 360; azimuth += 15)
      pairs.push_back({fromSpherical(radians(35), 0), fromSpherical(radians(polar), radians(azimuth))});
  return pairs;
}

double cosines(const DirectionPair& pair) { return std::max(pair.wi.z, 1e-3) * std::max(pair.wo.z, 1e-3); }

/// The factor to which points are predicted.
double factorOf(const Brdf& found, const Brdf& truth, const Pairs& pairs) {
  double sum = 0;
  for (const DirectionPair& pair : pairs)
    for (int c = 0; c < 3; ++c) {
      const double w = cosines(pair), a = std::max(0.0, found.evaluate(pair.wi, pair.wo)[c]),
                   b = std::max(0.0, truth.evaluate(pair.wi, pair.wo)[c]);
      sum += std::pow(std::log((a * w + 1e-3) / (b * w + 1e-3)), 2);
    }
  return std::exp(std::sqrt(sum / (3 * double(pairs.size()))));
}

/// The points that are given, where a reconstruction knows their nodes, each node once.
struct Given {
  SamplingPlan plan;
  MeasuredValues values;

  Given(const Brdf& truth, const Pairs& pairs, const HalfDifferenceGrid& grid,
        const std::function<bool(std::uint32_t)>& known) {
    std::vector<std::uint32_t> seen;
    for (const DirectionPair& pair : pairs) {
      const std::uint32_t node = nearestNode(grid, pair);
      if (!known(node) || std::ranges::find(seen, node) != seen.end()) continue;
      seen.push_back(node);
      const int index = int(seen.size());
      plan.samples.push_back({index, grid.directions(node), index});
      values.rgb.push_back(glm::max(Rgb(0), truth.evaluate(pair.wi, pair.wo)));
    }
  }
};

dictionary::TrainingMaterials bundledTraining() {
  dictionary::TrainingMaterials training;
  std::vector<std::function<std::shared_ptr<const Brdf>()>> all;
  for (const materials::MeasuredMaterial& one : materials::measuredMaterials()) {
    training.names.push_back(one.name);
    all.push_back([&one] { return materials::measuredMaterial(one).brdf; });
  }
  for (const materials::NearMeasuredMaterial& copy : materials::nearMeasuredMaterials())
    if (!materials::isOriginalBundled(copy)) {
      training.names.push_back(copy.name);
      all.push_back([&copy] { return std::make_shared<const NeuralBrdf>(copy.weights); });
    }
  training.load = [all](std::size_t m) { return bakeTable(*all[m]()); };
  return training;
}

int run() {
  const auto basis = materials::bundledBasis();
  const auto dictionary = materials::bundledEnsemble();
  const DictionaryPrior prior = learnDictionaryPrior(dictionary->ensemble, bundledTraining());
  const std::pair<const char*, Pairs> geometries[] = {
      {"205 pairs", everywhere(205)}, {"four angles", inPlane()}, {"one angle", oneIncidence()}};
  std::printf(
      "| material | directions | components: factor | dB | dictionaries: factor | dB |\n|---|---|---|---|---|---|\n");
  for (const Tested& tested : materials()) {
    const RenderedComparison comparison(*tested.brdf, {.width = 128, .height = 128, .samples = 16});
    const auto snr = [&](const Brdf& found) { return comparison.signalToNoiseRatio(comparison.render(found)); };
    for (const auto& [name, pairs] : geometries) {
      Pairs given, asked;
      for (std::size_t i = 0; i < pairs.size(); ++i) (i % 2 ? asked : given).push_back(pairs[i]);
      const dictionary::MappedCells& mapping = basis->components.mapping;
      const Given some(*tested.brdf, given, mapping.grid, [&](std::uint32_t node) {
        return std::binary_search(mapping.cells.begin(), mapping.cells.end(), node);
      });
      const auto ridge = reconstruct(basis->components, some.plan, some.values, {.uncertainty = false});
      const Given others(*tested.brdf, given, prior.grid,
                         [&](std::uint32_t node) { return prior.grid.nodeAboveHorizon(node); });
      const auto coded = reconstructInDictionaries(dictionary->ensemble, prior, others.plan, others.values);
      std::printf("| %s | %s | %.2f | %.1f | %.2f | %.1f |\n", tested.name.c_str(), name,
                  factorOf(*ridge.table, *tested.brdf, asked), snr(*ridge.table),
                  factorOf(*coded.table, *tested.brdf, asked), snr(*coded.table));
      std::fflush(stdout);
    }
  }
  return 0;
}

int study(int, char**) { return run(); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::scattered_completion_study
