// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>
#include <set>

#include "app/goniotool/material_study.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/study_output.h"
#include "app/goniotool/study_shards.h"
#include "app/goniotool/usage.h"
#include "core/models/registry.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

using namespace study;

/// Before the work.
void checkArguments(const StudyArguments& options) {
  for (const std::string& id : options.representations) familyById(id);
  if (!options.baselines.empty() && !std::ranges::count(options.representations, "baselines"))
    throw UsageError("study: --baselines needs --representations with baselines");
  if (options.choice.separatedComponents && options.componentsFrom.empty())
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
  std::vector<std::string> materials = study::trainingFiles(options.materials);
  std::set<std::string> names{"summary"};
  if (!options.shard.empty()) names.insert(shardStem);
  for (const std::string& material : materials)
    if (const std::string name = stemOf(material); !names.insert(name).second)
      throw UsageError("study: two results have the same name " + name + " in " + options.out);
  return materials;
}

int study(const StudyArguments& options, const Tool& tool) {
  using Clock = std::chrono::steady_clock;
  checkArguments(options);
  const std::vector<std::string> materials = materialsOf(options);
  const Shard shard = options.shard.empty() ? Shard{} : parseShard(options.shard);
  makeFolder(options.out);
  const auto start = Clock::now();
  MaterialStudy studying(options, materials, tool);
  StudyOutput output(options.out, studying.facts(), options.budget);
  if (!options.shard.empty()) removeShard(options.out);
  bool complete = true;
  try {
    for (std::size_t i = 0; i < materials.size() && complete; ++i) {
      if (!shard.contains(i)) continue;
      tool.throwIfStopped();
      const StudiedMaterial material = studying.result(materials[i]);
      output.add(material);
      complete = material.complete;
    }
  } catch (const Cancelled&) {
    complete = false;
  }
  Json further = Json::object();
  if (options.shard.empty()) {
    output.writeSummary();
  } else {
    further = {{"shard", shard.number}, {"shards", shard.count}};
    std::vector<std::string> stems;
    std::ranges::transform(materials, std::back_inserter(stems), stemOf);
    if (complete) writeShard(options.out, shard, stems, studying.facts());
  }
  output.print(tool, complete, std::chrono::duration<double>(Clock::now() - start).count(), further);
  return 0;
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
                   "Kinds of representations: table, fits, factors, codes, components, patches, nonparametric, "
                   "published-nonparametric, baselines, published, alternatives, neural (table, fits, factors, "
                   "codes and nonparametric)")
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
  command->add_flag("--separate", options->choice.separatedComponents,
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
  command
      ->add_option("--shard", options->shard,
                   "I/N: measure only every Nth material, starting with the Ith; goniotool merge merges the shards")
      ->type_name("I/N")
      ->check(parsedBy(parseShard));
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
