// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/material_study.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "app/goniotool/materials.h"
#include "core/models/registry.h"
#include "core/study/study_csv.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

using namespace study;

RepresentationChoice choiceOf(const StudyArguments& options) {
  RepresentationChoice choice = options.choice;
  if (!options.representations.empty()) {
    choice.families.clear();
    for (const std::string& id : options.representations) choice.families.push_back(familyById(id));
  }
  if (!options.componentsFrom.empty() && !std::ranges::count(choice.families, RepresentationFamily::components))
    choice.families.push_back(RepresentationFamily::components);
  if (!options.patchesFrom.empty() && !std::ranges::count(choice.families, RepresentationFamily::patches))
    choice.families.push_back(RepresentationFamily::patches);
  if (!options.npf.empty() && !std::ranges::count(choice.families, RepresentationFamily::publishedNonparametric))
    choice.families.push_back(RepresentationFamily::publishedNonparametric);
  for (const std::string& id : options.models) choice.models.push_back(&models::findModel(id));
  for (const std::string& id : options.baselines) choice.baselines.push_back(&findStudiedBaseline(id));
  return choice;
}

std::string hexText(std::uint64_t id) {
  char text[20];
  return {text, std::size_t(std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(id)))};
}

void eraseTimes(std::vector<StudyRecord>& records) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (StudyRecord& record : records) {
    record.encodeSeconds = record.frameMilliseconds = none;
    record.evaluation = {none, none, none};
  }
}

}  // namespace

std::string stemOf(const std::string& material) { return std::filesystem::path(material).stem().string(); }

MaterialStudy::MaterialStudy(const StudyArguments& options, std::span<const std::string> paths, const Tool& tool)
    : options_(options), tool_(tool) {
  RepresentationChoice choice = choiceOf(options);
  study_.picture.width = study_.picture.height = options.size;
  study_.picture.samples = options.samples;
  study_.timed = !options.withoutTimes;
  if (!options.npf.empty()) readNpfTable(paths);
  if (std::ranges::count(choice.families, RepresentationFamily::components)) learnComponents(choice);
  if (std::ranges::count(choice.families, RepresentationFamily::patches)) learnPatches();
  for (const std::string& path : options.dictionaries) {
    dictionaries_.push_back(materials::readDictionary(path));
    inputs_.dictionaries.push_back(hexText(dictionaries_.back()->id));
  }
  representations_ = representationsOf(choice);
  facts_ = studyFacts(picturesText(options.size, options.size, options.samples),
                      options.withoutTimes ? buildFacts() : machineFacts(), representations_, inputs_);
}

StudiedMaterial MaterialStudy::result(const std::string& path) {
  const materials::Material material = openMaterial(path, tool_.control("reading " + path));
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
  if (options_.withoutTimes) eraseTimes(studied.records);
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
  std::erase_if(others,
                [](const Representation& one) { return one.family == RepresentationFamily::publishedNonparametric; });
  return others;
}

void MaterialStudy::learnComponents(RepresentationChoice& choice) {
  if (options_.componentsFrom.empty())
    throw UsageError("study: no principal components are bundled; give a training set with --components-from FOLDER");
  const auto materials = study::trainingMaterials(study::trainingFiles(options_.componentsFrom));
  const dictionary::PcaOptions pca{.maxComponents = *std::ranges::max_element(choice.components)};
  study_.build.components =
      std::make_shared<const dictionary::PrincipalComponents>(dictionary::learnPrincipalComponents(
          materials.names.size(), materials.load, pca, tool_.control("learning principal components")));
  std::erase_if(choice.components, [&](int count) { return count > study_.build.components->count(); });
  if (choice.separatedComponents)
    study_.build.separated =
        std::make_shared<const dictionary::SeparatedComponents>(dictionary::learnSeparatedComponents(
            materials.names.size(), materials.load, pca, tool_.control("learning diffuse and specular components")));
  inputs_.components = materials.names;
}

void MaterialStudy::learnPatches() {
  const std::vector<std::string> files = study::trainingFiles(options_.patchesFrom);
  const auto materials = study::trainingMaterials(files, study::trainingGrid(files));
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

}  // namespace gonio::tool
