// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies photographs SHARED [MATERIAL ...]: reconstructions of RGL materials from one picture by Mitsuba 3 each
// (data/renderings in SHARED, the folder of the development data), without the material and its copies in the prior.
// Prints a row per material and method: rendered SNR against the RGL file under the light of the picture and under
// other light, dB; then the medians.
// gonio_studies photographs SHARED --span [MATERIAL ...]: the most that a linear combination of the components permits:
// the projection of the whole RGL file onto them.
// gonio_studies photographs SHARED --uncertainty [MATERIAL ...]: errors beside stated deviations alone.
// gonio_studies photographs SHARED --wrong [MATERIAL ...]: what is reported of wrong input: a shifted outline, a
// rotated environment, a wrong and an unknown exposure, clipped pixels, and pixels that are not linear.
// gonio_studies photographs SHARED --shapes [MATERIAL ...]: reconstructions from pictures by Gonio of a sphere, a
// cylinder and a flat sample, once and turned.
// gonio_studies photographs SHARED --calibration [COUNT [IMAGES ...]]: errors beside stated deviations of COUNT
// training materials that are left out of the prior, an eighth of them at a time, each from every number of pictures (1
// and 4) by Gonio under a bundled environment.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>

#include "core/brdf/data_transform.h"
#include "core/photograph/photograph_fit.h"
#include "core/study/training_files.h"
#include "tests/studies/photograph_baselines.h"
#include "tests/studies/study_program.h"
#include "tests/support/mitsuba_pictures.h"

namespace gonio::study::photographs_study {
namespace {

using photograph::PhotographPrior, photograph::PhotographSet;

constexpr HalfDifferenceGrid coarseGrid{90, 30, 36, true};

/// A MERL table at every third node in theta_d and every fifth in phi_d.
std::shared_ptr<const TabulatedBrdf> coarse(const TabulatedBrdf& fine) {
  std::vector<TabulatedBrdf::Value> values(coarseGrid.size());
  std::vector<std::uint8_t> valid(coarseGrid.size());
  for (int i = 0; i < coarseGrid.thetaHCount; ++i)
    for (int j = 0; j < coarseGrid.thetaDCount; ++j)
      for (int k = 0; k < coarseGrid.phiDCount; ++k) {
        const std::size_t from = fine.grid().index(i, 3 * j, 5 * k), to = coarseGrid.index(i, j, k);
        values[to] = fine.values()[from];
        valid[to] = fine.valid()[from];
      }
  return std::make_shared<const TabulatedBrdf>(coarseGrid, std::move(values), std::move(valid));
}

struct Training {
  std::vector<std::string> names;
  std::vector<std::shared_ptr<const TabulatedBrdf>> tables;
};

Training loadTraining() {
  Training training;
  const auto files = trainingFilesOrLibrary({});
  const auto materials = trainingMaterials(files);
  for (std::size_t m = 0; m < files.size(); ++m) {
    training.names.push_back(materials.names[m]);
    training.tables.push_back(coarse(*materials.load(m)));
  }
  return training;
}

dictionary::PrincipalComponents basisWithout(const Training& training,
                                             const std::function<bool(std::size_t material)>& isLeft, int components) {
  std::vector<std::size_t> kept;
  for (std::size_t m = 0; m < training.names.size(); ++m)
    if (!isLeft(m)) kept.push_back(m);
  return dictionary::learnPrincipalComponents(kept.size(), [&](std::size_t m) { return training.tables[kept[m]]; },
                                              {.maxComponents = components});
}

dictionary::PrincipalComponents basisWithout(const Training& training, const std::string& left, int components) {
  return basisWithout(
      training, [&](std::size_t m) { return training.names[m] == left; }, components);
}

/// The lights under which materials are compared, with the names of their columns.
struct Views {
  std::vector<std::string> names;
  std::vector<rendering::RenderedComparison> comparisons;
};

constexpr rendering::RenderOptions compared{.width = 64, .height = 64, .samples = 16, .density = {}};

Views viewsOf(const std::filesystem::path& shared, const Brdf& truth) {
  Views views;
  views.names.push_back("studio");
  views.comparisons.emplace_back(test::mitsubaScene(shared), truth, compared);
  for (const char* name : {"lobby", "sunset"}) {
    views.names.emplace_back(name);
    views.comparisons.emplace_back(rendering::sphereScene(rendering::openEnvironment(
                                       (shared / "data/environments" / (std::string(name) + ".hdr")).string())),
                                   truth, compared);
  }
  for (const int angle : {0, 20, 40, 60, 80}) {
    rendering::Scene scene = rendering::sphereScene();
    scene.directionalLights[0].toLight = {std::sin(radians(angle)), 0, std::cos(radians(angle))};
    views.names.push_back(std::to_string(angle) + " deg");
    views.comparisons.emplace_back(scene, truth, compared);
  }
  return views;
}

/// The fraction of the channels of the cells of which the error is less than the deviation.
/// @param quantile receives the factor of the deviations with which it would be 0.683.
double coverage(const dictionary::PrincipalComponents& basis, const photograph::PhotographFit& fit,
                const TabulatedBrdf& truth, const TabulatedBrdf& found, double& quantile) {
  const auto deviations = photograph::deviations(basis, fit);
  const dictionary::MappedCells& m = basis.mapping;
  std::vector<double> ratios;
  double within = 0;
  for (std::size_t i = 0; i < m.cells.size(); ++i) {
    if (!truth.valid()[m.cells[i]]) continue;
    for (int channel = 0; channel < 3; ++channel) {
      const double error = logRelative(truth.values()[m.cells[i]][channel], m.weights[i], m.reference[i]) -
                           logRelative(found.values()[m.cells[i]][channel], m.weights[i], m.reference[i]);
      within += std::abs(error) < deviations[i][channel];
      ratios.push_back(std::abs(error) / deviations[i][channel]);
    }
  }
  const auto place = ratios.begin() + std::ptrdiff_t(0.683 * double(ratios.size()));
  std::nth_element(ratios.begin(), place, ratios.end());
  quantile = *place;
  return within / double(ratios.size());
}

/// Rendered SNRs of all methods: [method][view], a value per material.
class Table {
 public:
  void add(const std::string& material, const std::string& method, const Views& views, const Brdf& test) {
    if (std::ranges::find(methods_, method) == methods_.end()) methods_.push_back(method);
    std::printf("| %s | %s |", material.c_str(), method.c_str());
    for (std::size_t v = 0; v < views.comparisons.size(); ++v) {
      const double snr = views.comparisons[v].signalToNoiseRatio(views.comparisons[v].render(test));
      (v == 0 ? same_ : other_)[method].push_back(snr);
      std::printf(" %.1f |", snr);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  void printMedians() const {
    const auto median = [](std::vector<double> values) {
      std::ranges::sort(values);
      return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
    };
    std::printf("\n| method | same light | other light |\n|---|---|---|\n");
    for (const std::string& method : methods_)
      std::printf("| %s | %.1f | %.1f |\n", method.c_str(), median(same_.at(method)), median(other_.at(method)));
  }

 private:
  std::vector<std::string> methods_;
  std::map<std::string, std::vector<double>> same_, other_;
};

PhotographSet mitsubaPhotograph(const std::filesystem::path& shared, const std::string& material) {
  const rendering::Scene scene = test::mitsubaScene(shared);
  photograph::Photograph photo{.name = material,
                               .image = test::mitsubaPicture(shared, material, 1),
                               .disc = {},
                               .camera = scene.camera,
                               .light = {.environment = scene.environment}};
  photo.disc = photograph::discOf(photo.camera, photo.image.width, photo.image.height);
  PhotographSet set;
  set.photographs.push_back(std::move(photo));
  return set;
}

/// A picture by Gonio of a material as described but for the image and its size. @param options size, samples, seed.
photograph::Photograph taken(const Brdf& truth, photograph::Photograph photo, const rendering::RenderOptions& options) {
  photo.size = {options.width, options.height};
  photo.disc = photograph::discOf(photo.camera, options.width, options.height);
  photo.image = rendering::renderPicture(truth, photograph::sceneOf(photo, options.width, options.height), options);
  return photo;
}

/// Pictures of a material by Gonio, the environment turned by equal steps.
PhotographSet photographs(const Brdf& truth, const rendering::Scene& scene, int count,
                          const rendering::RenderOptions& options) {
  PhotographSet set;
  for (int i = 0; i < count; ++i) {
    rendering::RenderOptions one = options;
    one.seed += std::uint64_t(i);
    set.photographs.push_back(taken(truth,
                                    {.name = "image " + std::to_string(i + 1),
                                     .image = {},
                                     .disc = {},
                                     .camera = scene.camera,
                                     .light = {.environment = scene.environment, .rotation = 2 * pi * i / count}},
                                    one));
  }
  return set;
}

/// @param isWhole whether to compare with the other methods; otherwise only errors and deviations are printed.
int reconstructions(const std::filesystem::path& shared, const std::vector<std::string>& materials, bool isWhole) {
  const Training training = loadTraining();
  Table table;
  double sumWithin = 0;
  for (const std::string& material : materials) {
    const auto truth = test::mitsubaMaterial(shared, material);
    const Views views = isWhole ? viewsOf(shared, *truth) : Views{};
    const auto basis = basisWithout(training, material, photograph::defaultPhotographComponents);
    const PhotographPrior prior = photograph::photographPrior(basis);
    const auto truthTable = coarse(*meanOfOrders(bakeTable(*truth, HalfDifferenceGrid())));
    const PhotographSet one = mitsubaPhotograph(shared, material);
    for (const bool four : {false, true}) {
      const PhotographSet set =
          four ? photographs(*truth, test::mitsubaScene(shared), 4,
                             {.width = 128, .height = 128, .samples = 32, .seed = 7, .density = {}})
               : one;
      const auto start = std::chrono::steady_clock::now();
      const std::clock_t startCpu = std::clock();
      const auto fit = photograph::fitPhotographs(prior, set, four ? 1200 : 600);
      const double cpu = double(std::clock() - startCpu) / CLOCKS_PER_SEC;
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const auto found = dictionary::decode(basis, fit.code);
      double quantile = 0;
      const double within = coverage(basis, fit, *truthTable, *found, quantile);
      if (!four) sumWithin += within;
      std::printf(
          "%s, %s: %.1f s (%.1f s of processor time), h %.2f, model noise %.4f, residual %.1f dB, within one "
          "deviation %.3f, factor for 0.683 %.2f, widening %.2f, unexplained %.1f dB\n",
          material.c_str(), four ? "four images" : "one image", seconds, cpu, fit.bandwidth, fit.modelNoise,
          fit.residualSnr[0], within, quantile, fit.widening, fit.unexplainedSnr);
      for (const std::string& warning : fit.warnings) std::printf("warning: %s\n", warning.c_str());
      if (isWhole) table.add(material, four ? "four photographs" : "one photograph", views, *found);
    }
    if (!isWhole) continue;
    const ImageData data = imageData(prior, one);
    std::string name;
    const auto near = nearest(data, prior, training.names, training.tables, material, name);
    table.add(material, "nearest material", views, *near);
    std::printf("nearest material: %s\n", name.c_str());
    table.add(material, "GGX", views, *fittedGgx(data));
    table.add(material, "layered lobes", views, *fittedLobes(data));
    table.add(material, "reciprocal table", views, *truthTable);
  }
  if (isWhole) table.printMedians();
  std::printf("\nmean fraction within one deviation, one photograph: %.3f\n", sumWithin / double(materials.size()));
  return 0;
}

int span(const std::filesystem::path& shared, const std::vector<std::string>& materials) {
  const Training training = loadTraining();
  Table table;
  for (const std::string& material : materials) {
    const auto truth = test::mitsubaMaterial(shared, material);
    const Views views = viewsOf(shared, *truth);
    const auto truthTable = coarse(*meanOfOrders(bakeTable(*truth, HalfDifferenceGrid())));
    const auto basis = basisWithout(training, material, std::numeric_limits<int>::max());
    for (const int components :
         {photograph::defaultPhotographComponents, 2 * photograph::defaultPhotographComponents, basis.count()}) {
      const bool isAll = components == basis.count();
      table.add(material, isAll ? "all components" : std::to_string(components) + " components", views,
                *dictionary::decode(basis, dictionary::encode(basis, *truthTable, components)));
    }
    table.add(material, "reciprocal table", views, *truthTable);
  }
  table.printMedians();
  return 0;
}

/// A picture of a surface by Gonio.
photograph::Photograph pictureOf(const Brdf& truth, const rendering::Scene& studio, const photograph::Surface& surface,
                                 double distance, std::uint64_t seed) {
  return taken(truth,
               {.name = "image " + std::to_string(seed),
                .image = {},
                .disc = {},
                .camera = {.distance = distance},
                .surface = surface,
                .light = {.environment = studio.environment}},
               {.width = 128, .height = 128, .samples = 32, .seed = seed, .density = {}});
}

/// Pictures of a flat sample that is turned between them.
PhotographSet turnedSample(const Brdf& truth, const rendering::Scene& studio, int count) {
  PhotographSet set;
  for (const double turn : {0.0, 30.0, -45.0, 65.0}) {
    if (int(set.photographs.size()) == count) break;
    const Direction normal = glm::normalize(Direction(std::sin(radians(turn)), 0.2, std::cos(radians(turn))));
    set.photographs.push_back(
        pictureOf(truth, studio, photograph::FlatSample{.normal = normal}, 4, set.photographs.size() + 1));
  }
  return set;
}

int shapes(const std::filesystem::path& shared, const std::vector<std::string>& materials) {
  const Training training = loadTraining();
  const rendering::Scene studio = test::mitsubaScene(shared);
  Table table;
  for (const std::string& material : materials) {
    const auto truth = test::mitsubaMaterial(shared, material);
    const Views views = viewsOf(shared, *truth);
    const auto basis = basisWithout(training, material, photograph::defaultPhotographComponents);
    const PhotographPrior prior = photograph::photographPrior(basis);
    const auto truthTable = coarse(*meanOfOrders(bakeTable(*truth, HalfDifferenceGrid())));
    std::vector<std::pair<std::string, PhotographSet>> sets(4);
    const char* names[] = {"sphere", "cylinder", "flat sample", "flat sample, four images"};
    for (std::size_t i = 0; i < sets.size(); ++i) sets[i].first = names[i];
    sets[0].second.photographs = {pictureOf(*truth, studio, photograph::UnitSphere{}, 4, 1)};
    sets[1].second.photographs = {pictureOf(*truth, studio, photograph::Cylinder{}, 4.6, 1)};
    sets[3].second = turnedSample(*truth, studio, 4);
    sets[2].second.photographs = {sets[3].second.photographs[0]};
    for (const auto& [name, set] : sets) {
      const auto fit = photograph::fitPhotographs(prior, set);
      const auto found = dictionary::decode(basis, fit.code);
      double quantile = 0;
      const double within = coverage(basis, fit, *truthTable, *found, quantile);
      std::printf("%s, %s: model noise %.4f, residual %.1f dB, within one deviation %.3f\n", material.c_str(),
                  name.c_str(), fit.modelNoise, fit.residualSnr[0], within);
      for (const std::string& warning : fit.warnings) std::printf("warning: %s\n", warning.c_str());
      table.add(material, name, views, *found);
    }
  }
  table.printMedians();
  return 0;
}

std::string warningsOf(const photograph::PhotographFit& fit) {
  std::string all;
  for (const std::string& warning : fit.warnings) all += (all.empty() ? "" : "; ") + warning;
  return all;
}

/// What is wrong with the input.
struct Fault {
  const char* name;
  void (*apply)(PhotographSet&);
};

const Fault faults[] = {
    {"none", [](PhotographSet&) {}},
    {"outline 3 pixels to the right", [](PhotographSet& set) { set.photographs[0].disc.x += 3; }},
    {"environment rotated by 5 degrees", [](PhotographSet& set) { set.photographs[0].light.rotation = radians(5); }},
    {"exposure 1.5 times the stated one",
     [](PhotographSet& set) {
       for (glm::vec3& pixel : set.photographs[0].image.pixels) pixel *= 1.5f;
     }},
    {"exposure 7 times the stated one",
     [](PhotographSet& set) {
       for (glm::vec3& pixel : set.photographs[0].image.pixels) pixel *= 7.0f;
     }},
    {"exposure unknown, 7 times",
     [](PhotographSet& set) {
       set.exposureKnown = false;
       for (glm::vec3& pixel : set.photographs[0].image.pixels) pixel *= 7.0f;
     }},
    {"clipped at a third of the maximum",
     [](PhotographSet& set) {
       photograph::Photograph& photo = set.photographs[0];
       float largest = 0;
       for (const glm::vec3& pixel : photo.image.pixels)
         if (std::isfinite(pixel.x + pixel.y + pixel.z)) largest = std::max({largest, pixel.x, pixel.y, pixel.z});
       for (glm::vec3& pixel : photo.image.pixels) pixel = glm::min(pixel, glm::vec3(largest / 3));
       photo.clip = photograph::clippedFrom(photo);
     }},
    {"gamma 1 / 2.2", [](PhotographSet& set) {
       for (glm::vec3& pixel : set.photographs[0].image.pixels)
         for (int c = 0; c < 3; ++c) pixel[c] = std::pow(std::max(0.0f, pixel[c]), 1 / 2.2f);
     }}};

int wrongInput(const std::filesystem::path& shared, const std::vector<std::string>& materials) {
  const Training training = loadTraining();
  std::printf(
      "| material | fault | residual, dB | clip | exposure | warnings |\n"
      "|---|---|---|---|---|---|\n");
  for (const std::string& material : materials) {
    const auto basis = basisWithout(training, material, photograph::defaultPhotographComponents);
    const PhotographPrior prior = photograph::photographPrior(basis);
    for (const Fault& fault : faults) {
      PhotographSet set = mitsubaPhotograph(shared, material);
      fault.apply(set);
      const auto fit = photograph::fitPhotographs(prior, set, 300);
      std::printf("| %s | %s | %.1f | %.3g | %.3g | %s |\n", material.c_str(), fault.name, fit.residualSnr[0],
                  set.photographs[0].clip, fit.exposure, warningsOf(fit).c_str());
      std::fflush(stdout);
    }
  }
  return 0;
}

/// Mean squared errors of mapped values, over cells and channels, and the variances that are stated: in the components
/// in use, and in those that are left out.
struct ErrorParts {
  double inside = 0, stated = 0, outside = 0, statedOutside = 0;
};

ErrorParts errorParts(const dictionary::PrincipalComponents& basis, const photograph::PhotographFit& fit,
                      const TabulatedBrdf& truth) {
  const Eigen::Index components = fit.posteriorFactors[0].rows();
  const auto projected = dictionary::encode(basis, truth, int(components));
  const auto inSpan = dictionary::decode(basis, projected);
  const dictionary::MappedCells& m = basis.mapping;
  const double cells = double(m.cells.size());
  ErrorParts parts;
  for (std::size_t c = 0; c < 3; ++c) {
    parts.inside += double((projected.channels[c] - fit.code.channels[c]).squaredNorm()) / (3 * cells);
    parts.stated +=
        (basis.svd.singularValues.head(components).asDiagonal() * fit.posteriorFactors[c]).squaredNorm() / (3 * cells);
  }
  for (const float variance : leftOutVariance(basis, int(components), 0, m.cells.size()))
    parts.statedOutside += variance / cells;
  for (std::size_t i = 0; i < m.cells.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const double error = logRelative(truth.values()[m.cells[i]][channel], m.weights[i], m.reference[i]) -
                           logRelative(inSpan->values()[m.cells[i]][channel], m.weights[i], m.reference[i]);
      parts.outside += error * error / (3 * cells);
    }
  return parts;
}

/// The training materials of a calibration, by their numbers: `count` of them, or those with an RGL file of which
/// Mitsuba made no picture.
std::vector<std::size_t> calibrated(const std::filesystem::path& shared, const Training& training, std::size_t count) {
  std::vector<std::size_t> chosen;
  const auto rendered = test::mitsubaMaterials();
  for (std::size_t m = 0; m < training.names.size() && count == 0; ++m)
    if (std::ranges::find(rendered, training.names[m]) == rendered.end() &&
        exists(shared / "data/rgl" / (training.names[m] + "_rgb.bsdf")))
      chosen.push_back(m);
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(i * training.names.size() / count);
  return chosen;
}

int calibration(const std::filesystem::path& shared, std::size_t count, const std::vector<int>& numbersOfImages,
                bool isFlat) {
  constexpr std::size_t folds = 8;
  const Training training = loadTraining();
  const std::vector<std::size_t> chosen = calibrated(shared, training, count);
  std::printf(
      "| material | environment | images | h | model noise | unexplained, dB | squared error inside | stated | outside "
      "| stated | within one deviation | factor for 0.683 | log exposure if unknown (0 is true) | deviation | warnings "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const std::vector<std::string> environments{"studio", "window", "sky", "sunset"};
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const auto basis = basisWithout(
        training, [&](std::size_t m) { return m % folds == fold; }, photograph::defaultPhotographComponents);
    const PhotographPrior prior = photograph::photographPrior(basis);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const std::size_t m = chosen[i];
      if (m % folds != fold) continue;
      const std::string& environment = environments[i % environments.size()];
      const TabulatedBrdf& truth = *training.tables[m];
      std::shared_ptr<const Brdf> file;
      if (count == 0) file = test::mitsubaMaterial(shared, training.names[m]);
      const Brdf& shown = file ? *file : truth;
      for (const int images : numbersOfImages) {
        const auto scene = rendering::sphereScene(rendering::openEnvironment(environment));
        const auto fit = photograph::fitPhotographs(
            prior,
            isFlat ? turnedSample(shown, scene, images)
                   : photographs(shown, scene, images, {.width = 128, .height = 128, .samples = 32, .density = {}}));
        double quantile = 0;
        const double within = coverage(basis, fit, truth, *dictionary::decode(basis, fit.code), quantile);
        const ErrorParts parts = errorParts(basis, fit, truth);
        std::printf(
            "| %s | %s | %d | %.2f | %.4f | %.1f | %.4f | %.4f | %.4f | %.4f | %.3f | %.2f | %.2f | %.2f | %s |\n",
            training.names[m].c_str(), environment.c_str(), images, fit.bandwidth, fit.modelNoise, fit.unexplainedSnr,
            parts.inside, parts.stated, parts.outside, parts.statedOutside, within, quantile * fit.widening,
            fit.checks.front().estimate, fit.checks.front().deviation, warningsOf(fit).c_str());
        std::fflush(stdout);
      }
    }
  }
  return 0;
}

int study(int argumentCount, char** arguments) {
  if (argumentCount < 2) {
    std::fprintf(
        stderr,
        "usage: gonio_studies photographs SHARED [--span | --uncertainty | --wrong | --shapes | --calibration] "
        "[MATERIAL ... | COUNT [IMAGES ...] [--flat]]\n");
    return 2;
  }
  std::vector<std::string> materials(arguments + 2, arguments + argumentCount);
  if (std::erase(materials, "--calibration") > 0) {
    const bool isFlat = std::erase(materials, "--flat") > 0;
    std::vector<int> images;
    for (std::size_t i = 1; i < materials.size(); ++i) images.push_back(std::stoi(materials[i]));
    if (images.empty()) images = {1, 4};
    return calibration(arguments[1], materials.empty() ? 48 : std::size_t(std::stoul(materials.front())), images,
                       isFlat);
  }
  const bool isWrong = std::erase(materials, "--wrong") > 0, isUncertainty = std::erase(materials, "--uncertainty") > 0;
  const bool isOfShapes = std::erase(materials, "--shapes") > 0, isOfSpan = std::erase(materials, "--span") > 0;
  if (materials.empty()) materials = test::mitsubaMaterials();
  if (isOfShapes) return shapes(arguments[1], materials);
  if (isOfSpan) return span(arguments[1], materials);
  return isWrong ? wrongInput(arguments[1], materials) : reconstructions(arguments[1], materials, !isUncertainty);
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::photographs_study
