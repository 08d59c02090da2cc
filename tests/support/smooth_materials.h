// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "core/dictionary/principal_components.h"

/// Materials over a small grid, for tests of what is learned from many.
namespace gonio::test {

inline constexpr HalfDifferenceGrid smoothGrid{.thetaHCount = 10, .thetaDCount = 8, .phiDCount = 6};

/// Some smooth material over the cells above the horizon, of a diffuse colour and a highlight.
inline std::shared_ptr<const TabulatedBrdf> smoothMaterial(unsigned seed, const HalfDifferenceGrid& grid = smoothGrid) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  // One at a time: compilers evaluate the arguments of a call in different orders.
  const double blue = uniform(generator), green = uniform(generator), red = uniform(generator);
  const double highlightGreen = uniform(generator), highlightRed = uniform(generator);
  const Rgb diffuse(red, green, blue), highlight(10 * highlightRed, 30 * highlightGreen, 5);
  const double width = 0.05 + uniform(generator), tint = uniform(generator);
  std::vector<TabulatedBrdf::Value> values(grid.size());
  std::vector<std::uint8_t> valid(grid.size());
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const HalfDifference at = grid.node(cell);
    valid[cell] = grid.nodeAboveHorizon(cell);
    values[cell] = TabulatedBrdf::Value(diffuse / pi * (1 + tint * std::cos(at.phiD)) +
                                        highlight * std::exp(-at.thetaH * at.thetaH / (width * width)) *
                                            (1 + std::pow(1 - std::cos(at.thetaD), 5)));
  }
  return std::make_shared<const TabulatedBrdf>(grid, values, valid);
}

/// Those of the seeds from 1.
inline std::vector<std::shared_ptr<const TabulatedBrdf>> smoothMaterials(unsigned count,
                                                                         const HalfDifferenceGrid& grid = smoothGrid) {
  std::vector<std::shared_ptr<const TabulatedBrdf>> result;
  for (unsigned seed = 1; seed <= count; ++seed) result.push_back(smoothMaterial(seed, grid));
  return result;
}

inline dictionary::PrincipalComponents learnFrom(const std::vector<std::shared_ptr<const TabulatedBrdf>>& tables,
                                                 const dictionary::PcaOptions& options = {}) {
  return dictionary::learnPrincipalComponents(
      tables.size(), [&](std::size_t i) { return tables[i]; }, options);
}

}  // namespace gonio::test
