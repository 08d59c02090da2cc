// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/goniotool/study_files.h"

/// Division of a study's materials among several runs.
namespace gonio::tool {

/// Shard `number` of `count`, counted from 1. Material i of the study, counted from 0, belongs to shard i mod `count` +
/// 1, so that the materials of each collection, which follow one another, are distributed evenly.
struct Shard {
  std::size_t number = 1, count = 1;

  bool contains(std::size_t material) const { return material % count == number - 1; }
  std::string text() const { return std::to_string(number) + "/" + std::to_string(count); }
};

/// Parses e.g. "2/5". @throws UsageError.
Shard parseShard(const std::string& text);

inline constexpr const char* shardStem = "shard";

/// Writes the shard's file after all its materials are finished. @param stems of the whole study, in its order.
void writeShard(const std::filesystem::path& folder, const Shard& shard, const std::vector<std::string>& stems,
                const StudyFacts& facts);

/// Removes this file, so that the folder counts as incomplete while its materials are measured anew. @throws Error that
/// names the file.
void removeShard(const std::filesystem::path& folder);

/// The results of all materials, in the order of the study.
/// @throws Error that names the folder or file if a shard is incomplete, missing, given twice or belongs to another
/// study, or if the result of a material is missing or belongs to another study.
std::vector<StoredStudy> joinShards(const std::vector<std::string>& folders);

}  // namespace gonio::tool
