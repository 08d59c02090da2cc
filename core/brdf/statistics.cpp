// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio {

TableStatistics tableStatistics(const TabulatedBrdf& table) {
  TableStatistics statistics;
  const auto values = table.values();
  const auto valid = table.valid();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double smallest = infinity, largest = 0;
  if (table.validCount() > 0) statistics.channels.fill({infinity, -infinity});
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!valid[i]) continue;
    for (int channel = 0; channel < 3; ++channel) {
      const double value = values[i][channel];
      ChannelRange& range = statistics.channels[std::size_t(channel)];
      range.min = std::min(range.min, value);
      range.max = std::max(range.max, value);
      if (value > 0) smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  if (!values.empty()) statistics.invalidFraction = 1 - double(table.validCount()) / double(values.size());
  if (largest > 0) statistics.dynamicRange = largest / smallest;
  return statistics;
}

}  // namespace gonio
