// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/study_output.h"

#include "app/goniotool/study_report.h"

namespace gonio::tool {

namespace {

using namespace study;

std::vector<StudyRecord> mediansOf(std::span<const StudySummary> summaries) {
  std::vector<StudyRecord> medians;
  medians.reserve(summaries.size());
  for (const StudySummary& summary : summaries) medians.push_back(summary.median);
  return medians;
}

}  // namespace

void makeFolder(const std::string& path) {
  std::error_code cause;
  std::filesystem::create_directories(path, cause);
  if (!std::filesystem::is_directory(path)) throw Error(path + ": the folder cannot be created: " + cause.message());
}

void StudyOutput::add(const StudiedMaterial& material) {
  for (const Json& record : recordsJson(material.records)) {
    records_.push_back({{"material", material.name}});
    records_.back().update(record);
  }
  text_ += material.name + "\n" + recordsText(material.records);
  if (material.complete) choose(material);
  all_.push_back(material.records);
}

void StudyOutput::writeSummary() {
  if (all_.size() < 2) return;
  const std::vector<StudySummary> summaries = summarise(all_);
  const std::vector<StudyRecord> medians = mediansOf(summaries);
  const std::string title = "median of " + std::to_string(all_.size()) + " materials";
  tool::writeSummary(folder_, title, medians, summaryJson(summaries), facts_);
  text_ += title + "\n" + recordsText(medians);
}

void StudyOutput::print(const Tool& tool, bool complete, double seconds, const Json& further) {
  Json json{{"records", records_}, {"summary", summaryJson(summarise(all_))}};
  if (!chosen_.empty()) json["chosen"] = chosen_;
  json.update({{"complete", complete},
               {"pictures", facts_.pictures},
               {"machine", machineJson(facts_.machine)},
               {"seconds", seconds},
               {"out", folder_}});
  json.update(further);
  for (const std::string& line : machineLines(facts_.machine)) text_ += line + "\n";
  tool::print(tool, json, text_);
}

void StudyOutput::choose(const StudiedMaterial& material) {
  if (!budget_.frameMilliseconds && !budget_.renderedSnr && !budget_.bytes) return;
  const auto best = bestWithin(material.records, budget_);
  const Representation* representation = best ? &material.records[*best].representation : nullptr;
  Json chosen(nullptr);
  if (representation) chosen = {{"representation", representation->id}, {"budget", representation->budget}};
  chosen_.push_back({{"material", material.name}, {"best", chosen}});
  text_ += representation ? "best within the budget: " + representation->fullLabel() + "\n"
                          : "no representation meets the budget\n";
}

}  // namespace gonio::tool
