// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/comparison_bounds.h"

#include <cmath>
#include <vector>

#include "core/brdf/brdf.h"
#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "core/math/monotone_cubic.h"
#include "core/math/parallel.h"

namespace gonio::study {

using namespace factorization;

namespace {

Direction mirrored(const Direction& w) { return {w.x, -w.y, w.z}; }

std::vector<double> evenNodes(int count, double last) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * i / (count - 1));
  return nodes;
}

/// ln(1 + rho) at the nodes, phi fastest; below 0 where there is none.
struct Nodes {
  std::vector<double> theta = evenNodes(90, maxPolarAngle), deviation, phi = evenNodes(180, pi);
  std::vector<Rgb> values;

  Rgb& at(std::size_t i, std::size_t j, std::size_t k) { return values[(i * deviation.size() + j) * phi.size() + k]; }
  const Rgb& at(std::size_t i, std::size_t j, std::size_t k) const {
    return values[(i * deviation.size() + j) * phi.size() + k];
  }
};

Rgb sample(const Brdf& symmetric, const ProjectedDeviation& node) {
  const ProjectedDirections at = fromProjectedDeviation(node);
  if (!at.valid || at.pair.wi.z < std::cos(maxPolarAngle) * (1 - 1e-9)) return Rgb(-1);
  const Rgb rho = symmetric.evaluate(at.pair.wi, at.pair.wo);
  return {std::log1p(rho.x), std::log1p(rho.y), std::log1p(rho.z)};
}

Rgb valueAt(const Nodes& nodes, const ProjectedDeviation& at) {
  const NodeInterval places[] = {findInterval(nodes.theta, at.thetaR), findInterval(nodes.deviation, at.deviation),
                                 findInterval(nodes.phi, std::abs(at.phi))};
  Rgb sum(0);
  double weights = 0;
  for (int corner = 0; corner < 8; ++corner) {
    std::size_t index[3];
    double weight = 1;
    for (int mode = 0; mode < 3; ++mode) {
      const bool next = corner >> mode & 1;
      index[mode] = places[mode].index + next;
      weight *= next ? places[mode].fraction : 1 - places[mode].fraction;
    }
    const Rgb& value = nodes.at(index[0], index[1], index[2]);
    if (value.x < 0) continue;
    sum += weight * value;
    weights += weight;
  }
  if (!(weights > 0)) return Rgb(0);
  sum /= weights;
  return {std::expm1(sum.x), std::expm1(sum.y), std::expm1(sum.z)};
}

}  // namespace

std::shared_ptr<const Brdf> symmetricMean(std::shared_ptr<const TabulatedBrdf> table) {
  return makePairwiseBrdf([table = std::move(table)](const Direction& wi, const Direction& wo) {
    return (table->evaluate(wi, wo) + table->evaluate(mirrored(wi), mirrored(wo))) / 2.0;
  });
}

std::shared_ptr<const Brdf> deviationGrid(const std::shared_ptr<const TabulatedBrdf>& table) {
  const auto symmetric = symmetricMean(table);
  Nodes nodes;
  nodes.deviation = deviationNodes(std::span(&table, 1));
  nodes.values.resize(nodes.theta.size() * nodes.deviation.size() * nodes.phi.size());
  parallelForBlocks(nodes.theta.size(), 1, [&](std::size_t i, std::size_t) {
    for (std::size_t j = 0; j < nodes.deviation.size(); ++j)
      for (std::size_t k = 0; k < nodes.phi.size(); ++k)
        nodes.at(i, j, k) = sample(*symmetric, {nodes.theta[i], nodes.deviation[j], nodes.phi[k]});
  });
  return makePairwiseBrdf([nodes = std::move(nodes)](const Direction& wi, const Direction& wo) {
    return valueAt(nodes, toProjectedDeviation(wi, wo));
  });
}

}  // namespace gonio::study
