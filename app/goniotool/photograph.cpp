// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/brdf/data_transform.h"
#include "core/io/atomic_file.h"
#include "core/io/byte_source.h"
#include "core/io/image_io.h"
#include "core/photograph/photograph_candidates.h"
#include "core/photograph/photograph_fit.h"
#include "core/photograph/photograph_plan.h"
#include "core/rendering/render_picture.h"
#include "core/study/training_files.h"
#include "core/support/text.h"

namespace gonio::tool {

namespace {

/// The principal components that a command uses: of a file, or of a training set.
struct PhotographBasis {
  std::string file;
  std::vector<std::string> train, excluded;
  int components = photograph::defaultPhotographComponents;
};

/// @param trainingSeconds receives the time of training; 0 if the basis was kept.
std::shared_ptr<const materials::BasisFile> openBasis(const PhotographBasis& options, const Tool& tool,
                                                      double& trainingSeconds) {
  trainingSeconds = 0;
  if (!options.file.empty()) return materials::readBasis(options.file);
  const study::LearnedBasis learned = basisOfSources(options.train, options.excluded, study::defaultBasisComponents,
                                                     tool, materials::BasisPrecision::half);
  trainingSeconds = learned.seconds;
  return learned.basis;
}

void addBasisOptions(CLI::App& command, PhotographBasis& options) {
  CLI::Option* basis = command.add_option("--basis", options.file, "Basis file of the training set")->type_name("FILE");
  CLI::Option* train =
      command
          .add_option("--train", options.train,
                      trainingSetHelp("Training set (the measured and near-measured bundled materials)"))
          ->type_name("FILE|FOLDER");
  train->excludes(basis);
  command.add_option("--exclude", options.excluded, "Names of materials to exclude from the training set")
      ->type_name("NAME")
      ->delimiter(',')
      ->excludes(basis);
  command.add_option("--components", options.components, "Max. number of components (64)")->check(CLI::Range(1, 512));
}

struct PhotographFitArguments {
  std::string description, out, uncertainty;
  PhotographBasis basis;
  std::size_t regions = photograph::defaultRegions;
};

Json checksJson(const std::vector<photograph::InputCheck>& checks) {
  Json json = Json::array();
  for (const photograph::InputCheck& check : checks) {
    const double unit = check.property == "rotation" ? degrees(1) : 1;
    json.push_back({{"property", check.property},
                    {"estimate", unit * check.estimate},
                    {"deviation", unit * check.deviation},
                    {"evidence", check.evidence},
                    {"snr", check.unexplainedSnr},
                    {"suspicious", check.isSuspicious}});
  }
  return json;
}

int fitPhotograph(const PhotographFitArguments& options, const Tool& tool) {
  materials::checkWritableSuffix(options.out);
  if (!options.uncertainty.empty()) materials::checkWritableSuffix(options.uncertainty);
  const auto description = photograph::readDescription(options.description);
  double trainingSeconds = 0;
  const auto basis = openBasis(options.basis, tool, trainingSeconds);
  const auto start = std::chrono::steady_clock::now();
  const auto prior = photograph::photographPrior(basis->components, options.basis.components);
  const auto found =
      photograph::fitPhotographs(prior, description.set, options.regions, tool.control("reconstructing"));
  const auto table = dictionary::decode(basis->components, found.code);
  const double seconds = secondsSince(start);
  const std::vector<glm::vec3> deviations =
      photograph::deviations(basis->components, found, tool.control("uncertainty"));
  std::vector<float> each;
  for (const glm::vec3& of : deviations)
    for (int channel = 0; channel < 3; ++channel) each.push_back(of[channel]);
  const double median = medianOf(each);
  const WrittenMaterial written = writeMaterial("photograph", table, options.out, tool);
  if (!options.uncertainty.empty())
    writeMaterial("deviation", dictionary::tableOfCells(basis->components.mapping, deviations), options.uncertainty,
                  tool);

  Json json{{"images", Json::array()},
            {"regions", found.regions.size()},
            {"exposure", found.exposure},
            {"exposureDeviation", found.exposureDeviation},
            {"greyExposure", rgbJson(description.set.exposure)},
            {"bandwidth", decibelsJson(found.bandwidth)},
            {"modelNoise", found.modelNoise},
            {"medianDeviation", median},
            {"lostLight", found.lost},
            {"checks", checksJson(found.checks)},
            {"warnings", found.warnings},
            {"assumption", "reciprocal, isotropic, a convex surface without interreflection"},
            {"seconds", seconds},
            {"written", written.json()},
            {"out", options.out}};
  if (trainingSeconds > 0) json["trainingSeconds"] = trainingSeconds;
  if (!options.uncertainty.empty()) json["uncertainty"] = options.uncertainty;
  const std::size_t images = description.set.photographs.size();
  std::string text = options.out + ": from " + std::to_string(images) + (images == 1 ? " image, " : " images, ") +
                     number(seconds) + " s\n";
  for (std::size_t i = 0; i < description.set.photographs.size(); ++i) {
    const photograph::Photograph& image = description.set.photographs[i];
    Json entry{{"file", image.name},
               {"shape", photograph::surfaceName(image.surface)},
               {"clip", decibelsJson(image.clip)},
               {"residualSnr", decibelsJson(found.residualSnr[i])}};
    text += image.name + ": " + std::string(photograph::surfaceName(image.surface));
    if (photograph::isSphere(image.surface)) {
      entry["sphere"] = {{"x", image.disc.x}, {"y", image.disc.y}, {"radius", image.disc.radius}};
      text += " at " + number(image.disc.x) + ", " + number(image.disc.y) + ", radius " + number(image.disc.radius) +
              " pixels";
    }
    json["images"].push_back(std::move(entry));
    text += "; residual " + number(found.residualSnr[i]) + " dB\n";
  }
  if (description.set.exposure != Rgb(1)) text += "exposure by grey patch: " + rgbText(description.set.exposure) + "\n";
  if (!description.set.exposureKnown)
    text += "exposure: factor " + number(found.exposure) + ", " +
            number(found.exposure * std::exp(-found.exposureDeviation)) + " to " +
            number(found.exposure * std::exp(found.exposureDeviation)) + " within one standard deviation\n";
  text += "median uncertainty of a mapped value " + number(median) + "\n";
  for (const std::string& warning : found.warnings) text += "warning: " + warning + "\n";
  print(tool, json, text + written.text);
  return 0;
}

struct PhotographPlanArguments {
  std::string description, out;
  PhotographBasis basis;
  photograph::CandidateCounts counts;
  photograph::PlanOptions plan;
};

Json deviationJson(const photograph::ExpectedDeviation& of, Json json = Json::object()) {
  json["deviation"] = of.overall;
  for (std::size_t c = 0; c < of.classes.size(); ++c)
    json[std::string(study::materialClassNames[c + 1])] = decibelsJson(of.classes[c]);
  return json;
}

std::string deviationText(const std::string& image, const photograph::ExpectedDeviation& of) {
  std::string line = image.substr(0, 30);
  const auto add = [&](double value, std::size_t column) {
    line.resize(std::max(line.size() + 1, column), ' ');
    line += std::isfinite(value) ? shortText(value, 3) : "-";
  };
  add(of.overall, 32);
  for (std::size_t c = 0; c < of.classes.size(); ++c) add(of.classes[c], 44 + 12 * c);
  return line + "\n";
}

int planPhotograph(const PhotographPlanArguments& options, const Tool& tool) {
  const std::filesystem::path path(options.description);
  if (!options.out.empty() && std::filesystem::path(options.out).parent_path() != path.parent_path())
    throw UsageError("--out: found '" + options.out + "', expected a file in the folder of " + options.description +
                     ", to which its paths are relative");
  std::string text;
  const auto description = withFileInErrors(path, [&] {
    const auto bytes = io::FileSource(path).readAll(photograph::maxDescriptionBytes);
    text = photograph::withCandidates({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, options.counts);
    return photograph::parseDescription(text, path.parent_path(), false);
  });
  if (description.candidates.empty())
    throw UsageError(
        "photograph plan: found no candidates, expected --rotations, --lights, --cameras, or "
        "\"candidates\" in " +
        options.description);
  double trainingSeconds = 0;
  const auto basis = openBasis(options.basis, tool, trainingSeconds);
  const auto start = std::chrono::steady_clock::now();
  const auto prior = photograph::photographPrior(basis->components, options.basis.components);
  const std::vector<std::size_t> classes = study::photographClasses(prior);
  const photograph::PhotographPlan plan =
      photograph::planPhotographs(prior, description.set, description.candidates, classes, study::photographClassCount,
                                  options.plan, tool.control("planning"));
  const double seconds = secondsSince(start);
  if (!options.out.empty())
    io::writeFileAtomically(options.out, photograph::withChosenCandidates(text, plan.chosen) + "\n");

  Json json{{"before", deviationJson(plan.before)}, {"images", Json::array()}, {"candidates", Json::array()}};
  std::string lines = "image                           deviation   diffuse     glossy\n" +
                      deviationText("none (training set)", plan.before);
  const auto add = [&](const std::string& name, bool chosen, const photograph::ExpectedDeviation& of) {
    json["images"].push_back(deviationJson(of, {{"file", name}, {"chosen", chosen}}));
    lines += deviationText((chosen ? "+ " : "") + name, of);
  };
  for (std::size_t i = 0; i < plan.taken.size(); ++i) add(description.set.photographs[i].name, false, plan.taken[i]);
  for (std::size_t i = 0; i < plan.chosen.size(); ++i)
    add(description.candidates[plan.chosen[i]].name, true, plan.after[i]);
  lines += "each candidate as the next image:\n";
  for (std::size_t i = 0; i < plan.candidates.size(); ++i) {
    json["candidates"].push_back(deviationJson(plan.candidates[i], {{"file", description.candidates[i].name}}));
    lines += deviationText(description.candidates[i].name, plan.candidates[i]);
  }
  json["materials"] = plan.materials.size();
  json["modelNoise"] = options.plan.modelNoise;
  json["seconds"] = seconds;
  if (trainingSeconds > 0) json["trainingSeconds"] = trainingSeconds;
  if (!options.out.empty()) json["out"] = options.out;
  print(tool, json, lines);
  return 0;
}

struct SimulateArguments {
  std::string description, material;
  int samples = 64;
  double noise = 0;
  std::uint64_t seed = 1;
};

/// Renders the images of a description, with Gaussian noise of a fraction of each value.
int simulatePhotographs(const SimulateArguments& options, const Tool& tool) {
  const auto description = photograph::readDescription(options.description, false);
  const materials::Material material = openMaterial(options.material, tool.control("reading"));
  const auto start = std::chrono::steady_clock::now();
  Json files = Json::array();
  std::string text;
  for (std::size_t i = 0; i < description.files.size(); ++i) {
    const std::filesystem::path& file = description.files[i];
    if (std::filesystem::exists(file) && !tool.force)
      throw Error(file.string() + ": the image exists; use --force to replace it");
    const glm::ivec2 size = description.set.photographs[i].size;
    const rendering::RenderOptions render{
        .width = size.x, .height = size.y, .samples = options.samples, .seed = options.seed + i, .density = {}};
    Image image = rendering::renderPicture(*material.brdf, sceneOf(description.set.photographs[i], size.x, size.y),
                                           render, tool.control("rendering"));
    std::mt19937_64 random(options.seed + i);
    std::normal_distribution<double> normal;
    if (options.noise > 0)
      for (glm::vec3& pixel : image.pixels)
        for (int channel = 0; channel < 3; ++channel)
          pixel[channel] = float(std::max(0.0, pixel[channel] * (1 + options.noise * normal(random))));
    io::writeExr(image, file);
    files.push_back(file.string());
    text += file.string() + ": " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels\n";
  }
  print(tool, {{"files", files}, {"seconds", secondsSince(start)}}, text);
  return 0;
}

void addPhotographFit(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<PhotographFitArguments>();
  CLI::App* command =
      app.add_subcommand("fit", "Reconstructs a material from photographs of a sphere, a cylinder or a flat sample");
  command->add_option("DESCRIPTION", options->description, "JSON file that describes the photographs")->required();
  command->add_option("--out", options->out, outputHelp("Material file to write"))->group(outputGroup)->required();
  addBasisOptions(*command, options->basis);
  command->add_option("--regions", options->regions, "Max. number of regions of pixels, of all images (600)")
      ->check(CLI::Range(50, 20000));
  command
      ->add_option("--uncertainty", options->uncertainty,
                   outputHelp("File to write: standard deviations of the mapped values as a table"))
      ->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return fitPhotograph(*options, tool); }; });
}

void addPhotographPlan(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<PhotographPlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Chooses the next images: those that reduce the uncertainty most");
  command->add_option("DESCRIPTION", options->description, "JSON file that describes the photographs")->required();
  command->add_option("--images", options->plan.images, "Number of images to choose (1)")->check(CLI::Range(1, 64));
  command
      ->add_option("--rotations", options->counts.rotations,
                   "Candidates: this number of rotations of the first image's environment (0)")
      ->check(CLI::Range(0, 64));
  command
      ->add_option("--lights", options->counts.lights,
                   "Candidates: this number of directions of the first image's light, up to 120 degrees from the "
                   "camera (0)")
      ->check(CLI::Range(0, 64));
  command
      ->add_option("--cameras", options->counts.cameras,
                   "Candidates: this number of positions of the first image's camera about the vertical axis (0)")
      ->check(CLI::Range(0, 64));
  command
      ->add_option("--model-noise", options->plan.modelNoise,
                   "Standard deviation of pixel values that the model does not explain, as a fraction (0.08)")
      ->check(CLI::Range(0.001, 1.0));
  command
      ->add_option("--materials", options->plan.materials,
                   "Max. number of training materials for which the images are compared (24)")
      ->check(CLI::Range(1, 1000));
  addBasisOptions(*command, options->basis);
  command
      ->add_option("--out", options->out,
                   "Description to write: the images and the chosen ones; in the folder of DESCRIPTION")
      ->type_name("FILE")
      ->group(outputGroup);
  command->callback([options, &tool] { tool.run = [options, &tool] { return planPhotograph(*options, tool); }; });
}

void addPhotographSimulate(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Renders the images of a description from a material");
  command->add_option("DESCRIPTION", options->description, "JSON file that describes the photographs")->required();
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--samples", options->samples, "Samples per pixel (64)")->check(CLI::Range(1, 1048576));
  command->add_option("--noise", options->noise, "Standard deviation of each pixel, as a fraction of its value (0)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--seed", options->seed, "Seed of the random numbers (1)");
  command->callback([options, &tool] { tool.run = [options, &tool] { return simulatePhotographs(*options, tool); }; });
}

}  // namespace

void addPhotograph(CLI::App& app, Tool& tool) {
  CLI::App* command = app.add_subcommand(
      "photograph", "Reconstructs materials from photographs of a sphere, a cylinder or a flat sample");
  command->require_subcommand(1);
  addPhotographFit(*command, tool);
  addPhotographPlan(*command, tool);
  addPhotographSimulate(*command, tool);
}

}  // namespace gonio::tool
