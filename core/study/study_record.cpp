// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>
#include <thread>

#include "core/math/parallel.h"
#include "core/metrics/brdf_metric.h"
#include "core/rendering/render_picture.h"
#include "core/support/system.h"

namespace gonio::study {

namespace {

constexpr std::size_t pairCount = 1 << 14;
constexpr std::size_t maxRuns = 7, minRuns = 3;
constexpr double enoughTimedSeconds = 0.5;

std::vector<DirectionPair> randomPairs() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] {
    const double cosine = 1 - uniform(random);  // in (0, 1]: above the horizon
    return fromSpherical(std::acos(cosine), 2 * pi * uniform(random));
  };
  std::vector<DirectionPair> pairs(pairCount);
  for (DirectionPair& pair : pairs) {
    pair.wi = direction();
    pair.wo = direction();
  }
  return pairs;
}

struct CostText {
  std::string_view name, unit;
};
constexpr std::array<CostText, std::size(allCosts)> texts{
    {{"evaluation", "ns"}, {"frame", "ms"}, {"size", "B"}, {"encoding", "s"}}};

std::string dateNow() {
  const std::tm utc = system::utc(std::time(nullptr));
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

struct OfMaterial {
  const StudyRecord* record;
  std::size_t material;
};
using Records = std::vector<OfMaterial>;

template <typename Value>
std::vector<double> numbers(const Records& records, const Value& value) {
  std::vector<double> result;
  for (const OfMaterial& one : records)
    if (const auto number = double(value(*one.record)); !std::isnan(number)) result.push_back(number);
  return result;
}

StudySummary summaryOf(const Records& records) {
  const auto median = [&](const auto& value) { return quantile(numbers(records, value), 0.5); };
  using R = const StudyRecord&;
  const StudyRecord& first = *records.front().record;
  StudySummary summary{.median = {.representation = first.representation}, .materials = records.size()};
  StudyRecord& m = summary.median;
  m.bytes = std::size_t(std::lround(median([](R r) { return r.bytes; })));
  m.encodeSeconds = median([](R r) { return r.encodeSeconds; });
  m.evaluation = {median([](R r) { return r.evaluation.median; }),
                  median([](R r) { return r.evaluation.lowerQuartile; }),
                  median([](R r) { return r.evaluation.upperQuartile; })};
  m.frameMilliseconds = median([](R r) { return r.frameMilliseconds; });
  for (std::size_t i = 0; i < first.errors.size(); ++i) m.errors.push_back(median([i](R r) { return r.errors[i]; }));
  const std::vector<double> snr = numbers(records, [](R r) { return r.renderedSnr; });
  m.renderedSnr = quantile(snr, 0.5);
  summary.minSnr = quantile(snr, 0);
  summary.maxSnr = quantile(snr, 1);
  const auto worst =
      std::ranges::find(records, summary.minSnr, [](const OfMaterial& one) { return one.record->renderedSnr; });
  summary.worst = worst == records.end() ? records.front().material : worst->material;
  return summary;
}

}  // namespace

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const double at = fraction * double(values.size() - 1);
  const auto below = std::size_t(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  // Two equal values, of which one may be infinite, need no arithmetic.
  if (values[below] == values[above] || at == double(below)) return values[below];
  return std::lerp(values[below], values[above], at - double(below));
}

EvaluationTime measureEvaluation(const Brdf& brdf, const TaskControl& control) {
  static const std::vector<DirectionPair> pairs = randomPairs();
  std::vector<Rgb> values(pairs.size());
  std::vector<double> runs;
  double total = 0;
  while (runs.size() < minRuns || (runs.size() < maxRuns && total < enoughTimedSeconds)) {
    control.throwIfStopped();
    const double start = system::threadSeconds();
    brdf.evaluate(pairs, values);
    const double seconds = system::threadSeconds() - start;
    runs.push_back(seconds * 1e9 / double(pairCount));
    total += seconds;
  }
  return {quantile(runs, 0.5), quantile(runs, 0.25), quantile(runs, 0.75)};
}

double costOf(const StudyRecord& record, Cost cost) {
  switch (cost) {
    case Cost::evaluation:
      return record.evaluation.median;
    case Cost::frame:
      return record.frameMilliseconds;
    case Cost::bytes:
      return double(record.bytes);
    case Cost::encoding:
      break;
  }
  return record.encodeSeconds;
}

std::string_view costName(Cost cost) { return texts[std::size_t(cost)].name; }
std::string_view costUnit(Cost cost) { return texts[std::size_t(cost)].unit; }

MachineFacts machineFacts() {
  MachineFacts facts = buildFacts();
  facts.processor = system::processorName();
  facts.cores = int(std::thread::hardware_concurrency());
  facts.threads = threadCount();
  facts.date = dateNow();
  return facts;
}

MachineFacts buildFacts() {
  return {.processor = {},
          .version = GONIO_BUILD_VERSION,
          .compiler = GONIO_BUILD_COMPILER,
          .flags = GONIO_BUILD_FLAGS,
          .date = {}};
}

std::vector<std::string> machineLines(const MachineFacts& facts) {
  const auto counted = [](int count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  std::vector<std::string> lines;
  if (!facts.processor.empty())
    lines.push_back(facts.processor + ", " + counted(facts.cores, "core") + ", " + counted(facts.threads, "thread"));
  lines.push_back("Gonio " + facts.version + ", " + facts.compiler + ", " + facts.flags);
  if (!facts.date.empty()) lines.push_back(facts.date);
  return lines;
}

std::vector<StudySummary> summarise(std::span<const std::vector<StudyRecord>> materials) {
  std::vector<Records> groups;
  for (std::size_t material = 0; material < materials.size(); ++material)
    for (const StudyRecord& record : materials[material]) {
      const auto known = std::ranges::find_if(
          groups, [&](const Records& group) { return group.front().record->representation == record.representation; });
      if (known == groups.end())
        groups.push_back({{&record, material}});
      else
        known->push_back({&record, material});
    }
  // In the order of display, also if the first materials lack a representation.
  std::ranges::stable_sort(groups, {}, [](const Records& group) { return group.front().record->representation.kind; });
  std::vector<StudySummary> summaries;
  summaries.reserve(groups.size());
  for (const Records& group : groups) summaries.push_back(summaryOf(group));
  return summaries;
}

std::string picturesText(int width, int height, int samples) {
  return std::string(rendering::comparisonSceneName) + ", " + std::to_string(width) + " x " + std::to_string(height) +
         ", " + std::to_string(samples) + " samples";
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
  texts("family", [](R r) { return r.representation.kind->family->id; });
  texts("representation", [](R r) { return r.representation.kind->id; });
  texts("label", [](R r) { return r.representation.kind->label; });
  numbers("budget", [](R r) { return r.representation.budget; });
  texts("budget text", [](R r) { return r.representation.budgetText(); });
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
