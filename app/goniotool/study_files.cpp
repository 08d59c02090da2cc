// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/study_files.h"

#include "app/goniotool/study_report.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/io/json_text.h"
#include "core/metrics/brdf_metric.h"
#include "core/study/study_csv.h"
#include "core/study/study_plot.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

using namespace study;
namespace fs = std::filesystem;

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

MachineFacts machineOf(const Json& json) {
  MachineFacts facts{.processor = json.value("processor", ""),
                     .version = json.at("version"),
                     .compiler = json.at("compiler"),
                     .flags = json.at("flags"),
                     .date = json.value("date", "")};
  facts.cores = json.value("cores", 0);
  facts.threads = json.value("threads", 0);
  return facts;
}

}  // namespace

StudyFacts studyFacts(const std::string& pictures, const MachineFacts& machine,
                      std::span<const Representation> representations, const StudyInputs& inputs) {
  StudyFacts facts{pictures, machine, {}};
  Json names = Json::array();
  for (const Representation& r : representations) names.push_back(r.id + " " + io::decimalText(r.budget, 0));
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

void writeSummary(const fs::path& folder, const std::string& title, std::span<const StudyRecord> medians,
                  const Json& records, const StudyFacts& facts) {
  write(folder, "summary", {{"material", title}}, medians, records, facts);
}

Json readOrderedJson(const fs::path& path) {
  const std::string text = io::readText(path);
  io::parseJson(text);  // for the limit of its depth; its members are sorted
  return Json::parse(text);
}

StoredStudy readMaterialStudy(const fs::path& folder, const std::string& stem) {
  const fs::path path = fileOf(folder, stem, ".json");
  return withFileInErrors(path, [&] {
    try {
      const Json json = readOrderedJson(path);
      return StoredStudy{{stem, json.at("material"), json.at("source"), recordsOf(json.at("records"))},
                         {json.at("pictures"), machineOf(json.at("machine")), io::jsonText(json.at("settings"))}};
    } catch (const Json::exception& error) {
      throw Error(std::string("not the result of a study that can be merged: ") + error.what());
    }
  });
}

std::optional<StudiedMaterial> finishedStudy(const fs::path& folder, const std::string& stem, const std::string& source,
                                             const StudyFacts& facts, std::size_t records) {
  if (!hasMaterialStudy(folder, stem)) return std::nullopt;
  try {
    StoredStudy found = readMaterialStudy(folder, stem);
    const bool same = found.facts.settings == facts.settings && found.material.source == source;
    if (same && found.material.records.size() == records) return std::move(found.material);
  } catch (const Error&) {  // measured again
  }
  return std::nullopt;
}

}  // namespace gonio::tool
