// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_warnings.h"

#include <algorithm>
#include <array>
#include <limits>

namespace gonio::fitting {

namespace {

constexpr std::array<const char*, 3> channelNames{"red", "green", "blue"};

constexpr double noticeableShare = 0.01;

/// One channel over the cells that count.
struct ChannelCensus {
  float smallest = std::numeric_limits<float>::infinity(), largest = -smallest;
  double total = 0, heaviest = 0;  ///< of value times measure of the cell
};

using Channels = std::array<ChannelCensus, 3>;

Channels takeChannelCensus(const TabulatedBrdf& table, const CellCensus& census) {
  const HalfDifferenceGrid& grid = table.grid();
  Channels channels;
  double measure = 0;
  for (std::size_t cell = 0; cell < census.counts.size(); ++cell) {
    if (cell % std::size_t(grid.phiDCount) == 0) measure = grid.cellMeasure(cell);  // the same for all phi_d
    if (!census.counts[cell]) continue;
    for (int c = 0; c < 3; ++c) {
      ChannelCensus& channel = channels[std::size_t(c)];
      const float value = table.values()[cell][c];
      channel.smallest = std::min(channel.smallest, value);
      channel.largest = std::max(channel.largest, value);
      const double weight = value * measure;
      channel.total += weight;
      channel.heaviest = std::max(channel.heaviest, weight);
    }
  }
  return channels;
}

template <typename Predicate>
std::string namesOf(const Channels& channels, Predicate matches) {
  std::string names;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (matches(channels[c])) names += (names.empty() ? "" : ", ") + std::string(channelNames[c]);
  return names;
}

}  // namespace

std::vector<std::string> measurementWarnings(const TabulatedBrdf& table, const CellCensus& census) {
  if (census.used == 0)
    return {"The measurement has no valid cell within the polar angles that count: nothing was fitted."};
  const Channels channels = takeChannelCensus(table, census);
  std::vector<std::string> warnings;
  const auto isBlack = [](const ChannelCensus& c) { return !(c.largest > 0); };
  if (const std::string names = namesOf(channels, isBlack); !names.empty())
    warnings.push_back("No reflectance above 0 in " + names + ": left black.");
  // Noise leaves a few; more of them mean that something was subtracted wrongly.
  if (double(table.clampedCount()) > noticeableShare * 3 * double(table.validCount()))
    warnings.push_back(std::to_string(table.clampedCount()) + " values below 0 are treated as 0 in the fit.");
  const auto isConstant = [&](const ChannelCensus& c) { return !isBlack(c) && c.smallest == c.largest; };
  if (const std::string names = namesOf(channels, isConstant); !names.empty() && census.used > 1)
    warnings.push_back("The same value in every cell of " + names +
                       ": a diffuse term explains it, the parameters of the highlight stay at their defaults.");
  // In a measurement the mirror peak, the heaviest cell, weighs some thousandths.
  const auto isSpike = [&](const ChannelCensus& c) { return c.heaviest > 0.5 * c.total && census.used > 1; };
  if (const std::string names = namesOf(channels, isSpike); !names.empty())
    warnings.push_back("One cell holds more than half of what is reflected in " + names +
                       ": the fit may follow an outlier.");
  return warnings;
}

}  // namespace gonio::fitting
