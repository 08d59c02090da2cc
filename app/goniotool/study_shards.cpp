// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/study_shards.h"

#include <map>

#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/io/json_text.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

namespace fs = std::filesystem;

struct ShardFile {
  fs::path folder;
  Shard shard;
  std::vector<std::string> stems;
  std::string settings;
};

fs::path shardPath(const fs::path& folder) { return folder / (std::string(shardStem) + ".json"); }

ShardFile readShard(const fs::path& folder) {
  const fs::path path = shardPath(folder);
  if (!fs::exists(path))
    throw Error(path.string() + ": not found: goniotool study --shard writes it when the shard is complete");
  return withFileInErrors(path, [&] {
    try {
      const Json json = readOrderedJson(path);
      ShardFile file{
          folder, {json.at("shard"), json.at("shards")}, json.at("materials"), io::jsonText(json.at("settings"))};
      if (file.shard.number < 1 || file.shard.number > file.shard.count)
        throw Error("found shard " + file.shard.text() + ", expected I/N with I from 1 to N");
      return file;
    } catch (const Json::exception& error) {
      throw Error(std::string("not a shard of a study: ") + error.what());
    }
  });
}

/// The first setting that differs, with both values, e.g. `samples 32, expected 64`.
/// @param between stands between the values, e.g. ", expected ".
std::string difference(const std::string& settingsA, const std::string& settingsB, const std::string& between) {
  const Json a = Json::parse(settingsA), b = Json::parse(settingsB);
  for (const auto& [key, value] : a.items())
    if (!b.contains(key) || b[key] != value)
      return key + " " + io::jsonText(value) + between + (b.contains(key) ? io::jsonText(b[key]) : "none");
  return "other settings";
}

void checkSameStudy(const ShardFile& a, const ShardFile& b) {
  const std::string folders = a.folder.string() + " and " + b.folder.string() + " are not shards of one study: ";
  if (a.settings != b.settings)
    throw Error(folders + "different settings: " + difference(a.settings, b.settings, " and "));
  if (a.stems != b.stems) throw Error(folders + "they contain different materials");
  if (a.shard.count != b.shard.count)
    throw Error(folders + "found shards " + a.shard.text() + " and " + b.shard.text());
}

/// By their numbers.
std::map<std::size_t, ShardFile> completeShards(const std::vector<std::string>& folders) {
  std::map<std::size_t, ShardFile> shards;
  for (const std::string& folder : folders) {
    ShardFile file = readShard(folder);
    if (!shards.empty()) checkSameStudy(shards.begin()->second, file);
    const auto [known, added] = shards.try_emplace(file.shard.number, file);
    if (!added)
      throw Error("found shard " + file.shard.text() + " twice: " + known->second.folder.string() + " and " +
                  file.folder.string());
  }
  const std::size_t count = shards.begin()->second.shard.count;
  std::string missing;
  for (std::size_t number = 1; number <= count; ++number)
    if (!shards.contains(number)) missing += (missing.empty() ? "" : ", ") + Shard{number, count}.text();
  if (!missing.empty()) throw Error("shards are missing: " + missing);
  return shards;
}

}  // namespace

Shard parseShard(const std::string& text) {
  const auto slash = text.find('/');
  Shard shard;
  if (slash == std::string::npos || !CLI::detail::lexical_cast(text.substr(0, slash), shard.number) ||
      !CLI::detail::lexical_cast(text.substr(slash + 1), shard.count) || shard.number < 1 || shard.number > shard.count)
    throw UsageError("found '" + text + "', expected I/N with I from 1 to N");
  return shard;
}

void writeShard(const fs::path& folder, const Shard& shard, const std::vector<std::string>& stems,
                const StudyFacts& facts) {
  const Json json{{"shard", shard.number},
                  {"shards", shard.count},
                  {"materials", stems},
                  {"settings", Json::parse(facts.settings)}};
  io::writeFileAtomically(shardPath(folder), io::jsonText(json, 2) + "\n");
}

void removeShard(const fs::path& folder) {
  std::error_code cause;
  fs::remove(shardPath(folder), cause);
  if (cause) throw Error(shardPath(folder).string() + ": cannot be removed: " + cause.message());
}

std::vector<StoredStudy> joinShards(const std::vector<std::string>& folders) {
  const std::map<std::size_t, ShardFile> shards = completeShards(folders);
  const ShardFile& first = shards.begin()->second;
  std::vector<StoredStudy> joined;
  for (std::size_t i = 0; i < first.stems.size(); ++i) {
    const fs::path& folder = shards.at(i % first.shard.count + 1).folder;
    StoredStudy read = readMaterialStudy(folder, first.stems[i]);
    if (read.facts.settings != first.settings)
      throw Error((folder / first.stems[i]).string() + ".json: result of another study: found " +
                  difference(read.facts.settings, first.settings, ", expected "));
    joined.push_back(std::move(read));
  }
  return joined;
}

}  // namespace gonio::tool
