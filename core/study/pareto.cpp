// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace gonio::study {

std::vector<std::size_t> paretoFront(std::span<const CostAndError> candidates) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!std::isnan(candidates[i].cost) && !std::isnan(candidates[i].error)) order.push_back(i);
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return std::tuple(candidates[i].cost, candidates[i].error); });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    const bool equal = !front.empty() && candidates[front.back()].cost == candidates[i].cost &&
                       candidates[front.back()].error == candidates[i].error;
    if (front.empty() || equal || candidates[i].error < candidates[front.back()].error) front.push_back(i);
  }
  return front;
}

std::optional<std::size_t> bestWithin(std::span<const StudyRecord> records, const Budget& budget) {
  const auto keeps = [&](const StudyRecord& record) {
    return !(budget.frameMilliseconds && record.frameMilliseconds > *budget.frameMilliseconds) &&
           !(budget.bytes && double(record.bytes) > *budget.bytes) &&
           (!budget.renderedSnr || record.renderedSnr >= *budget.renderedSnr);
  };
  const auto order = [](const StudyRecord& record) {
    const bool undefined = std::isnan(record.renderedSnr);
    return std::tuple(undefined, undefined ? 0 : -record.renderedSnr, record.frameMilliseconds, record.bytes);
  };
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < records.size(); ++i)
    if (keeps(records[i]) && (!best || order(records[i]) < order(records[*best]))) best = i;
  return best;
}

}  // namespace gonio::study
