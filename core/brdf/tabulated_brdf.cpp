// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_brdf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/brdf/value_bound.h"
#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_difference_grid.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio {

namespace {

constexpr std::size_t noCell = std::size_t(-1);

std::string cellName(const HalfDifferenceGrid& grid, std::size_t index) {
  const auto phi = std::size_t(grid.phiDCount), td = std::size_t(grid.thetaDCount);
  return "cell (theta_h " + std::to_string(index / (phi * td)) + ", theta_d " + std::to_string(index / phi % td) +
         ", phi_d " + std::to_string(index % phi) + ")";
}

/// The result of checking a block of cells.
struct Found {
  std::size_t validCount = 0, clampedCount = 0, firstBad = noCell;
};

/// Checks that the values of [begin, end) are finite, and sets those of invalid cells, and negative ones unless they
/// stay, to 0.
Found sanitize(std::span<TabulatedBrdf::Value> values, std::span<const std::uint8_t> valid, NegativeValues negatives,
               std::size_t begin, std::size_t end) {
  Found found;
  for (std::size_t i = begin; i < end; ++i) {
    TabulatedBrdf::Value& value = values[i];
    if (!valid[i]) {
      value = TabulatedBrdf::Value(0);
      continue;
    }
    ++found.validCount;
    // A sum of products with 0 is 0 but for infinities and NaN: one test for three channels.
    if (!(value.x * 0 + value.y * 0 + value.z * 0 == 0)) found.firstBad = std::min(found.firstBad, i);
    if (negatives == NegativeValues::stay) continue;
    for (int channel = 0; channel < 3; ++channel) {
      found.clampedCount += value[channel] < 0;
      value[channel] = value[channel] > 0 ? value[channel] : 0;
    }
  }
  return found;
}

Rgb mix(const Rgb& low, const Rgb& high, double weight) { return low + weight * (high - low); }

}  // namespace

TabulatedBrdf::TabulatedBrdf(const HalfDifferenceGrid& grid, std::vector<Value> values, std::vector<std::uint8_t> valid,
                             NegativeValues negatives)
    : grid_(grid), values_(std::move(values)), valid_(std::move(valid)) {
  if (values_.size() != grid_.size() || valid_.size() != grid_.size())
    throw Error("found " + std::to_string(values_.size()) + " values and " + std::to_string(valid_.size()) +
                " validity flags, expected one of each for the " + std::to_string(grid_.size()) + " cells of the grid");
  constexpr std::size_t block = 1 << 15;
  std::vector<Found> blocks((grid_.size() + block - 1) / block);
  parallelForBlocks(grid_.size(), block, [&](std::size_t begin, std::size_t end) {
    blocks[begin / block] = sanitize(values_, valid_, negatives, begin, end);
  });
  std::size_t firstBad = noCell;
  for (const Found& found : blocks) {
    validCount_ += found.validCount;
    clampedCount_ += found.clampedCount;
    firstBad = std::min(firstBad, found.firstBad);
  }
  if (firstBad != noCell) throw Error(cellName(grid_, firstBad) + " has a value that is not a finite number");
  markInterior();
}

void TabulatedBrdf::markInterior() {
  const auto phiCount = std::size_t(grid_.phiDCount), thetaDCount = std::size_t(grid_.thetaDCount);
  wordsPerRow_ = (phiCount + 63) / 64;
  interior_.assign(std::size_t(grid_.thetaHCount) * thetaDCount * wordsPerRow_, 0);
  parallelForBlocks(std::size_t(grid_.thetaHCount), 4, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> columns(phiCount + 1);
    for (std::size_t row = begin * thetaDCount; row < end * thetaDCount; ++row) {
      const std::size_t aboveH = row / thetaDCount + 1 < std::size_t(grid_.thetaHCount) ? thetaDCount : 0;
      const std::size_t aboveD = row % thetaDCount + 1 < thetaDCount ? 1 : 0;
      const std::uint8_t* r = valid_.data() + row * phiCount;
      const std::size_t d = aboveD * phiCount, h = aboveH * phiCount;
      for (std::size_t k = 0; k < phiCount; ++k) columns[k] = r[k] & r[k + d] & r[k + h] & r[k + d + h];
      columns[phiCount] = columns[0];
      std::uint64_t* interior = interior_.data() + row * wordsPerRow_;
      for (std::size_t k = 0; k < phiCount; ++k)
        interior[k / 64] |= std::uint64_t(columns[k] & columns[k + 1]) << (k % 64);
    }
  });
}

void TabulatedBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  evaluate(pairs, values, TableLookup::trilinear);
}

void TabulatedBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values, TableLookup mode,
                             std::span<std::uint8_t> measured) const {
  constexpr std::size_t capacity = HalfDifferenceBlock::capacity;
  HalfDifferenceBlock block;
  for (std::size_t begin = 0; begin < pairs.size(); begin += capacity) {
    const auto part = pairs.subspan(begin, std::min(capacity, pairs.size() - begin));
    const auto results = values.subspan(begin, part.size());
    const auto flags = measured.empty() ? measured : measured.subspan(begin, part.size());
    toHalfDifference(part, block);
    for (std::size_t i = 0; i < part.size(); ++i)
      if (isBelowHorizon(part[i].wi) || isBelowHorizon(part[i].wo)) block.valid[i] = 0;
    if (mode == TableLookup::trilinear) {
      lookupTrilinear(block, results, flags);
    } else {
      for (std::size_t i = 0; i < part.size(); ++i) {
        bool valid;
        results[i] = lookup({block.thetaH[i], block.thetaD[i], block.phiD[i], block.valid[i] != 0}, mode, &valid);
        if (!flags.empty()) flags[i] = valid;
      }
    }
  }
}

void TabulatedBrdf::lookupTrilinear(const HalfDifferenceBlock& block, std::span<Rgb> values,
                                    std::span<std::uint8_t> measured) const {
  HalfDifferenceGrid::Position positions[HalfDifferenceBlock::capacity];
  for (std::size_t i = 0; i < values.size(); ++i)
    positions[i] = grid_.position(block.thetaH[i], block.thetaD[i], block.phiD[i]);
  GridCorners corners[HalfDifferenceBlock::capacity];
  for (std::size_t i = 0; i < values.size(); ++i) {
    corners[i] = GridCorners(grid_, positions[i]);
    // The table is larger than the near caches: ask for all cells of the block before using the first.
    for (const std::size_t row : corners[i].rows) {
      const auto* low = reinterpret_cast<const char*>(values_.data() + row + std::size_t(corners[i].phiD.low));
      __builtin_prefetch(low);
      __builtin_prefetch(low + 2 * sizeof(Value) - 1);
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    bool valid = false;
    values[i] = block.valid[i] ? interpolate(corners[i], valid) : Rgb(0);
    if (!measured.empty()) measured[i] = valid;
  }
}

Rgb TabulatedBrdf::lookup(const HalfDifference& at, TableLookup mode, bool* valid) const {
  bool found = false;
  Rgb value(0);
  if (at.valid && mode == TableLookup::cell) {
    const std::size_t cell = grid_.cellIndex(at);
    found = valid_[cell] != 0;
    value = Rgb(values_[cell]);
  } else if (at.valid) {
    value = interpolate(GridCorners(grid_, grid_.position(at)), found);
  }
  if (valid) *valid = found;
  return value;
}

bool TabulatedBrdf::hasData(const DirectionPair& pair) const {
  bool valid = false;
  if (Brdf::hasData(pair)) lookup(toHalfDifference(pair.wi, pair.wo), TableLookup::trilinear, &valid);
  return valid;
}

namespace {

/// An interpolated value is a mean of the nodes about it, whatever phi_d.
class TableBound final : public ValueBound {
 public:
  explicit TableBound(const TabulatedBrdf& table)
      : grid_(table.grid()), extrema_(grid_.thetaHCount, grid_.thetaDCount) {
    std::size_t cell = 0;
    for (int i = 0; i < grid_.thetaHCount; ++i)
      for (int j = 0; j < grid_.thetaDCount; ++j)
        for (int k = 0; k < grid_.phiDCount; ++k, ++cell)
          // Where no node is valid the value is 0.
          extrema_.include(i, j, Rgb(table.values()[cell]));
  }

  RgbRange over(const PairBox& box) const override {
    const Range thetaD = box.thetaD();
    const auto low = grid_.position(box.thetaH.low, thetaD.low, 0),
               high = grid_.position(box.thetaH.high, thetaD.high, 0);
    return extrema_.over(NodeSpan({low.thetaH, high.thetaH}, grid_.thetaHCount),
                         NodeSpan({low.thetaD, high.thetaD}, grid_.thetaDCount));
  }

 private:
  HalfDifferenceGrid grid_;
  GridExtrema extrema_;
};

}  // namespace

std::shared_ptr<const ValueBound> TabulatedBrdf::valueBound() const {
  return std::make_shared<const TableBound>(*this);
}

bool TabulatedBrdf::isInterior(const GridCorners& at) const {
  const std::size_t row = std::size_t(at.thetaH.low) * std::size_t(grid_.thetaDCount) + std::size_t(at.thetaD.low);
  const auto column = std::size_t(at.phiD.low);
  return (interior_[row * wordsPerRow_ + column / 64] >> (column % 64) & 1) != 0;
}

Rgb TabulatedBrdf::interpolate(const GridCorners& at, bool& valid) const {
  valid = true;
  if (isInterior(at)) {
    const auto row = [&](int r) {
      return mix(Rgb(values_[at.cell(2 * r)]), Rgb(values_[at.cell(2 * r + 1)]), at.phiD.weight);
    };
    return mix(mix(row(0), row(1), at.thetaD.weight), mix(row(2), row(3), at.thetaD.weight), at.thetaH.weight);
  }
  Rgb sum(0);
  double weightSum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const std::size_t cell = at.cell(corner);
    const double weight = valid_[cell] ? at.weight(corner) : 0;
    sum += weight * Rgb(values_[cell]);
    weightSum += weight;
  }
  valid = weightSum > 0;
  return valid ? sum / weightSum : Rgb(0);
}

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
