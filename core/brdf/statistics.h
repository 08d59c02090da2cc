// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/brdf/tabulated_brdf.h"

namespace gonio {

/// Range of the valid values of one channel, 1/sr.
struct ChannelRange {
  double min = 0, max = 0;
};

struct TableStatistics {
  std::array<ChannelRange, 3> channels;
  double invalidFraction = 0;  ///< invalid cells / all cells
  double dynamicRange = 0;     ///< largest / smallest positive value of any channel; 0 for a black table
};
TableStatistics tableStatistics(const TabulatedBrdf& table);

}  // namespace gonio
