// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_brdf.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio {

namespace {

constexpr std::size_t bakeBlock = 4096;

std::string cellName(const HalfDifferenceGrid& grid, std::size_t index) {
  const auto phi = std::size_t(grid.phiDCount), td = std::size_t(grid.thetaDCount);
  return "cell (theta_h " + std::to_string(index / (phi * td)) + ", theta_d " + std::to_string(index / phi % td) +
         ", phi_d " + std::to_string(index % phi) + ")";
}

/// The two neighbouring nodes on one axis and the weight of the upper one.
struct Bracket {
  int low, high;
  double weight;
};

Bracket clampedBracket(double x, int count) {
  if (!(x > 0)) return {0, 0, 0};
  if (x >= count - 1) return {count - 1, count - 1, 0};
  const int low = static_cast<int>(x);
  return {low, low + 1, x - low};
}

Bracket wrappedBracket(double x, int count) {
  const int low = std::min(static_cast<int>(x), count - 1);
  return {low, low + 1 == count ? 0 : low + 1, x - low};
}

}  // namespace

TabulatedBrdf::TabulatedBrdf(const HalfDifferenceGrid& grid, std::vector<Value> values,
                             std::vector<std::uint8_t> valid)
    : grid_(grid), values_(std::move(values)), valid_(std::move(valid)) {
  if (values_.size() != grid_.size() || valid_.size() != grid_.size())
    throw Error("table of " + std::to_string(values_.size()) + " values and " + std::to_string(valid_.size()) +
                " flags where the grid has " + std::to_string(grid_.size()) + " cells");
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (!valid_[i]) {
      values_[i] = Value(0);
      continue;
    }
    ++validCount_;
    for (int channel = 0; channel < 3; ++channel) {
      float& value = values_[i][channel];
      if (!std::isfinite(value))
        throw Error(cellName(grid_, i) + ", channel " + std::to_string(channel) + " is not a finite number");
      if (value < 0) ++clampedCount_;
      if (!(value > 0)) value = 0;
    }
  }
}

void TabulatedBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const {
  evaluate(pairs, values, TableLookup::trilinear);
}

void TabulatedBrdf::evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values, TableLookup mode) const {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    if (isBelowHorizon(wi) || isBelowHorizon(wo))
      values[i] = Rgb(0);
    else
      values[i] = lookup(toHalfDifference(wi, wo), mode);
  }
}

Rgb TabulatedBrdf::lookup(const HalfDifference& at, TableLookup mode, bool* valid) const {
  if (valid) *valid = false;
  if (!at.valid) return Rgb(0);
  if (mode == TableLookup::nearest) {
    const std::size_t cell = grid_.nearestIndex(at);
    if (valid) *valid = valid_[cell] != 0;
    return Rgb(values_[cell]);
  }
  const HalfDifferenceGrid::Position p = grid_.position(at);
  const Bracket h = clampedBracket(p.thetaH, grid_.thetaHCount);
  const Bracket d = clampedBracket(p.thetaD, grid_.thetaDCount);
  const Bracket f = wrappedBracket(p.phiD, grid_.phiDCount);
  Rgb sum(0);
  double weightSum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const bool upperH = corner & 4, upperD = corner & 2, upperF = corner & 1;
    const std::size_t cell =
        grid_.index(upperH ? h.high : h.low, upperD ? d.high : d.low, upperF ? f.high : f.low);
    const double weight = (upperH ? h.weight : 1 - h.weight) * (upperD ? d.weight : 1 - d.weight) *
                          (upperF ? f.weight : 1 - f.weight) * valid_[cell];
    sum += weight * Rgb(values_[cell]);
    weightSum += weight;
  }
  if (!(weightSum > 0)) return Rgb(0);
  if (valid) *valid = true;
  return sum / weightSum;
}

std::shared_ptr<const TabulatedBrdf> bakeTable(const Brdf& brdf, const HalfDifferenceGrid& grid,
                                               const TaskControl& control, int azimuths) {
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(grid.size(), 0);
  const int rotations = brdf.isIsotropic() ? 1 : std::max(1, azimuths);
  parallelForBlocks(
      grid.size(), bakeBlock,
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> cells;
        std::vector<DirectionPair> pairs;
        for (std::size_t cell = begin; cell < end; ++cell) {
          if (!grid.nodeAboveHorizon(cell)) continue;
          cells.push_back(cell);
          DirectionPair pair = grid.directions(cell);
          pair.wi.z = std::max(0.0, pair.wi.z);
          pair.wo.z = std::max(0.0, pair.wo.z);
          pairs.push_back(pair);
        }
        std::vector<Rgb> sums(pairs.size(), Rgb(0)), results(pairs.size());
        for (int rotation = 0; rotation < rotations; ++rotation) {
          const double angle = 2 * pi * rotation / rotations, c = std::cos(angle), s = std::sin(angle);
          std::vector<DirectionPair> rotated = pairs;
          if (rotation > 0)
            for (DirectionPair& pair : rotated)
              for (Direction* w : {&pair.wi, &pair.wo}) *w = {c * w->x - s * w->y, s * w->x + c * w->y, w->z};
          brdf.evaluate(rotated, results);
          for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += results[i];
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
          values[cells[i]] = TabulatedBrdf::Value(sums[i] / double(rotations));
          valid[cells[i]] = 1;
        }
      },
      control);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

}  // namespace gonio
