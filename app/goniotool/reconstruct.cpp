// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "app/goniotool/usage.h"
#include "core/acquisition/dictionary_reconstruction.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sampling_plan.h"
#include "core/brdf/data_transform.h"
#include "core/materials/dictionary_file.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

/// Name of this method, in addition to reconstructionMethodNames.
constexpr const char* dictionariesMethod = "dictionaries";

std::string assumptionText() { return "assumed: " + std::string(acquisition::assumedOrders) + "\n"; }

struct DictionaryReconstructionRequest {
  std::string plan, values, out;
  std::string dictionary;  ///< a .dictionary file; empty: the bundled one
  std::vector<std::string> train, excluded;
};

/// `goniotool reconstruct --method dictionaries`: learns the prior, reconstructs, writes the material and reports.
int reconstructWithDictionaries(const DictionaryReconstructionRequest& request, const Tool& tool) {
  if (request.train.empty()) throw UsageError("reconstruct: --method dictionaries needs a training set (--train)");
  const acquisition::SamplingPlan plan = acquisition::readPlan(request.plan);
  const acquisition::MeasuredValues values = acquisition::readValues(request.values, plan);
  const auto dictionary =
      request.dictionary.empty() ? materials::bundledEnsemble() : materials::readDictionary(request.dictionary);
  const auto materials =
      study::trainingMaterials(study::trainingFiles(request.train, request.excluded), dictionary->ensemble.grid);
  auto start = std::chrono::steady_clock::now();
  const auto prior = acquisition::learnDictionaryPrior(
      dictionary->ensemble, materials, {},
      tool.control("learning from " + std::to_string(materials.names.size()) + " materials"));
  const double trainingSeconds = secondsSince(start);
  start = std::chrono::steady_clock::now();
  const auto found = acquisition::reconstructInDictionaries(dictionary->ensemble, prior, plan, values, {},
                                                            tool.control("reconstructing"));
  const double seconds = secondsSince(start);
  const WrittenMaterial written = writeMaterial("reconstruction", found.table, request.out, tool);
  const Json json{{"method", dictionariesMethod},
                  {"samples", plan.samples.size()},
                  {"dictionary", found.dictionary},
                  {"noise", found.noise},
                  {"logEvidence", found.logEvidence},
                  {"leaveOneOutError", decibelsJson(found.leaveOneOutError)},
                  {"assumption", acquisition::assumedOrders},
                  {"seconds", seconds},
                  {"trainingSeconds", trainingSeconds},
                  {"written", written.json()},
                  {"out", request.out}};
  print(tool, json,
        request.out + ": from " + std::to_string(plan.samples.size()) + " samples, dictionary " +
            std::to_string(found.dictionary) + " (from 0) of " +
            std::to_string(dictionary->ensemble.dictionaries.size()) + ", " + number(seconds) + " s after " +
            number(trainingSeconds) + " s of learning\n" + assumptionText() + written.text);
  return 0;
}

using namespace acquisition;

struct ReconstructArguments {
  std::string plan, values, out, basis, ridge, method, uncertainty, dictionary,
      materialClass{study::materialClassNames[0]};
  std::vector<std::string> train, excluded;
  ReconstructionOptions reconstruction;
  bool asPublished = false;
};

/// The named method. Options of the ridge regression select it.
std::string_view methodOf(const ReconstructArguments& options) {
  if (!options.method.empty()) return options.method;
  const bool isRidge = options.asPublished || !options.ridge.empty() || options.reconstruction.equalNoise;
  return reconstructionMethodNames[std::size_t(isRidge ? ReconstructionMethod::ridge
                                                       : ReconstructionMethod::localRidge)];
}

/// nullopt: chosen by the program.
std::optional<double> ridgeOf(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const auto ridge = finiteNumber(text);
  if (!ridge || *ridge < 0) throw UsageError("found '" + text + "', expected a number, 0 or more, or auto");
  return ridge;
}

ReconstructionOptions reconstructionOptions(const ReconstructArguments& options) {
  if (options.asPublished) return publishedReconstruction();
  ReconstructionOptions result = options.reconstruction;
  result.method = ReconstructionMethod(std::ranges::find(reconstructionMethodNames, methodOf(options)) -
                                       reconstructionMethodNames.begin());
  result.ridge.reset();
  if (!options.ridge.empty()) result.ridge = ridgeOf(options.ridge);
  if (!options.ridge.empty() && result.method != ReconstructionMethod::ridge)
    throw UsageError("reconstruct: --ridge needs --method ridge");
  result.uncertainty = hasUncertainty(result.method);
  if (result.atoms > 0 && result.method != ReconstructionMethod::sparse)
    throw UsageError("reconstruct: --atoms needs --method sparse");
  if (result.equalNoise && result.method != ReconstructionMethod::ridge)
    throw UsageError("reconstruct: --equal-noise needs --method ridge");
  if (!options.uncertainty.empty() && !result.uncertainty)
    throw UsageError("reconstruct: --uncertainty needs --method ridge or local-ridge");
  return result;
}

/// @throws Error where the plan names another file.
void checkBasis(const std::filesystem::path& basis, const SamplingPlan& plan) {
  if (plan.basisDigest.empty()) return;
  if (const std::string found = basisDigest(basis); found != plan.basisDigest)
    throw Error(basis.string() + ": not the basis of the plan: found the SHA-256 " + found + ".., expected " +
                plan.basisDigest + "..; plan again, or give the basis with --basis");
}

/// Named, else learned, else the one beside the plan.
std::shared_ptr<const materials::BasisFile> basisOf(const ReconstructArguments& options, const SamplingPlan& plan,
                                                    const Tool& tool, double& trainingSeconds) {
  if (!options.basis.empty()) return materials::readBasis(options.basis);
  const std::filesystem::path beside = basisBeside(options.plan);
  if (!options.train.empty()) {
    const int components = options.reconstruction.components;
    const study::LearnedBasis learned =
        basisOfSources(options.train, options.excluded,
                       components > 0 ? components : std::max(study::defaultBasisComponents, int(plan.samples.size())),
                       tool, materials::BasisPrecision::half, options.materialClass);
    trainingSeconds = learned.seconds;
    return learned.basis;
  }
  if (!std::filesystem::exists(beside))
    throw Error(beside.string() +
                ": basis file not found (goniotool plan writes it beside the plan); give another with --basis, or a "
                "training set with --train");
  checkBasis(beside, plan);
  return materials::readBasis(beside);
}

void report(const ReconstructArguments& options, bool equalNoise, const Reconstruction& found, std::size_t samples,
            double seconds, double trainingSeconds, const WrittenMaterial& written, const Tool& tool) {
  Json json{{"method", methodOf(options)},
            {"samples", samples},
            {"components", found.components},
            {"ridge", found.ridge},
            {"equalNoise", equalNoise},
            {"leaveOneOutError", decibelsJson(found.leaveOneOutError)},
            {"cappedValues", found.cappedCount},
            {"assumption", assumedOrders},
            {"seconds", seconds},
            {"written", written.json()},
            {"out", options.out}};
  std::string text = options.out + ": from " + std::to_string(samples) + " samples, " +
                     std::to_string(found.components) + " components, ridge " + number(found.ridge) + ", " +
                     number(seconds) + " s\n";
  if (std::isfinite(found.leaveOneOutError))
    text += "leave-one-out error of a mapped value: " + number(found.leaveOneOutError) + " (root mean square)\n";
  if (!found.standardDeviation.empty()) {
    std::vector<float> deviations = found.standardDeviation;  // which medianOf() reorders
    const double median = medianOf(deviations);
    json["medianDeviation"] = median;
    text += "median uncertainty of a mapped value " + number(median) + "\n";
  }
  if (!found.warnings.empty()) json["warnings"] = found.warnings;
  for (const std::string& warning : found.warnings) text += "warning: " + warning + "\n";
  if (trainingSeconds > 0) json["trainingSeconds"] = trainingSeconds;
  if (!options.uncertainty.empty()) json["uncertainty"] = options.uncertainty;
  print(tool, json, text + assumptionText() + written.text);
}

std::vector<std::string> reconstructionMethods() {
  std::vector<std::string> names(reconstructionMethodNames.begin(), reconstructionMethodNames.end());
  names.emplace_back(dictionariesMethod);
  return names;
}

int reconstruct(const ReconstructArguments& options, const Tool& tool) {
  materials::checkWritableSuffix(options.out);
  if (options.method == dictionariesMethod)
    return reconstructWithDictionaries(
        {options.plan, options.values, options.out, options.dictionary, options.train, options.excluded}, tool);
  if (!options.dictionary.empty()) throw UsageError("reconstruct: --dictionary needs --method dictionaries");
  if (!options.uncertainty.empty()) materials::checkWritableSuffix(options.uncertainty);
  const ReconstructionOptions chosen = reconstructionOptions(options);
  const SamplingPlan plan = acquisition::readPlan(options.plan);
  const MeasuredValues values = acquisition::readValues(options.values, plan);
  double trainingSeconds = 0;
  const auto basis = basisOf(options, plan, tool, trainingSeconds);
  const auto start = std::chrono::steady_clock::now();
  const Reconstruction found =
      acquisition::reconstruct(basis->components, plan, values, chosen, tool.control("reconstructing"));
  const double seconds = secondsSince(start);
  const WrittenMaterial written = writeMaterial("reconstruction", found.table, options.out, tool);
  if (!options.uncertainty.empty())
    writeMaterial(
        "deviation",
        dictionary::tableOfCells(basis->components.mapping, std::vector<glm::vec3>(found.standardDeviation.begin(),
                                                                                   found.standardDeviation.end())),
        options.uncertainty, tool);
  report(options, chosen.equalNoise, found, plan.samples.size(), seconds, trainingSeconds, written, tool);
  return 0;
}

}  // namespace

void addReconstruct(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<ReconstructArguments>();
  ReconstructionOptions& reconstruction = options->reconstruction;
  CLI::App* command = app.add_subcommand(
      "reconstruct", "Reconstructs a whole material from values measured at the directions of a plan");
  command->add_option("--plan", options->plan, "CSV file of the plan")->type_name("FILE")->required();
  command->add_option("--values", options->values, "CSV file of the measured values")->type_name("FILE")->required();
  command->add_option("--out", options->out, outputHelp("Material file to write"))->group(outputGroup)->required();
  CLI::Option* basis =
      command->add_option("--basis", options->basis, "Basis file (the one beside the plan)")->type_name("FILE");
  CLI::Option* train =
      command
          ->add_option("--train", options->train,
                       trainingSetHelp("Training set instead of the basis") + "; required by the method dictionaries")
          ->type_name("FILE|FOLDER");
  train->excludes(basis);
  command->add_option("--exclude", options->excluded, "Names of materials to exclude from the training set")
      ->type_name("NAME")
      ->delimiter(',')
      ->needs(train);
  addClassOption(*command, options->materialClass);
  command->get_option("--class")->needs(train);
  command
      ->add_option(
          "--method", options->method,
          "Method: local-ridge, ridge, sparse or basis-pursuit, over the principal components of the basis; or "
          "dictionaries, over the atoms of --dictionary (needs --train) (local-ridge; ridge with --ridge or "
          "--equal-noise)")
      ->check(CLI::IsMember(reconstructionMethods()));
  command
      ->add_option("--dictionary", options->dictionary,
                   "Dictionary file of the method dictionaries (bundled dictionary)")
      ->type_name("FILE");
  command
      ->add_option("--ridge", options->ridge,
                   "Weight of the regularisation of --method ridge: a number (40 in Tongbuasirilai 2023, eq. 5.14) "
                   "or auto, chosen by leave-one-out (auto)")
      ->type_name("NUMBER|auto")
      ->check(parsedBy(ridgeOf));
  command
      ->add_option("--components", reconstruction.components,
                   "Number of components (all of the basis; with --train as many as samples)")
      ->check(CLI::Range(1, 65535));
  command
      ->add_option("--atoms", reconstruction.atoms,
                   "Max. number of components per channel of the method sparse (chosen by leave-one-out)")
      ->check(CLI::Range(1, 65535));
  command->add_flag("--equal-noise", reconstruction.equalNoise,
                    "Give all samples the same weight even if their noise is known, as in the published method");
  command->add_flag("--as-published", options->asPublished,
                    "Published method: --method ridge --ridge 40 --equal-noise, with as many components as samples");
  command
      ->add_option("--uncertainty", options->uncertainty,
                   outputHelp("File to write: standard deviations of the mapped values as a table"))
      ->group(outputGroup);
  command->callback([options, command, &tool] {
    tool.run = [options, command, &tool] {
      for (const char* of : {"--method", "--ridge", "--components", "--atoms", "--equal-noise"})
        if (options->asPublished && command->count(of) > 0)
          throw UsageError(std::string("reconstruct: --as-published sets ") + of + "; leave out one of them");
      for (const char* of :
           {"--basis", "--ridge", "--components", "--atoms", "--equal-noise", "--uncertainty", "--class"})
        if (options->method == dictionariesMethod && command->count(of) > 0)
          throw UsageError(std::string("reconstruct: ") + of + " cannot be used with --method dictionaries");
      return reconstruct(*options, tool);
    };
  });
}

}  // namespace gonio::tool
