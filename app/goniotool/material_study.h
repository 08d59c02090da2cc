// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/goniotool/study_files.h"
#include "app/goniotool/tool.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/npf_file.h"
#include "core/study/accuracy_study.h"
#include "core/study/pareto.h"

namespace gonio::tool {

/// The arguments of goniotool study; the options of the command explain them.
struct StudyArguments {
  std::vector<std::string> materials, representations, models, baselines, componentsFrom, patchesFrom, dictionaries;
  std::string out, shard, npf;
  study::RepresentationChoice choice;
  study::Budget budget;
  int size = 128, samples = 32;
  bool withoutTimes = false, resume = false;
};

/// The name of a material's files in a study: that of its own file or library entry, without the suffix.
std::string stemOf(const std::string& material);

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
  std::vector<study::Representation> representationsFor(const std::string& name);
  void learnComponents(study::RepresentationChoice& choice);
  void learnPatches();
  std::shared_ptr<const materials::NamedEnsemble> dictionaryFor(const std::string& name) const;

  const StudyArguments& options_;
  const Tool& tool_;
  study::StudyOptions study_;
  std::vector<std::shared_ptr<const materials::NamedEnsemble>> dictionaries_;
  std::optional<materials::NpfTable> npf_;
  StudyInputs inputs_;
  std::vector<study::Representation> representations_;
  StudyFacts facts_;
};

}  // namespace gonio::tool
