// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <chrono>

#include "app/goniotool/study_output.h"
#include "app/goniotool/study_shards.h"

namespace gonio::tool {

namespace {

struct MergeArguments {
  std::vector<std::string> shards;
  std::string out;
};

int merge(const MergeArguments& options, const Tool& tool) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::vector<StoredStudy> joined = joinShards(options.shards);
  if (joined.empty()) throw Error("the shards contain no materials");
  const StudyFacts& facts = joined.front().facts;
  tool.throwIfStopped();
  makeFolder(options.out);
  StudyOutput output(options.out, facts);
  for (const StoredStudy& read : joined) {
    writeMaterialStudy(options.out, read.material, read.facts);
    output.add(read.material);
  }
  output.writeSummary();
  output.print(tool, true, std::chrono::duration<double>(Clock::now() - start).count());
  return 0;
}

}  // namespace

void addMerge(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<MergeArguments>();
  CLI::App* command = app.add_subcommand("merge", "Merges the shards of a study into the results of a single run");
  command->add_option("SHARD", options->shards, "Folders that goniotool study --shard wrote, in any order")->required();
  command->add_option("--out", options->out, "Folder for the merged results, created if needed")
      ->group(outputGroup)
      ->required();
  command->callback([options, &tool] { tool.run = [options, &tool] { return merge(*options, tool); }; });
}

}  // namespace gonio::tool
