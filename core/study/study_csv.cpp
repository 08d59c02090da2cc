// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_csv.h"

#include "core/metrics/brdf_metric.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {

std::string picturesText(int width, int height, int samples) {
  return std::string(comparisonSceneName) + ", " + std::to_string(width) + " x " + std::to_string(height) + ", " +
         std::to_string(samples) + " samples";
}

io::CsvTable studyCsv(const std::string& title, std::span<const StudyRecord> records, const MachineFacts& machine,
                      const std::string& pictures) {
  io::CsvTable table{.comments = {title, "images and frame times: " + pictures}, .columns = {}};
  for (const std::string& line : machineLines(machine)) table.comments.push_back(line);
  const auto texts = [&](const char* name, const auto& text) {
    io::CsvColumn& column = table.columns.emplace_back(io::CsvColumn{.title = name, .values = {}});
    for (const StudyRecord& record : records) column.texts.push_back(std::string(text(record)));
  };
  const auto numbers = [&](const std::string& name, const auto& number) {
    io::CsvColumn& column = table.columns.emplace_back(io::CsvColumn{.title = name, .values = {}});
    for (const StudyRecord& record : records) column.values.push_back(double(number(record)));
  };
  using R = const StudyRecord&;
  texts("family", [](R r) { return familyId(r.representation.family); });
  texts("representation", [](R r) { return r.representation.id; });
  texts("label", [](R r) { return r.representation.label; });
  numbers("budget", [](R r) { return r.representation.budget; });
  texts("budget text", [](R r) { return r.representation.budgetText; });
  numbers("bytes [B]", [](R r) { return r.bytes; });
  numbers("encoding [s]", [](R r) { return r.encodeSeconds; });
  numbers("evaluation median [ns]", [](R r) { return r.evaluation.median; });
  numbers("evaluation lower quartile [ns]", [](R r) { return r.evaluation.lowerQuartile; });
  numbers("evaluation upper quartile [ns]", [](R r) { return r.evaluation.upperQuartile; });
  numbers("frame [ms]", [](R r) { return r.frameMilliseconds; });
  numbers("rendered SNR [dB]", [](R r) { return r.renderedSnr; });
  const auto metricRecords = metrics::metricRecords();
  for (std::size_t i = 0; i < metricRecords.size(); ++i) {
    const std::string unit = metricRecords[i].unit.empty() ? "" : " [" + std::string(metricRecords[i].unit) + "]";
    numbers(std::string(metricRecords[i].id) + unit, [i](R r) { return r.errors[i]; });
  }
  return table;
}

io::CsvTable summaryCsv(const std::string& title, std::span<const StudySummary> summaries,
                        std::span<const std::string> materials, const MachineFacts& machine,
                        const std::string& pictures) {
  std::vector<StudyRecord> medians;
  io::CsvColumn count{"materials", {}}, least{"min rendered SNR [dB]", {}}, most{"max rendered SNR [dB]", {}},
      worst{"worst material", {}};
  for (const StudySummary& summary : summaries) {
    medians.push_back(summary.median);
    count.values.push_back(double(summary.materials));
    least.values.push_back(summary.minSnr);
    most.values.push_back(summary.maxSnr);
    worst.texts.push_back(materials[summary.worst]);
  }
  io::CsvTable table = studyCsv(title, medians, machine, pictures);
  for (io::CsvColumn* column : {&count, &least, &most, &worst}) table.columns.push_back(std::move(*column));
  return table;
}

}  // namespace gonio::study
