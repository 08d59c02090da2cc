// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/goniotool/report.h"
#include "core/study/study_plot.h"

/// The results of goniotool study: STEM.json, STEM.csv and STEM.svg in its folder for each material and for the
/// summary, and the report.
namespace gonio::tool {

/// Facts stated in every file of a study.
struct StudyFacts {
  std::string pictures;         ///< study::picturesText()
  study::MachineFacts machine;  ///< if times were not measured, only study::buildFacts()
  /// JSON of everything that determines the results: runs with equal settings belong to the same study.
  std::string settings;

  bool timed() const { return !machine.processor.empty(); }
};

/// What a study uses besides its materials, as part of the settings.
struct StudyInputs {
  std::vector<std::string> dictionaries;  ///< ids
  std::vector<std::string> components;    ///< names of the training materials
  std::vector<std::string> patches;       ///< names of the training materials
  std::string npf;                        ///< materials::NpfTable::sha256; "" without a table
};
/// Facts with settings made from the arguments.
StudyFacts studyFacts(const std::string& pictures, const study::MachineFacts& machine,
                      std::span<const study::Representation> representations, const StudyInputs& inputs);

/// The records of one material.
struct StudiedMaterial {
  std::string stem;    ///< file name without suffix
  std::string name;    ///< name in texts
  std::string source;  ///< SHA-256 of the material
  std::vector<study::StudyRecord> records;
  bool complete = true;  ///< false if a stop left some representations without a record
};

/// Writes the three files with io::writeFilesAtomically(). @throws Error that names the file.
void writeMaterialStudy(const std::filesystem::path& folder, const StudiedMaterial& material, const StudyFacts& facts);
/// Whether STEM.json exists.
bool hasMaterialStudy(const std::filesystem::path& folder, const std::string& stem);
/// The stored results of a material if the settings and the material's hash are equal and all records exist; else
/// nullopt. Ids of representations may be those of older files. @param records the number of records of the material.
std::optional<StudiedMaterial> finishedStudy(const std::filesystem::path& folder, const std::string& stem,
                                             const std::string& source, const StudyFacts& facts, std::size_t records);

/// Collects the results of a study, material by material, for the summary and the final report.
class StudyOutput {
 public:
  StudyOutput(std::string folder, StudyFacts facts, const study::Budget& budget)
      : folder_(std::move(folder)), facts_(std::move(facts)), budget_(budget) {}

  void add(const StudiedMaterial& material);
  /// Writes the files of the medians if there are several materials.
  void writeSummary();
  void print(const Tool& tool, bool complete, double seconds);

 private:
  /// Records the best representation within the limits, if there are limits. Precondition: the material is complete.
  void choose(const StudiedMaterial& material);

  std::string folder_;
  StudyFacts facts_;
  study::Budget budget_;
  std::string text_;
  std::vector<std::vector<study::StudyRecord>> all_;
  Json records_ = Json::array(), chosen_ = Json::array();
};

}  // namespace gonio::tool
