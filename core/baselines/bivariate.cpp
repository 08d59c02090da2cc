// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/bivariate.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/brdf.h"
#include "core/math/parallel.h"

namespace gonio::baselines {

namespace {

/// Azimuths of the mean; folded by reciprocity the table repeats behind them.
constexpr int averagedAzimuths = 180;

HalfDifferenceGrid gridOf(int side) { return {.thetaHCount = side, .thetaDCount = side, .phiDCount = 1}; }

/// Mean over the measured azimuths at a node; false without any.
bool average(const TabulatedBrdf& table, const HalfDifference& node, glm::vec3& value) {
  Rgb sum(0);
  double count = 0;
  for (int k = 0; k < averagedAzimuths; ++k) {
    HalfDifference at = node;
    at.phiD = pi * k / averagedAzimuths;
    if (!isAboveHorizon(at.thetaH, at.thetaD, at.phiD)) continue;
    bool measured = false;
    const Rgb rho = table.lookup(at, TableLookup::trilinear, &measured);
    if (!measured) continue;
    sum += rho;
    ++count;
  }
  if (count > 0) value = glm::vec3(sum / count);
  return count > 0;
}

Rgb valueAt(const BivariateTable& table, const HalfDifferenceGrid& grid, const HalfDifference& at) {
  const HalfDifferenceGrid::Position position = grid.position(at);
  const double last = table.side - 1;
  const double x = std::min(position.thetaH, last), y = std::min(position.thetaD, last);
  const int i = std::min(int(x), table.side - 2), j = std::min(int(y), table.side - 2);
  const double s = x - i, t = y - j;
  const auto node = [&](int h, int d) { return Rgb(table.values[grid.index(h, d, 0)]); };
  return (1 - s) * ((1 - t) * node(i, j) + t * node(i, j + 1)) +
         s * ((1 - t) * node(i + 1, j) + t * node(i + 1, j + 1));
}

}  // namespace

int bivariateSide(std::size_t byteBudget) {
  return std::clamp(int(std::sqrt(double(byteBudget) / (3 * sizeof(float)))), 2, 90);
}

BivariateTable averageBivariate(const TabulatedBrdf& table, int side, const TaskControl& control) {
  const HalfDifferenceGrid grid = gridOf(side);
  BivariateTable result{.side = side, .values = std::vector<glm::vec3>(grid.size(), glm::vec3(0))};
  std::vector<std::uint8_t> measured(grid.size(), 0);
  parallelForBlocks(
      grid.size(), std::size_t(side),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) measured[i] = average(table, grid.node(i), result.values[i]);
      },
      control);
  for (int j = 0; j < side; ++j)
    for (int i = 1; i < side; ++i)
      if (const std::size_t at = grid.index(i, j, 0); !measured[at])
        result.values[at] = result.values[grid.index(i - 1, j, 0)];
  return result;
}

std::shared_ptr<const Brdf> makeBivariateBrdf(BivariateTable table) {
  const HalfDifferenceGrid grid = gridOf(table.side);
  return makePairwiseBrdf([table = std::move(table), grid](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    return at.valid ? valueAt(table, grid, at) : Rgb(0);
  });
}

}  // namespace gonio::baselines
