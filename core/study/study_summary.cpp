// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_summary.h"

#include <algorithm>
#include <cmath>

namespace gonio::study {

namespace {

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
  std::ranges::stable_sort(groups, {},
                           [](const Records& group) { return group.front().record->representation.family; });
  std::vector<StudySummary> summaries;
  summaries.reserve(groups.size());
  for (const Records& group : groups) summaries.push_back(summaryOf(group));
  return summaries;
}

}  // namespace gonio::study
