// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/bake_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/brdf/tabulated_brdf.h"
#include "core/coordinates/grid_directions.h"
#include "core/math/parallel.h"
#include "core/math/types.h"

namespace gonio {

namespace {

constexpr std::size_t none = std::size_t(-1);

/// For each node the place of its value in `evaluated`.
struct Distinct {
  std::vector<DirectionPair> evaluated;
  std::vector<std::size_t> places;
};

Distinct distinctNodes(const HalfDifferenceGrid& grid, std::span<const std::size_t> nodes,
                       std::span<const DirectionPair> pairs) {
  const auto count = std::size_t(grid.phiDCount);
  Distinct result;
  result.evaluated.reserve(nodes.size());
  result.places.reserve(nodes.size());
  std::vector<std::size_t> placeOf(count, none);  // of the row's nodes
  std::size_t row = none;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] / count != row) std::ranges::fill(placeOf, none);
    row = nodes[i] / count;
    const std::size_t k = nodes[i] % count, mirrored = k == 0 ? 0 : count - k;
    placeOf[k] = placeOf[mirrored];
    if (placeOf[k] == none) {
      placeOf[k] = result.evaluated.size();
      result.evaluated.push_back(pairs[i]);
    }
    result.places.push_back(placeOf[k]);
  }
  return result;
}

}  // namespace

void evaluateNodes(const Brdf& brdf, const HalfDifferenceGrid& grid, std::span<const std::size_t> nodes,
                   std::span<const DirectionPair> pairs, std::span<Rgb> values, bool bothOrders) {
  // Folded to [0, pi), -phi_d is pi - phi_d with the directions exchanged.
  const bool orderMatters = grid.reciprocal && !bothOrders && !brdf.isReciprocal();
  if (!brdf.isMirrorSymmetric() || orderMatters) return brdf.evaluate(pairs, values);
  const Distinct distinct = distinctNodes(grid, nodes, pairs);
  std::vector<Rgb> evaluated(distinct.evaluated.size());
  brdf.evaluate(distinct.evaluated, evaluated);
  for (std::size_t i = 0; i < nodes.size(); ++i) values[i] = evaluated[distinct.places[i]];
}

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

/// Mean over rotations of both directions about the normal, and over both orders of the directions where `exchanged`.
std::vector<Rgb> evaluateMean(const Brdf& brdf, const HalfDifferenceGrid& grid, const Nodes& nodes, int rotations,
                              bool exchanged) {
  const std::vector<DirectionPair>& pairs = nodes.pairs;
  std::vector<Rgb> sums(pairs.size(), Rgb(0)), results(pairs.size());
  const auto add = [&](const std::vector<DirectionPair>& some) {
    evaluateNodes(brdf, grid, nodes.cells, some, results, exchanged);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += results[i];
  };
  for (int rotation = 0; rotation < rotations; ++rotation) {
    std::vector<DirectionPair> turned = pairs;
    if (rotation > 0) {
      const AzimuthRotation turn(2 * pi * rotation / rotations);
      for (DirectionPair& pair : turned) pair = turn(pair);
    }
    add(turned);
    if (!exchanged) continue;
    for (DirectionPair& pair : turned) std::swap(pair.wi, pair.wo);
    add(turned);
  }
  const double count = rotations * (exchanged ? 2 : 1);
  for (Rgb& sum : sums) sum /= count;
  return sums;
}

}  // namespace

std::shared_ptr<const TabulatedBrdf> bakeTable(const Brdf& brdf, const HalfDifferenceGrid& grid,
                                               const TaskControl& control, int azimuths, NegativeValues negatives) {
  std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(grid.size(), 0);
  const int rotations = brdf.isIsotropic() ? 1 : std::max(1, azimuths);
  const bool exchanged = grid.reciprocal && !brdf.isReciprocal();
  const GridDirections directions(grid);
  parallelForBlocks(
      grid.size(), block,
      [&](std::size_t begin, std::size_t end) {
        const Nodes nodes = nodesOfBlock(directions, begin, end);
        const std::vector<Rgb> means = evaluateMean(brdf, grid, nodes, rotations, exchanged);
        for (std::size_t i = 0; i < nodes.cells.size(); ++i) {
          values[nodes.cells[i]] = toFloat(means[i]);
          valid[nodes.cells[i]] = 1;
        }
      },
      control);
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid), negatives);
}

std::shared_ptr<const TabulatedBrdf> meanOfOrders(const std::shared_ptr<const TabulatedBrdf>& table) {
  const HalfDifferenceGrid& whole = table->grid();
  if (whole.reciprocal) return table;
  if (whole.phiDCount % 2 != 0) return bakeTable(*table, {whole.thetaHCount, whole.thetaDCount, whole.phiDCount});
  const HalfDifferenceGrid half{whole.thetaHCount, whole.thetaDCount, whole.phiDCount / 2};
  std::vector<TabulatedBrdf::Value> values(half.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(half.size(), 0);
  const auto count = std::size_t(half.phiDCount);
  parallelForBlocks(half.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      // Where one order has no data, the other stands for both.
      const std::size_t first = cell / count * 2 * count + cell % count, second = first + count;
      const int known = int(table->valid()[first] != 0) + int(table->valid()[second] != 0);
      if (known == 0) continue;
      values[cell] = toFloat((Rgb(table->values()[first]) + Rgb(table->values()[second])) / double(known));
      valid[cell] = 1;
    }
  });
  return std::make_shared<const TabulatedBrdf>(half, std::move(values), std::move(valid));
}

}  // namespace gonio
