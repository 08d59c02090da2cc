// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/brdf/tabulated_brdf.h"
#include "core/coordinates/azimuth_rotation.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"

namespace gonio {

namespace {

constexpr std::size_t block = 4096;

/// Finite values beyond the range of float become the largest float; infinities and NaN stay, to be refused.
TabulatedBrdf::Value toFloat(const Rgb& value) {
  constexpr double largest = std::numeric_limits<float>::max();
  TabulatedBrdf::Value result;
  for (int channel = 0; channel < 3; ++channel) {
    const double x = value[channel];
    result[channel] = static_cast<float>(std::isfinite(x) ? std::clamp(x, -largest, largest) : x);
  }
  return result;
}

/// The nodes of one block that lie above the horizon.
struct Nodes {
  std::vector<std::size_t> cells;
  std::vector<DirectionPair> pairs;
};

Nodes nodesOfBlock(const GridDirections& directions, std::size_t begin, std::size_t end) {
  Nodes nodes;
  nodes.cells.reserve(end - begin);
  nodes.pairs.reserve(end - begin);
  for (std::size_t cell = begin; cell < end; ++cell)
    if (const GridDirections::Node node = directions.at(cell); node.aboveHorizon) {
      nodes.cells.push_back(cell);
      nodes.pairs.push_back(node.pair);
    }
  return nodes;
}

/// Mean over rotations of both directions about the normal.
std::vector<Rgb> evaluateRotated(const Brdf& brdf, const std::vector<DirectionPair>& pairs, int rotations) {
  std::vector<Rgb> sums(pairs.size()), results(pairs.size());
  brdf.evaluate(pairs, sums);
  for (int rotation = 1; rotation < rotations; ++rotation) {
    const AzimuthRotation turn(2 * pi * rotation / rotations);
    std::vector<DirectionPair> rotated = pairs;
    for (DirectionPair& pair : rotated) pair = turn(pair);
    brdf.evaluate(rotated, results);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += results[i];
  }
  if (rotations > 1)
    for (Rgb& sum : sums) sum /= double(rotations);
  return sums;
}

}  // namespace

std::shared_ptr<const TabulatedBrdf> bakeTable(const Brdf& brdf, const HalfDifferenceGrid& grid,
                                               const TaskControl& control, int azimuths) {
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(grid.size(), 0);
  const int rotations = brdf.isIsotropic() ? 1 : std::max(1, azimuths);
  const GridDirections directions(grid);
  parallelForBlocks(
      grid.size(), block,
      [&](std::size_t begin, std::size_t end) {
        const Nodes nodes = nodesOfBlock(directions, begin, end);
        const std::vector<Rgb> means = evaluateRotated(brdf, nodes.pairs, rotations);
        for (std::size_t i = 0; i < nodes.cells.size(); ++i) {
          values[nodes.cells[i]] = toFloat(means[i]);
          valid[nodes.cells[i]] = 1;
        }
      },
      control);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

}  // namespace gonio
