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
      result.append(directions.at(r.cell).pair, Rgb(table.values()[r.cell]), r.measure);
  result.normaliseWeights();
  return result;
}

}  // namespace gonio::fitting
