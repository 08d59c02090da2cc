// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/study_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/metrics/brdf_metric.h"
#include "core/study/study_axis.h"

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

/// null is not a number.
double numberOf(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

StudyRecord recordOf(const Json& json) {
  StudyRecord record{.representation = {.family = familyById(json.at("family").get<std::string>()),
                                        .id = json.at("representation"),
                                        .label = json.at("label"),
                                        .budget = json.at("budget"),
                                        .budgetText = json.at("budgetText")},
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

}  // namespace

Json machineJson(const MachineFacts& machine) {
  Json json = Json::object();
  if (!machine.processor.empty())
    json = {{"processor", machine.processor}, {"cores", machine.cores}, {"threads", machine.threads}};
  json.update({{"version", machine.version}, {"compiler", machine.compiler}, {"flags", machine.flags}});
  if (!machine.date.empty()) json["date"] = machine.date;
  return json;
}

std::vector<StudyRecord> recordsOf(const Json& json) {
  std::vector<StudyRecord> records;
  for (const Json& record : json) records.push_back(recordOf(record));
  return records;
}

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

Json summaryJson(std::span<const StudySummary> summaries) {
  std::vector<StudyRecord> medians;
  for (const StudySummary& summary : summaries) medians.push_back(summary.median);
  Json json = recordsJson(medians);
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    json[i]["materials"] = summaries[i].materials;
    json[i]["minSnr"] = decibelsJson(summaries[i].minSnr);
    json[i]["maxSnr"] = decibelsJson(summaries[i].maxSnr);
  }
  return json;
}

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

}  // namespace gonio::tool
