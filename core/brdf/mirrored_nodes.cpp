// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/mirrored_nodes.h"

#include <algorithm>

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

}  // namespace gonio
