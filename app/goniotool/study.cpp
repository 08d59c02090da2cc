// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>
#include <filesystem>
#include <set>

#include "app/goniotool/interrupt.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/study_report.h"
#include "core/documents/training_files.h"
#include "core/models/registry.h"
#include "core/study/accuracy_study.h"
#include "core/study/pareto.h"
#include "core/study/study_axis.h"
#include "core/study/study_csv.h"

namespace gonio::tool {

namespace {

namespace fs = std::filesystem;
using namespace study;

struct StudyArguments {
  std::vector<std::string> materials, representations, models, componentsFrom;
  std::string out, dictionary;
  RepresentationChoice choice;
  Budget budget;
  int size = 128, samples = 32;
};

/// One material with its records.
struct Studied {
  std::string name;
  std::vector<StudyRecord> records;
};

RepresentationChoice choiceOf(const StudyArguments& options) {
  RepresentationChoice choice = options.choice;
  if (!options.representations.empty()) {
    choice.families.clear();
    for (const std::string& id : options.representations) choice.families.push_back(familyById(id));
  }
  if (!options.componentsFrom.empty() && !std::ranges::count(choice.families, RepresentationFamily::components))
    choice.families.push_back(RepresentationFamily::components);
  for (const std::string& id : options.models) choice.models.push_back(&models::findModel(id));
  return choice;
}

StudyOptions studyOptions(const StudyArguments& options, RepresentationChoice& choice, const TaskControl& control) {
  StudyOptions study;
  study.picture.width = study.picture.height = options.size;
  study.picture.samples = options.samples;
  if (!options.dictionary.empty()) study.build.dictionary = materials::readDictionary(options.dictionary);
  if (!std::ranges::count(choice.families, RepresentationFamily::components)) return study;
  if (options.componentsFrom.empty())
    throw UsageError("study: no basis of principal components is shipped; give --components-from FOLDER");
  const auto materials = editing::trainingMaterials(editing::trainingFiles(options.componentsFrom));
  const dictionary::PcaOptions pca{.maxComponents = *std::ranges::max_element(choice.components)};
  study.build.components = std::make_shared<const dictionary::PrincipalComponents>(
      dictionary::learnPrincipalComponents(materials.names.size(), materials.load, pca, control));
  std::erase_if(choice.components, [&](int count) { return count > study.build.components->count(); });
  return study;
}

void checkOptions(const StudyArguments& options) {
  for (const std::string& id : options.representations) familyById(id);
  std::set<std::string> names{"summary"};
  for (const std::string& material : options.materials)
    if (const std::string name = fs::path(material).stem().string(); !names.insert(name).second)
      throw UsageError("study: two results have the same name " + name + " in " + options.out);
}

Studied studyOne(const std::string& path, std::span<const Representation> representations, const StudyOptions& study,
                 const Tool& tool, const std::stop_token& stop) {
  const materials::Material material = openMaterial(path, tool.control("reading " + path));
  const auto table = material.tabulated(tool.control("tabulating"));
  TaskControl control = tool.control("studying " + material.name);
  control.stop = stop;
  return {material.name, runStudy({table, material.brdf}, representations, study, control)};
}

/// What is reported at the end, gathered material by material.
class StudyOutput {
 public:
  StudyOutput(const StudyArguments& options, std::string pictures)
      : options_(options), pictures_(std::move(pictures)) {}

  void add(const std::string& path, const Studied& studied) {
    const Json records = recordsJson(studied.records);
    write(fs::path(path).stem(), studied.name, studied.records, records);
    for (const Json& record : records) {
      records_.push_back({{"material", studied.name}});
      records_.back().update(record);
    }
    text_ += studied.name + "\n" + recordsText(studied.records);
    choose(studied);
    all_.push_back(studied.records);
  }

  void end(const Tool& tool, bool complete, double seconds) {
    const std::vector<StudySummary> summary = summarise(all_);
    const Json summaryRecords = summaryJson(summary);
    if (all_.size() > 1) {
      std::vector<StudyRecord> medians;
      medians.reserve(summary.size());
      for (const StudySummary& one : summary) medians.push_back(one.median);
      const std::string title = "median of " + std::to_string(all_.size()) + " materials";
      write("summary", title, medians, summaryRecords);
      text_ += title + "\n" + recordsText(medians);
    }
    Json json{{"records", records_}, {"summary", summaryRecords}};
    if (!chosen_.empty()) json["chosen"] = chosen_;
    json.update({{"complete", complete},
                 {"pictures", pictures_},
                 {"machine", machineJson(machine_)},
                 {"seconds", seconds},
                 {"out", options_.out}});
    for (const std::string& line : machineLines(machine_)) text_ += line + "\n";
    print(tool, json, text_);
  }

 private:
  void write(const fs::path& stem, const std::string& title, std::span<const StudyRecord> records,
             const Json& recordsAsJson) const {
    writeStudy(fs::path(options_.out) / stem, {title, pictures_, machine_}, records, recordsAsJson);
  }

  /// The best within the limits, where there are some.
  void choose(const Studied& studied) {
    const Budget& budget = options_.budget;
    if (!budget.frameMilliseconds && !budget.renderedSnr && !budget.bytes) return;
    const auto best = bestWithin(studied.records, budget);
    const Representation* representation = best ? &studied.records[*best].representation : nullptr;
    Json chosen(nullptr);
    if (representation) chosen = {{"representation", representation->id}, {"budget", representation->budget}};
    chosen_.push_back({{"material", studied.name}, {"best", chosen}});
    text_ += representation ? "best within the limits: " + representation->fullLabel() + "\n"
                            : "no representation meets the limits\n";
  }

  const StudyArguments& options_;
  std::string pictures_, text_;
  MachineFacts machine_ = machineFacts();
  std::vector<std::vector<StudyRecord>> all_;
  Json records_ = Json::array(), chosen_ = Json::array();
};

void makeFolder(const std::string& path) {
  std::error_code cause;
  fs::create_directories(path, cause);
  if (!fs::is_directory(path)) throw Error(path + ": the folder cannot be created: " + cause.message());
}

int study(const StudyArguments& options, const Tool& tool) {
  using Clock = std::chrono::steady_clock;
  checkOptions(options);
  makeFolder(options.out);
  const auto start = Clock::now();
  RepresentationChoice choice = choiceOf(options);
  const StudyOptions studying = studyOptions(options, choice, tool.control("learning principal components"));
  const std::vector<Representation> representations = representationsOf(choice);
  StudyOutput output(options, picturesText(options.size, options.size, options.samples));
  const StopOnInterrupt interrupt;
  for (const std::string& path : options.materials)
    if (!interrupt.token().stop_requested())
      output.add(path, studyOne(path, representations, studying, tool, interrupt.token()));
  output.end(tool, !interrupt.token().stop_requested(), std::chrono::duration<double>(Clock::now() - start).count());
  return 0;
}

}  // namespace

void addStudy(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", "Measures accuracy and cost of every representation of materials");
  command->add_option("MATERIAL", options->materials, materialHelp)->required();
  command->add_option("--out", options->out, "Folder for JSON, CSV and SVG files, created if needed")->required();
  command
      ->add_option(
          "--representations", options->representations,
          "Kinds of representations: table, fits, factors, codes, components, nonparametric (all but components)")
      ->delimiter(',');
  command->add_option("--models", options->models, "Models of the fits (all)")->delimiter(',');
  command->add_option("--terms", options->choice.terms, "Numbers of terms of the factors (1,2,3,5,8,10,14,20)")
      ->delimiter(',')
      ->check(CLI::Range(1, factorization::maxPdvTerms));
  command
      ->add_option("--coefficients", options->choice.coefficients,
                   "Coefficients per channel of the codes (32,64,..,2048)")
      ->delimiter(',')
      ->check(CLI::Range(1, maxCodeCoefficients));
  command->add_option("--dictionary", options->dictionary, "Dictionary file of the codes (bundled dictionary)");
  command
      ->add_option("--components-from", options->componentsFrom,
                   "Training set of principal components, files or folders (none)")
      ->delimiter(',');
  command->add_option("--components", options->choice.components, "Numbers of principal components (4,8,..,128)")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  command->add_option("--size", options->size, "Size of the pictures, pixels (128)")->check(CLI::Range(1, 8192));
  command->add_option("--samples", options->samples, "Samples per pixel (32)")->check(CLI::Range(1, 1 << 20));
  command->add_option("--max-frame-ms", options->budget.frameMilliseconds,
                      "Max. frame time of the best representation, ms");
  command->add_option("--min-snr", options->budget.renderedSnr, "Min. rendered SNR of the best representation, dB");
  command->add_option("--max-bytes", options->budget.bytes, "Max. size of the best representation, bytes");
  command->callback([options, &tool] { tool.run = [options, &tool] { return study(*options, tool); }; });
}

}  // namespace gonio::tool
