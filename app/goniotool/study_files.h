// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/goniotool/report.h"
#include "core/study/machine.h"
#include "core/study/study_record.h"

/// The files in the folder of a study: for each material and the summary STEM.json, STEM.csv and STEM.svg; for a shard
/// one file more.
namespace gonio::tool {

/// What every file of a study states.
struct StudyFacts {
  std::string pictures;         ///< study::picturesText()
  study::MachineFacts machine;  ///< without measured times of the program alone (study::buildFacts())
  std::string settings;         ///< JSON: two studies with equal settings measure the same

  bool timed() const { return !machine.processor.empty(); }
};

/// What is learned from other materials, for the settings: ids of dictionaries, names of the training set.
struct StudyTraining {
  std::vector<std::string> dictionaries, components;
};
/// The settings are those of the other arguments.
StudyFacts studyFacts(const std::string& pictures, const study::MachineFacts& machine,
                      std::span<const study::Representation> representations, const StudyTraining& training);

/// The records of one material.
struct StudiedMaterial {
  std::string stem;    ///< of its files
  std::string name;    ///< for people
  std::string source;  ///< SHA-256 of the material
  std::vector<study::StudyRecord> records;
};

/// All three files or none. @throws Error naming the file.
void writeMaterialStudy(const std::filesystem::path& folder, const StudiedMaterial& material, const StudyFacts& facts);
/// The same of medians. `records` are theirs as JSON.
void writeSummary(const std::filesystem::path& folder, const std::string& title,
                  std::span<const study::StudyRecord> medians, const Json& records, const StudyFacts& facts);

/// With its members in the order of the file. @throws Error that names no file, also for JSON that is nested too
/// deeply.
Json readOrderedJson(const std::filesystem::path& path);

/// What writeMaterialStudy() wrote. @throws Error naming the file.
struct ReadStudy {
  StudiedMaterial material;
  StudyFacts facts;
};
ReadStudy readMaterialStudy(const std::filesystem::path& folder, const std::string& stem);
/// The same where it has equal settings, is of the same material, and has all records; else nothing.
std::optional<StudiedMaterial> finishedStudy(const std::filesystem::path& folder, const std::string& stem,
                                             const std::string& source, const StudyFacts& facts);

}  // namespace gonio::tool
