// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/fitting/fit_cells.h"
#include "core/math/parallel.h"

namespace gonio::fitting {

namespace {

constexpr double noticeableFraction = 0.01;

/// One channel over the cells that count.
struct ChannelCensus {
  double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
  double total = 0, heaviest = 0;  ///< of value times measure of the cell

  void add(double value, double measure) {
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
    total += value * measure;
    heaviest = std::max(heaviest, value * measure);
  }
  void add(const ChannelCensus& other) {
    smallest = std::min(smallest, other.smallest);
    largest = std::max(largest, other.largest);
    total += other.total;
    heaviest = std::max(heaviest, other.heaviest);
  }
};

using Channels = std::array<ChannelCensus, 3>;

Channels takeChannelCensus(const TabulatedBrdf& table, const CellSelection& selection) {
  const HalfDifferenceGrid& grid = table.grid();
  const auto rowLength = std::size_t(grid.phiDCount);  // of cells with one measure
  std::vector<Channels> slabs(std::size_t(grid.thetaHCount));
  const std::size_t slabLength = selection.isUsed.size() / slabs.size();
  parallelForBlocks(slabs.size(), 1, [&](std::size_t slab, std::size_t) {
    double measure = 0;
    for (std::size_t cell = slab * slabLength; cell < (slab + 1) * slabLength; ++cell) {
      if (cell % rowLength == 0) measure = grid.cellMeasure(cell);
      if (!selection.isUsed[cell]) continue;
      for (int c = 0; c < 3; ++c) slabs[slab][std::size_t(c)].add(std::max(0.0f, table.values()[cell][c]), measure);
    }
  });
  Channels channels;
  for (const Channels& slab : slabs)
    for (std::size_t c = 0; c < channels.size(); ++c) channels[c].add(slab[c]);
  return channels;
}

template <typename Predicate>
std::string namesOf(const Channels& channels, Predicate matches) {
  std::string names;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (matches(channels[c])) names += (names.empty() ? "" : ", ") + std::string(channelNames[c]);
  return names;
}

/// Messages for the user about problems that make a fit to these cells doubtful: no cells or few, black channels, many
/// negative values, one cell that outweighs all others. Usually empty.
/// @param used cells; @param negative channels below 0, of `valid` cells.
std::vector<std::string> warningsOf(const Channels& channels, std::size_t used, std::size_t negative,
                                    std::size_t valid) {
  if (used == 0) return {"The measurement has no valid cell within the maximum polar angle: nothing was fitted."};
  std::vector<std::string> warnings;
  const auto isBlack = [](const ChannelCensus& c) { return !(c.largest > 0); };
  if (const std::string names = namesOf(channels, isBlack); !names.empty())
    warnings.push_back("No BRDF value above 0 in " + names + ": fitted as black.");
  // Noise leaves a few; more of them mean that something was subtracted wrongly.
  if (double(negative) > noticeableFraction * 3 * double(valid))
    warnings.push_back(std::to_string(std::lround(100 * double(negative) / double(3 * valid))) +
                       " % of the measured values are below 0; the fit treats them as 0.");
  if (used < fewCells)
    warnings.push_back("Only " + std::to_string(used) + (used == 1 ? " cell is" : " cells are") +
                       " valid within the maximum polar angle: other parameters explain the measurement as well.");
  // In a measurement the mirror peak, the heaviest cell, weighs some thousandths.
  const auto isSpike = [&](const ChannelCensus& c) { return c.heaviest > 0.5 * c.total && used > 1; };
  if (const std::string names = namesOf(channels, isSpike); !names.empty())
    warnings.push_back("One cell contains more than half of the reflected light in " + names +
                       ": the fit may follow an outlier.");
  return warnings;
}

Channels takeChannelCensus(const FitCells& cells) {
  Channels channels;
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (std::size_t i = 0; i < cells.size(); ++i)
      channels[c].add(cells.values[c][i], cells.rootWeight[i] * cells.rootWeight[i]);
  return channels;
}

/// Number of channel values of a table that were below 0.
std::size_t negativeValues(const TabulatedBrdf& table) {
  std::size_t negative = table.clampedCount();
  for (const TabulatedBrdf::Value& value : table.values())
    for (int c = 0; c < 3; ++c) negative += value[c] < 0;
  return negative;
}

/// Patches of a theta_h row.
struct Strata {
  int thetaD, phiD;
};
constexpr Strata searchStrata{8, 5}, fineStrata{18, 18}, coarseStrata{14, 10};
/// Of anisotropic data: about half of the strata count, the others reach below the horizon.
constexpr AzimuthStrata searchAzimuths{60, 4, 3, 10}, fineAzimuths{90, 6, 6, 16}, coarseAzimuths{90, 5, 4, 12},
    allAzimuths{90, 10, 9, 24};
constexpr std::size_t fewParameters = 3;
constexpr double searchTolerance = 1e-7, polishTolerance = 1e-13;

/// What is fitted as a table but is none.
std::shared_ptr<const TabulatedBrdf> tableOf(const Brdf& base) {
  return formOf<TabulatedBrdf>(base) || !base.isIsotropic() ? nullptr : bakeTable(base);
}

}  // namespace

FitData::FitData(const Brdf& base, const Brdf& measurement, const FitOptions& options)
    : base_(base),
      measurement_(measurement),
      options_(options),
      baked_(tableOf(base)),
      table_(baked_ ? baked_.get() : formOf<TabulatedBrdf>(base)) {
  Channels channels;
  if (table_) {
    selection_ = selectCells(*table_, options.maxPolarAngle);
    channels = takeChannelCensus(*table_, selection_);
    warnings_ = warningsOf(channels, selection_.used, negativeValues(*table_), table_->validCount());
  } else {
    const FitCells cells = azimuthCells(base, options.maxPolarAngle, allAzimuths, azimuths_);
    channels = takeChannelCensus(cells);
    warnings_ = warningsOf(channels, cells.size(), azimuths_.negative, cells.size());
  }
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (usedCells() > 1 && channels[c].largest > 0 && channels[c].smallest == channels[c].largest)
      constants_[c] = channels[c].largest;
}

std::vector<double> FitData::errors(const Brdf& fitted) const {
  return measurement_.errors(fitted, options_.maxPolarAngle, options_.gamma);
}

FitTarget FitData::makeTarget(Part part, double costTolerance) const {
  const MetricTransform metric(options_.metric, options_.gamma);
  if (table_) {
    const Strata strata = part == Part::search ? searchStrata : part == Part::fine ? fineStrata : coarseStrata;
    return {stratifiedCells(*table_, selection_, strata.thetaD, strata.phiD), metric, costTolerance};
  }
  AzimuthCellCounts counts;
  const AzimuthStrata strata = part == Part::search ? searchAzimuths
                               : part == Part::fine ? fineAzimuths
                                                    : coarseAzimuths;
  return {azimuthCells(base_, options_.maxPolarAngle, strata, counts), metric, costTolerance};
}

const FitTarget& FitData::search() const {
  if (!search_) search_ = makeTarget(Part::search, searchTolerance);
  return *search_;
}

const FitTarget& FitData::polish(std::size_t nonlinearParameters) const {
  const bool isFine = nonlinearParameters <= fewParameters;
  std::optional<FitTarget>& target = isFine ? fine_ : coarse_;
  if (!target) target = makeTarget(isFine ? Part::fine : Part::coarse, polishTolerance);
  return *target;
}

}  // namespace gonio::fitting
