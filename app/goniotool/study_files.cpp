// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/study_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/io/json_text.h"
#include "core/metrics/brdf_metric.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

using namespace study;
namespace fs = std::filesystem;

Json recordJson(const StudyRecord& record) {
  const Representation& r = record.representation;
  return {{"representation", r.kind->id},
          {"family", r.kind->family->id},
          {"label", r.kind->label},
          {"budget", r.budget},
          {"budgetText", r.budgetText()},
          {"errors", errorsJson(record.errors)},
          {"renderedSnr", decibelsJson(record.renderedSnr)},
          {"identical", std::isinf(record.renderedSnr)},
          {"encodeSeconds", record.encodeSeconds},
          {"evaluationNs", record.evaluation.median},
          {"evaluationQuartilesNs", {record.evaluation.lowerQuartile, record.evaluation.upperQuartile}},
          {"frameMs", record.frameMilliseconds},
          {"bytes", record.bytes}};
}

/// null is not a number.
double numberOf(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

StudyRecord recordOf(const Json& json) {
  const std::string id = json.at("representation");
  const RepresentationKind* kind = findRepresentationKind(id);
  if (!kind) throw Error("found the representation '" + id + "', which this version of Gonio does not know");
  StudyRecord record{.representation = {kind, json.at("budget")},
                     .bytes = json.at("bytes"),
                     .encodeSeconds = numberOf(json.at("encodeSeconds"))};
  const Json& quartiles = json.at("evaluationQuartilesNs");
  record.evaluation = {numberOf(json.at("evaluationNs")), numberOf(quartiles.at(0)), numberOf(quartiles.at(1))};
  record.frameMilliseconds = numberOf(json.at("frameMs"));
  for (const metrics::MetricRecord& metric : metrics::metricRecords())
    record.errors.push_back(numberOf(json.at("errors").at(std::string(metric.id))));
  record.renderedSnr =
      json.at("identical").get<bool>() ? std::numeric_limits<double>::infinity() : numberOf(json.at("renderedSnr"));
  return record;
}

std::string cell(double value, const char* format) {
  if (std::isnan(value)) return "-";
  char text[40];
  return {text, std::size_t(std::snprintf(text, sizeof text, format, value))};
}

/// Empty facts are omitted.
Json machineJson(const MachineFacts& machine) {
  Json json = Json::object();
  if (!machine.processor.empty())
    json = {{"processor", machine.processor}, {"cores", machine.cores}, {"threads", machine.threads}};
  json.update({{"version", machine.version}, {"compiler", machine.compiler}, {"flags", machine.flags}});
  if (!machine.date.empty()) json["date"] = machine.date;
  return json;
}

/// Inverse of recordsJson(), exact. @throws Json::exception, Error.
std::vector<StudyRecord> recordsOf(const Json& json) {
  std::vector<StudyRecord> records;
  for (const Json& record : json) records.push_back(recordOf(record));
  return records;
}

/// One entry per record, with the costs for which it is on the Pareto front of the records.
Json recordsJson(std::span<const StudyRecord> records) {
  Json json = Json::array();
  for (const StudyRecord& record : records) {
    json.push_back(recordJson(record));
    json.back()["front"] = Json::array();
  }
  for (const Cost cost : allCosts)
    for (const std::size_t i : paretoFront(costsAndErrors(records, cost, {})))
      json[i]["front"].push_back(costName(cost));
  return json;
}

std::vector<StudyRecord> mediansOf(std::span<const StudySummary> summaries) {
  std::vector<StudyRecord> medians;
  medians.reserve(summaries.size());
  for (const StudySummary& summary : summaries) medians.push_back(summary.median);
  return medians;
}

/// As recordsJson() for medians, each with the number of materials and the minimum and maximum rendered SNR.
Json summaryJson(std::span<const StudySummary> summaries) {
  Json json = recordsJson(mediansOf(summaries));
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    json[i]["materials"] = summaries[i].materials;
    json[i]["minSnr"] = decibelsJson(summaries[i].minSnr);
    json[i]["maxSnr"] = decibelsJson(summaries[i].maxSnr);
  }
  return json;
}

/// A table as text.
std::string recordsText(std::span<const StudyRecord> records) {
  char line[200];
  std::snprintf(line, sizeof line, "  %-52s %17s %11s %10s %9s %10s\n", "representation", "rendered SNR [dB]",
                "eval. [ns]", "frame [ms]", "bytes", "encode [s]");
  std::string text = line;
  for (const StudyRecord& record : records) {
    const std::string label = record.representation.fullLabel();
    // Columns are counted in characters: a letter with an accent has two bytes.
    const auto furtherBytes = std::ranges::count_if(label, [](char c) { return (c & 0xc0) == 0x80; });
    std::snprintf(line, sizeof line, "  %-*s %17s %11s %10s %9s %10s\n", 52 + int(furtherBytes), label.c_str(),
                  cell(record.renderedSnr, "%.2f").c_str(), cell(record.evaluation.median, "%.1f").c_str(),
                  cell(record.frameMilliseconds, "%.2f").c_str(), shortNumber(double(record.bytes)).c_str(),
                  cell(record.encodeSeconds, "%.3g").c_str());
    text += line;
  }
  return text;
}

fs::path fileOf(const fs::path& folder, const std::string& stem, const char* suffix) {
  return folder / (stem + suffix);
}

Json machineWithoutDate(const MachineFacts& machine) {
  Json json = machineJson(machine);
  json.erase("date");
  return json;
}

/// `head`: the first members of the JSON file.
void write(const fs::path& folder, const std::string& stem, Json head, std::span<const StudyRecord> records,
           const Json& recordsAsJson, const StudyFacts& facts) {
  const std::string title = head["material"];
  head.update({{"pictures", facts.pictures},
               {"settings", Json::parse(facts.settings)},
               {"machine", machineJson(facts.machine)},
               {"records", recordsAsJson}});
  std::vector<std::string> notes = machineLines(facts.machine);
  notes.push_back("images and frame times: " + facts.pictures);
  const std::vector<StudyAxes> axes =
      facts.timed() ? allCostAxes() : std::vector<StudyAxes>{{.cost = Cost::bytes, .quality = {}}};
  const std::string json = io::jsonText(head, 2) + "\n";
  const std::string csv = io::toCsv(studyCsv("material: " + title, records, facts.machine, facts.pictures));
  const std::string svg = studySvg(title, records, axes, notes);
  const auto content = [&](const char* suffix, const std::string& text) {
    return io::FileContent{fileOf(folder, stem, suffix), std::as_bytes(std::span(text))};
  };
  // The JSON file is renamed last: where it exists, the others do too.
  const std::vector files{content(".csv", csv), content(".svg", svg), content(".json", json)};
  io::writeFilesAtomically(files);
}

/// Reads JSON with its members in the order of the file. @throws Error if it is invalid or nested too deeply.
Json readOrderedJson(const fs::path& path) {
  const std::string text = io::readText(path);
  io::parseJson(text);  // for the limit of its depth; its members are sorted
  return Json::parse(text);
}

/// Settings of a file as text, with the present ids of representations: "ID BUDGET" each.
std::string settingsText(Json settings) {
  for (Json& one : settings.at("representations")) {
    const std::string text = one, id = text.substr(0, text.find(' '));
    if (const RepresentationKind* kind = findRepresentationKind(id))
      one = std::string(kind->id) + text.substr(id.size());
  }
  return io::jsonText(settings);
}

}  // namespace

StudyFacts studyFacts(const std::string& pictures, const MachineFacts& machine,
                      std::span<const Representation> representations, const StudyInputs& inputs) {
  StudyFacts facts{pictures, machine, {}};
  Json names = Json::array();
  for (const Representation& r : representations) names.push_back(r.id() + " " + io::decimalText(r.budget, 0));
  const Json settings{{"pictures", pictures},
                      {"times", facts.timed()},
                      {"machine", machineWithoutDate(machine)},
                      {"dictionaries", inputs.dictionaries},
                      {"components", inputs.components},
                      {"patches", inputs.patches},
                      {"npf", inputs.npf},
                      {"representations", names}};
  facts.settings = io::jsonText(settings);
  return facts;
}

void writeMaterialStudy(const fs::path& folder, const StudiedMaterial& material, const StudyFacts& facts) {
  write(folder, material.stem, {{"material", material.name}, {"source", material.source}}, material.records,
        recordsJson(material.records), facts);
}

bool hasMaterialStudy(const fs::path& folder, const std::string& stem) {
  return fs::exists(fileOf(folder, stem, ".json"));
}

std::optional<StudiedMaterial> finishedStudy(const fs::path& folder, const std::string& stem, const std::string& source,
                                             const StudyFacts& facts, std::size_t records) {
  if (!hasMaterialStudy(folder, stem)) return std::nullopt;
  try {
    const Json json = readOrderedJson(fileOf(folder, stem, ".json"));
    StudiedMaterial found{stem, json.at("material"), json.at("source"), recordsOf(json.at("records"))};
    const bool same = settingsText(json.at("settings")) == facts.settings && found.source == source;
    if (same && found.records.size() == records) return found;
  } catch (const Json::exception&) {  // measured again
  } catch (const Error&) {
  }
  return std::nullopt;
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
  write(folder_, "summary", {{"material", title}}, medians, summaryJson(summaries), facts_);
  text_ += title + "\n" + recordsText(medians);
}

void StudyOutput::print(const Tool& tool, bool complete, double seconds) {
  Json json{{"records", records_}, {"summary", summaryJson(summarise(all_))}};
  if (!chosen_.empty()) json["chosen"] = chosen_;
  json.update({{"complete", complete},
               {"pictures", facts_.pictures},
               {"machine", machineJson(facts_.machine)},
               {"seconds", seconds},
               {"out", folder_}});
  for (const std::string& line : machineLines(facts_.machine)) text_ += line + "\n";
  tool::print(tool, json, text_);
}

void StudyOutput::choose(const StudiedMaterial& material) {
  if (!budget_.frameMilliseconds && !budget_.renderedSnr && !budget_.bytes) return;
  const auto best = bestWithin(material.records, budget_);
  const Representation* representation = best ? &material.records[*best].representation : nullptr;
  Json chosen(nullptr);
  if (representation) chosen = {{"representation", representation->kind->id}, {"budget", representation->budget}};
  chosen_.push_back({{"material", material.name}, {"best", chosen}});
  text_ += representation ? "best within the budget: " + representation->fullLabel() + "\n"
                          : "no representation meets the budget\n";
}

}  // namespace gonio::tool
