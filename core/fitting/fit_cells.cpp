// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_cells.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/math/sampling.h"
#include "core/math/types.h"

namespace gonio::fitting {

namespace {

constexpr std::size_t block = 4096;

struct Place {
  DirectionPair pair;
  double measure = 0;
  bool aboveHorizon = false;
};

Place placeIn(const AzimuthStrata& strata, std::size_t stratum) {
  constexpr std::uint32_t thetaSeed = 1, phiSeed = 2;
  std::size_t rest = stratum;
  const auto next = [&rest](int count) {
    const std::size_t index = rest % std::size_t(count);
    rest /= std::size_t(count);
    return double(index);
  };
  const glm::dvec2 theta = scrambledSobol(std::uint32_t(stratum), thetaSeed);
  const glm::dvec2 phi = scrambledSobol(std::uint32_t(stratum), phiSeed);
  const double phiH = (next(strata.phiH) + phi.x) / strata.phiH * 2 * pi;
  const double phiD = (next(strata.phiD) + phi.y) / strata.phiD * pi;
  const double thetaD = (next(strata.thetaD) + theta.x) / strata.thetaD * halfPi;
  const double root = (next(strata.thetaH) + theta.y) / strata.thetaH, thetaH = root * root * halfPi;
  Place place;
  place.aboveHorizon = isAboveHorizon(thetaH, thetaD, phiD);
  place.pair = AzimuthRotation(phiH)(fromHalfDifference(thetaH, thetaD, phiD));
  // d wi d wo = 4 cos theta_d d omega_h d omega_d, and d theta_h is proportional to the root.
  place.measure = 4 * std::cos(thetaD) * std::sin(thetaH) * root * std::sin(thetaD);
  return place;
}

/// The mean over both orders; `measured`: whether either was.
void evaluateBothOrders(const Brdf& brdf, std::span<const Place> places, std::span<Rgb> values,
                        std::span<std::uint8_t> measured) {
  std::vector<DirectionPair> pairs;
  for (const Place& place : places) pairs.push_back(place.pair);
  brdf.evaluate(pairs, values);
  std::vector<DirectionPair> exchanged;
  for (const DirectionPair& pair : pairs) exchanged.push_back({pair.wo, pair.wi});
  std::vector<Rgb> others(values.begin(), values.end());
  if (!brdf.isReciprocal()) brdf.evaluate(exchanged, others);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool first = brdf.hasData(pairs[i]), second = brdf.hasData(exchanged[i]);
    measured[i] = first || second;
    if (first && second)
      values[i] = 0.5 * (values[i] + others[i]);
    else if (second)
      values[i] = others[i];
  }
}

}  // namespace

FitCells azimuthCells(const Brdf& brdf, double maxPolarAngle, const AzimuthStrata& strata, AzimuthCellCounts& counts) {
  const std::size_t count =
      std::size_t(strata.thetaH) * std::size_t(strata.thetaD) * std::size_t(strata.phiD) * std::size_t(strata.phiH);
  std::vector<Place> places(count);
  std::vector<Rgb> values(count);
  std::vector<std::uint8_t> measured(count);
  parallelForBlocks(count, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) places[i] = placeIn(strata, i);
    evaluateBothOrders(brdf, std::span(places).subspan(begin, end - begin),
                       std::span(values).subspan(begin, end - begin), std::span(measured).subspan(begin, end - begin));
  });
  const double minCosine = std::cos(maxPolarAngle);
  counts = {};
  FitCells cells;
  cells.symmetry = DataSymmetry::anisotropic;
  for (std::size_t i = 0; i < count; ++i) {
    if (!places[i].aboveHorizon || !measured[i]) {
      ++counts.invalid;
    } else if (std::min(places[i].pair.wi.z, places[i].pair.wo.z) < minCosine) {
      ++counts.grazing;
    } else {
      ++counts.used;
      for (int channel = 0; channel < 3; ++channel) counts.negative += values[i][channel] < 0;
      cells.append(places[i].pair, glm::max(values[i], Rgb(0)), places[i].measure);
    }
  }
  cells.normaliseWeights();
  return cells;
}

namespace {

/// Scrambles an index (the finaliser of SplitMix64, Steele et al. 2014): cells are picked without a visible pattern.
std::uint64_t scramble(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

struct Range {
  int begin, end;
};
Range stratum(int index, int strata, int count) { return {index * count / strata, (index + 1) * count / strata}; }

/// The cell that stands for a patch, and the measure of all used cells of the patch; 0 if there is none.
struct Representative {
  std::size_t cell;
  double measure;
};

/// The patches of one theta_h row, which share their numbers.
class RowOfPatches {
 public:
  RowOfPatches(const HalfDifferenceGrid& grid, const CellSelection& selection, int row)
      : grid_(grid), selection_(selection), row_(row) {
    for (int j = 0; j < grid.thetaDCount; ++j) measures_.push_back(grid.cellMeasure(grid.index(row, j, 0)));
  }

  Representative representative(Range thetaD, Range phiD, std::uint64_t seed) {
    cells_.clear();
    double measure = 0;
    for (int j = thetaD.begin; j < thetaD.end; ++j)
      for (int k = phiD.begin; k < phiD.end; ++k) {
        const std::size_t cell = grid_.index(row_, j, k);
        if (!selection_.isUsed[cell]) continue;
        cells_.push_back(cell);
        measure += measures_[std::size_t(j)];
      }
    return cells_.empty() ? Representative{0, 0} : Representative{cells_[scramble(seed) % cells_.size()], measure};
  }

 private:
  const HalfDifferenceGrid& grid_;
  const CellSelection& selection_;
  int row_;
  std::vector<double> measures_;  ///< of a cell, by theta_d
  std::vector<std::size_t> cells_;
};

}  // namespace

void FitCells::append(const DirectionPair& pair, const Rgb& value, double weight) {
  pairs.push_back(pair);
  cosI.push_back(std::max(0.0, pair.wi.z));
  cosO.push_back(std::max(0.0, pair.wo.z));
  rootWeight.push_back(weight);
  for (int channel = 0; channel < 3; ++channel) values[std::size_t(channel)].push_back(value[channel]);
}

void FitCells::normaliseWeights() {
  double total = 0;
  for (const double weight : rootWeight) total += weight;
  for (double& weight : rootWeight) weight = std::sqrt(weight / total);
}

CellSelection selectCells(const TabulatedBrdf& table, double maxPolarAngle) {
  const HalfDifferenceGrid& grid = table.grid();
  // Angles cost more than cosines: they decide only what rounding could turn.
  constexpr double rounding = 1e-9;
  const double minCosine = std::cos(maxPolarAngle);
  std::vector<double> cosPhiD;
  cosPhiD.reserve(std::size_t(grid.phiDCount));
  for (int k = 0; k < grid.phiDCount; ++k) cosPhiD.push_back(std::abs(std::cos(grid.node(grid.index(0, 0, k)).phiD)));
  CellSelection selection;
  selection.isUsed.assign(grid.size(), 0);
  std::vector<std::size_t> used(std::size_t(grid.thetaHCount), 0);
  parallelForBlocks(used.size(), 1, [&](std::size_t i, std::size_t) {
    for (int j = 0; j < grid.thetaDCount; ++j) {
      std::size_t cell = grid.index(int(i), j, 0);
      const HalfDifference node = grid.node(cell);
      // The smaller cosine of the two polar angles is both - apart |cos phi_d|.
      const double both = std::cos(node.thetaH) * std::cos(node.thetaD),
                   apart = std::sin(node.thetaH) * std::sin(node.thetaD);
      for (int k = 0; k < grid.phiDCount; ++k, ++cell) {
        if (!table.valid()[cell]) continue;
        const double excess = both - apart * cosPhiD[std::size_t(k)] - minCosine;
        const bool isWithin = std::abs(excess) > rounding ? excess > 0 : grid.nodeWithin(cell, maxPolarAngle);
        selection.isUsed[cell] = isWithin ? 1 : 0;
        used[i] += selection.isUsed[cell];
      }
    }
  });
  for (const std::size_t count : used) selection.used += count;
  selection.invalid = grid.size() - table.validCount();
  selection.grazing = table.validCount() - selection.used;
  return selection;
}

FitCells stratifiedCells(const TabulatedBrdf& table, const CellSelection& selection, int thetaDStrata, int phiDStrata) {
  const HalfDifferenceGrid& grid = table.grid();
  const int strataD = std::min(thetaDStrata, grid.thetaDCount), strataF = std::min(phiDStrata, grid.phiDCount);
  std::vector<std::vector<Representative>> rows(std::size_t(grid.thetaHCount));
  parallelForBlocks(rows.size(), 1, [&](std::size_t i, std::size_t) {
    RowOfPatches row(grid, selection, int(i));
    for (int d = 0; d < strataD; ++d)
      for (int f = 0; f < strataF; ++f) {
        const std::uint64_t seed = (std::uint64_t(i) * std::uint64_t(strataD) + std::uint64_t(d)) * strataF + f;
        const Representative found =
            row.representative(stratum(d, strataD, grid.thetaDCount), stratum(f, strataF, grid.phiDCount), seed);
        if (found.measure > 0) rows[i].push_back(found);
      }
  });
  const GridDirections directions(grid);
  FitCells result;
  for (const std::vector<Representative>& row : rows)
    for (const Representative& r : row)
      result.append(directions.at(r.cell).pair, glm::max(Rgb(0), Rgb(table.values()[r.cell])), r.measure);
  result.normaliseWeights();
  return result;
}

}  // namespace gonio::fitting
