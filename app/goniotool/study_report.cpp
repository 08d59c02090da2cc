// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/study_report.h"

#include <cmath>
#include <cstdio>

#include "core/io/atomic_file.h"
#include "core/study/study_csv.h"
#include "core/study/study_plot.h"

namespace gonio::tool {

namespace {

using namespace study;

Json recordJson(const StudyRecord& record) {
  const Representation& r = record.representation;
  return {{"representation", r.id},
          {"family", familyId(r.family)},
          {"label", r.label},
          {"budget", r.budget},
          {"budgetText", r.budgetText},
          {"errors", errorsJson(record.errors)},
          {"renderedSnr", decibelsJson(record.renderedSnr)},
          {"identical", std::isinf(record.renderedSnr)},
          {"encodeSeconds", record.encodeSeconds},
          {"evaluationNs", record.evaluation.median},
          {"evaluationQuartilesNs", {record.evaluation.lowerQuartile, record.evaluation.upperQuartile}},
          {"frameMs", record.frameMilliseconds},
          {"bytes", record.bytes}};
}

}  // namespace

Json machineJson(const MachineFacts& machine) {
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"threads", machine.threads},
          {"version", machine.version},
          {"compiler", machine.compiler},
          {"flags", machine.flags},
          {"date", machine.date}};
}

Json recordsJson(std::span<const StudyRecord> records) {
  Json json = Json::array();
  for (const StudyRecord& record : records) {
    json.push_back(recordJson(record));
    json.back()["front"] = Json::array();
  }
  for (const Cost cost : allCosts)
    for (const std::size_t i : paretoFront(tradesOf(records, cost, {}))) json[i]["front"].push_back(costName(cost));
  return json;
}

Json summaryJson(std::span<const StudySummary> summaries) {
  std::vector<StudyRecord> medians;
  for (const StudySummary& summary : summaries) medians.push_back(summary.median);
  Json json = recordsJson(medians);
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    json[i]["materials"] = summaries[i].materials;
    json[i]["leastSnr"] = decibelsJson(summaries[i].leastSnr);
    json[i]["mostSnr"] = decibelsJson(summaries[i].maxSnr);
  }
  return json;
}

std::string recordsText(std::span<const StudyRecord> records) {
  char line[200];
  std::snprintf(line, sizeof line, "  %-52s %9s %11s %9s %9s %9s\n", "representation", "SNR, dB", "value, ns",
                "frame, ms", "bytes", "encode, s");
  std::string text = line;
  for (const StudyRecord& record : records) {
    std::snprintf(line, sizeof line, "  %-52s %9.2f %11.1f %9.2f %9s %9.3g\n",
                  record.representation.fullLabel().c_str(), record.renderedSnr, record.evaluation.median,
                  record.frameMilliseconds, shortNumber(double(record.bytes)).c_str(), record.encodeSeconds);
    text += line;
  }
  return text;
}

void writeStudy(const std::filesystem::path& stem, const StudyTitle& title, std::span<const StudyRecord> records,
                const Json& recordsAsJson) {
  const auto file = [&](const char* suffix) { return std::filesystem::path(stem.string() + suffix); };
  const Json json{{"material", title.material},
                  {"pictures", title.pictures},
                  {"machine", machineJson(title.machine)},
                  {"records", recordsAsJson}};
  io::writeFileAtomically(file(".json"), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  io::writeFileAtomically(
      file(".csv"), plots::toCsv(studyCsv("material: " + title.material, records, title.machine, title.pictures)));
  std::vector<std::string> notes = machineLines(title.machine);
  notes.push_back("pictures and frames: " + title.pictures);
  io::writeFileAtomically(file(".svg"), studySvg(title.material, records, allCostAxes(), notes));
}

}  // namespace gonio::tool
