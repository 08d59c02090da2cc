// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_cells.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"

namespace gonio::fitting {

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

/// One patch of cells: picks the cell that stands for it and adds up their measure.
struct Patch {
  std::vector<std::size_t> cells;
  double measure = 0;

  void collect(const HalfDifferenceGrid& grid, const CellSelection& selection, int row, Range thetaD, Range phiD) {
    cells.clear();
    measure = 0;
    for (int j = thetaD.begin; j < thetaD.end; ++j) {
      const double cellMeasure = grid.cellMeasure(grid.index(row, j, 0));
      for (int k = phiD.begin; k < phiD.end; ++k) {
        const std::size_t cell = grid.index(row, j, k);
        if (!selection.isUsed[cell]) continue;
        cells.push_back(cell);
        measure += cellMeasure;
      }
    }
  }
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
  constexpr std::size_t block = 4096;
  const std::size_t size = table.grid().size();
  CellSelection selection;
  selection.isUsed.assign(size, 0);
  std::vector<std::size_t> used((size + block - 1) / block, 0);
  // Angles cost more than cosines: they decide only what rounding could turn.
  constexpr double rounding = 1e-9;
  const double minCosine = std::cos(maxPolarAngle);
  const GridDirections directions(table.grid());
  const auto isWithin = [&](std::size_t cell) {
    const DirectionPair pair = directions.at(cell).pair;
    const double excess = std::min(pair.wi.z, pair.wo.z) - minCosine;
    return std::abs(excess) > rounding ? excess > 0 : table.grid().nodeWithin(cell, maxPolarAngle);
  };
  parallelForBlocks(size, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      if (!table.valid()[cell] || !isWithin(cell)) continue;
      selection.isUsed[cell] = 1;
      ++used[begin / block];
    }
  });
  for (const std::size_t count : used) selection.used += count;
  selection.invalid = size - table.validCount();
  selection.grazing = table.validCount() - selection.used;
  return selection;
}

FitCells stratifiedCells(const TabulatedBrdf& table, const CellSelection& selection, int thetaDStrata, int phiDStrata) {
  const HalfDifferenceGrid& grid = table.grid();
  const int strataD = std::min(thetaDStrata, grid.thetaDCount), strataF = std::min(phiDStrata, grid.phiDCount);
  FitCells result;
  Patch patch;
  for (int i = 0; i < grid.thetaHCount; ++i)
    for (int d = 0; d < strataD; ++d)
      for (int f = 0; f < strataF; ++f) {
        patch.collect(grid, selection, i, stratum(d, strataD, grid.thetaDCount), stratum(f, strataF, grid.phiDCount));
        if (!(patch.measure > 0)) continue;
        const std::uint64_t seed = (std::uint64_t(i) * std::uint64_t(strataD) + std::uint64_t(d)) * strataF + f;
        const std::size_t cell = patch.cells[scramble(seed) % patch.cells.size()];
        result.append(grid.directions(cell), Rgb(table.values()[cell]), patch.measure);
      }
  result.normaliseWeights();
  return result;
}

}  // namespace gonio::fitting
