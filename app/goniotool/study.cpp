// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>

#include "app/goniotool/materials.h"
#include "app/goniotool/study_files.h"
#include "app/goniotool/usage.h"
#include "core/materials/npf_file.h"
#include "core/study/accuracy_study.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

using namespace study;

/// The arguments of goniotool study; the options of the command explain them.
struct StudyArguments {
  std::vector<std::string> materials, representations, models, baselines, componentsFrom, patchesFrom, dictionaries;
  std::string out, npf;
  RepresentationChoice choice;
  Budget budget;
  int size = 128, samples = 32;
  bool separate = false, withoutTimes = false, resume = false;
};

/// The name of a material's files in a study: that of its own file or library entry, without the suffix.
std::string stemOf(const std::string& material) { return std::filesystem::path(material).stem().string(); }

RepresentationChoice choiceOf(const StudyArguments& options) {
  RepresentationChoice choice = options.choice;
  if (!options.representations.empty()) choice.names = options.representations;
  if (!options.componentsFrom.empty()) choice.names.emplace_back("components");
  if (options.separate) choice.names.emplace_back("components-separated");
  if (!options.patchesFrom.empty()) choice.names.emplace_back("patches");
  if (!options.npf.empty()) choice.names.emplace_back("published-nonparametric");
  choice.restrict("fits", options.models);
  choice.restrict("baselines", options.baselines);
  return choice;
}

std::string hexText(std::uint64_t id) {
  char text[20];
  return {text, std::size_t(std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(id)))};
}

bool selects(const RepresentationChoice& choice, std::string_view id) {
  return choice.selects(*findRepresentationKind(id));
}

/// Measures the materials of a study one after the other, with all that they share: representations, dictionaries,
/// components, tables. The arguments and the tool must outlive it.
class MaterialStudy {
 public:
  /// Reads and learns what the materials share. @param paths all materials. @throws UsageError or Error that names the
  /// argument or file; Cancelled.
  MaterialStudy(const StudyArguments& options, std::span<const std::string> paths, const Tool& tool);

  const StudyFacts& facts() const { return facts_; }

  /// Measures a material, or reads its results where --resume finds them complete. Writes its files; after a stop only
  /// if they replace none. @throws Error that names the file; Cancelled if nothing was measured before a stop.
  StudiedMaterial result(const std::string& path);

 private:
  void readNpfTable(std::span<const std::string> paths);
  std::vector<Representation> representationsFor(const std::string& name);
  void learnComponents(RepresentationChoice& choice);
  void learnPatches();
  std::shared_ptr<const materials::NamedEnsemble> dictionaryFor(const std::string& name) const;

  const StudyArguments& options_;
  const Tool& tool_;
  StudyOptions study_;
  std::vector<std::shared_ptr<const materials::NamedEnsemble>> dictionaries_;
  std::optional<materials::NpfTable> npf_;
  StudyInputs inputs_;
  std::vector<Representation> representations_;
  StudyFacts facts_;
};

MaterialStudy::MaterialStudy(const StudyArguments& options, std::span<const std::string> paths, const Tool& tool)
    : options_(options), tool_(tool) {
  RepresentationChoice choice = choiceOf(options);
  study_.picture.width = study_.picture.height = options.size;
  study_.picture.samples = options.samples;
  study_.timed = !options.withoutTimes;
  if (!options.npf.empty()) readNpfTable(paths);
  if (selects(choice, "components") || selects(choice, "components-separated")) learnComponents(choice);
  if (selects(choice, "patches")) learnPatches();
  for (const std::string& path : options.dictionaries) {
    dictionaries_.push_back(materials::readDictionary(path));
    inputs_.dictionaries.push_back(hexText(dictionaries_.back()->id));
  }
  representations_ = representationsOf(choice);
  facts_ = studyFacts(picturesText(options.size, options.size, options.samples),
                      options.withoutTimes ? buildFacts() : machineFacts(), representations_, inputs_);
}

StudiedMaterial MaterialStudy::result(const std::string& path) {
  const materials::Material material = documents::openMaterial(path, tool_.control("reading " + path));
  const std::string stem = stemOf(path), source = material.source.sha256;
  const std::vector<Representation> representations = representationsFor(stem);
  if (options_.resume)
    if (auto done = finishedStudy(options_.out, stem, source, facts_, representations.size())) return *std::move(done);
  study_.build.dictionary = dictionaryFor(stem);
  const auto table = material.tabulated(tool_.control("tabulating"));
  StudiedMaterial studied{
      stem, material.name, source,
      runStudy({table, material.brdf}, representations, study_, tool_.control("studying " + material.name))};
  studied.complete = studied.records.size() == representations.size();
  if (studied.records.empty()) tool_.throwIfStopped();
  if (options_.withoutTimes)
    for (StudyRecord& record : studied.records) record.encodeSeconds = std::numeric_limits<double>::quiet_NaN();
  if (studied.complete || !hasMaterialStudy(options_.out, stem)) writeMaterialStudy(options_.out, studied, facts_);
  return studied;
}

/// Before the work, so that a table of other materials does not cost any.
void MaterialStudy::readNpfTable(std::span<const std::string> paths) {
  npf_ = materials::readNpf(options_.npf);
  inputs_.npf = npf_->sha256;
  if (std::ranges::any_of(paths, [&](const std::string& path) { return npf_->find(stemOf(path)) != nullptr; })) return;
  throw Error(options_.npf + ": found rows of " + std::to_string(npf_->materials.size()) +
              " materials, expected one with the name of a material of the study, such as " + stemOf(paths.front()));
}

/// All, or without the published factors if the table has no row of this name.
std::vector<Representation> MaterialStudy::representationsFor(const std::string& name) {
  study_.build.publishedNonparametric.reset();
  if (!npf_) return representations_;
  if (const auto* factors = npf_->find(name)) {
    study_.build.publishedNonparametric = std::make_shared<const factorization::NonparametricFactors>(*factors);
    return representations_;
  }
  std::vector<Representation> others = representations_;
  std::erase(others, Representation{findRepresentationKind("published-nonparametric")});
  return others;
}

void MaterialStudy::learnComponents(RepresentationChoice& choice) {
  if (options_.componentsFrom.empty())
    throw UsageError("study: no principal components are bundled; give a training set with --components-from FOLDER");
  const auto materials = trainingMaterials(trainingFiles(options_.componentsFrom));
  const dictionary::PcaOptions pca{.maxComponents = *std::ranges::max_element(choice.components)};
  study_.build.components =
      std::make_shared<const dictionary::PrincipalComponents>(dictionary::learnPrincipalComponents(
          materials.names.size(), materials.load, pca, tool_.control("learning principal components")));
  std::erase_if(choice.components, [&](int count) { return count > study_.build.components->count(); });
  if (selects(choice, "components-separated"))
    study_.build.separated =
        std::make_shared<const dictionary::SeparatedComponents>(dictionary::learnSeparatedComponents(
            materials.names.size(), materials.load, pca, tool_.control("learning diffuse and specular components")));
  inputs_.components = materials.names;
}

void MaterialStudy::learnPatches() {
  const std::vector<std::string> files = trainingFiles(options_.patchesFrom);
  const auto materials = trainingMaterials(files, trainingGrid(files));
  study_.build.patches = std::make_shared<const dictionary::PatchDictionary>(
      dictionary::learnPatchDictionary(materials, {}, tool_.control("learning a dictionary of patches")));
  inputs_.patches = materials.names;
}

/// Of several the first that has not learned from the material.
std::shared_ptr<const materials::NamedEnsemble> MaterialStudy::dictionaryFor(const std::string& name) const {
  if (dictionaries_.size() < 2) return dictionaries_.empty() ? nullptr : dictionaries_.front();
  for (const auto& dictionary : dictionaries_)
    if (!std::ranges::count(dictionary->ensemble.learnedFrom, name)) return dictionary;
  throw Error(name + ": every dictionary was trained on this material, expected one that was not");
}

/// @throws Error that names the folder.
void makeFolder(const std::string& path) {
  std::error_code cause;
  std::filesystem::create_directories(path, cause);
  if (!std::filesystem::is_directory(path)) throw Error(path + ": the folder cannot be created: " + cause.message());
}

/// Before the work.
void checkArguments(const StudyArguments& options) {
  representationsOf(choiceOf(options));
  if (!options.baselines.empty() && !std::ranges::count(options.representations, "baselines"))
    throw UsageError("study: --baselines needs --representations with baselines");
  if (options.separate && options.componentsFrom.empty())
    throw UsageError("study: --separate needs a training set; give it with --components-from FOLDER");
  if (options.patchesFrom.empty() && std::ranges::count(options.representations, "patches"))
    throw UsageError("study: patches need a training set; give it with --patches-from FOLDER");
  if (options.npf.empty() && std::ranges::count(options.representations, "published-nonparametric"))
    throw UsageError("study: published-nonparametric needs the published table; give it with --npf FILE");
  if (options.withoutTimes && options.budget.frameMilliseconds)
    throw UsageError("study: --max-frame-ms needs times; leave out --no-times");
}

/// The materials, those of folders too. Each has files of its name.
std::vector<std::string> materialsOf(const StudyArguments& options) {
  std::vector<std::string> materials = trainingFiles(options.materials);
  std::set<std::string> names{"summary"};
  for (const std::string& material : materials)
    if (const std::string name = stemOf(material); !names.insert(name).second)
      throw UsageError("study: two results have the same name " + name + " in " + options.out);
  return materials;
}

int study(const StudyArguments& options, const Tool& tool) {
  checkArguments(options);
  const std::vector<std::string> materials = materialsOf(options);
  makeFolder(options.out);
  const auto start = std::chrono::steady_clock::now();
  MaterialStudy studying(options, materials, tool);
  StudyOutput output(options.out, studying.facts(), options.budget);
  bool complete = true;
  try {
    for (std::size_t i = 0; i < materials.size() && complete; ++i) {
      tool.throwIfStopped();
      const StudiedMaterial material = studying.result(materials[i]);
      output.add(material);
      complete = material.complete;
    }
  } catch (const Cancelled&) {
    complete = false;
  }
  output.writeSummary();
  output.print(tool, complete, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return 0;
}

/// "table, fits, ...": the families for which `chosen` holds.
std::string familyList(bool (*chosen)(const RepresentationFamily&)) {
  std::string list;
  for (const RepresentationFamily* family : representationFamilies())
    if (chosen(*family)) list += (list.empty() ? "" : ", ") + std::string(family->id);
  return list;
}

}  // namespace

void addStudy(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", "Measures accuracy and cost of every representation of materials");
  command->add_option("MATERIAL", options->materials, std::string(materialHelp) + ", or a folder of measured files")
      ->required();
  command->add_option("--out", options->out, "Folder for JSON, CSV and SVG files, created if needed")
      ->group(outputGroup)
      ->required();
  command
      ->add_option("--representations", options->representations,
                   "Kinds of representations: " + familyList([](const RepresentationFamily&) { return true; }) +
                       "; or single representations by their ids, such as factors-3d (" +
                       familyList([](const RepresentationFamily& family) { return family.isDefault; }) + ")")
      ->type_name("ID")
      ->delimiter(',');
  command->add_option("--models", options->models, "Models of the fits (all)")->type_name("ID")->delimiter(',');
  command->add_option("--baselines", options->baselines, "Baselines to measure (all)")->type_name("ID")->delimiter(',');
  command
      ->add_option("--terms", options->choice.terms,
                   "Numbers of terms of the factors; the resulting file sizes are the budgets of the baselines "
                   "(1,2,3,5,8,10,14,20)")
      ->delimiter(',')
      ->check(CLI::Range(1, factorization::maxPdvTerms));
  command
      ->add_option(
          "--coefficients", options->choice.coefficients,
          "Coefficients per channel of the sparse codes and of the codes of patches (powers of two from 32 to 2048)")
      ->delimiter(',')
      ->check(CLI::Range(1, maxCodeCoefficients));
  command
      ->add_option("--dictionary", options->dictionaries,
                   "Dictionary file of the codes, repeatable. One file is used for all materials, even those that it "
                   "was trained on. With several files, each material is encoded with the first one that was not "
                   "trained on it (bundled dictionary)")
      ->type_name("FILE")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--components-from", options->componentsFrom,
                   trainingSetHelp("Training set of the principal components") + " (none)")
      ->type_name("FILE|FOLDER")
      ->delimiter(',');
  command
      ->add_option(
          "--patches-from", options->patchesFrom,
          trainingSetHelp("Training set of a dictionary of patches (blocks of cells of the table, K-SVD)") + " (none)")
      ->type_name("FILE|FOLDER")
      ->delimiter(',');
  command->add_flag("--separate", options->separate,
                    "Also measure components of the separated diffuse and specular parts (Sun et al. 2018)");
  command
      ->add_option("--components", options->choice.components,
                   "Numbers of principal components (powers of two from 4 to 128)")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--npf", options->npf,
                   "Table of published non-parametric factors (npf.bin of Bagher et al. 2016); also measure the "
                   "published factors of each material that has a row with its name (none)")
      ->type_name("FILE");
  command->add_option("--size", options->size, "Size of the images, pixels (128)")->check(CLI::Range(1, 8192));
  command->add_option("--samples", options->samples, "Samples per pixel (32)")->check(CLI::Range(1, 1 << 20));
  command->add_flag("--no-times", options->withoutTimes, "Omit times, so that every run writes identical files");
  command->add_flag("--resume", options->resume, "Reuse results in the folder that belong to the same study");
  command->add_option("--max-frame-ms", options->budget.frameMilliseconds,
                      "Limit for the best representation: max. frame time, ms");
  command->add_option("--min-snr", options->budget.renderedSnr,
                      "Limit for the best representation: min. rendered SNR, dB");
  command->add_option("--max-bytes", options->budget.bytes, "Limit for the best representation: max. size, bytes");
  command->callback([options, &tool] {
    tool.keepsPartialResults = true;
    tool.run = [options, &tool] { return study(*options, tool); };
  });
}

}  // namespace gonio::tool
