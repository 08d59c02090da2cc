// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_record.h"

#include <array>

namespace gonio::study {

namespace {

struct CostText {
  std::string_view name, unit;
};
constexpr std::array<CostText, std::size(allCosts)> texts{
    {{"evaluation", "ns"}, {"frame", "ms"}, {"size", "B"}, {"encoding", "s"}}};

}  // namespace

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

}  // namespace gonio::study
