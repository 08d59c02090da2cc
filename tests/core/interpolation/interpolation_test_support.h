// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <random>

#include "core/interpolation/interpolation.h"
#include "core/models/registry.h"
#include "tests/core/dictionary/dictionary_test_support.h"

namespace gonio::editing::test_support {

using dictionary::test_support::smallGrid;
using Table = interpolation::Interpolation::Table;
inline constexpr std::array allSpaces{
    interpolation::InterpolationSpace::linear, interpolation::InterpolationSpace::parameters,
    interpolation::InterpolationSpace::differential, interpolation::InterpolationSpace::factors,
    interpolation::InterpolationSpace::dictionary};

/// GGX with noise that no model explains, and a few cells without data.
inline Table measured(double diffuse, double roughness, unsigned seed, const HalfDifferenceGrid& grid = smallGrid) {
  const auto clean = bakeTable(*test::ggx(Rgb(diffuse, 0.1, 0.2), Rgb(0.8), roughness, 0.3), grid);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> factor(0.8f, 1.2f);
  std::vector<TabulatedBrdf::Value> values(clean->values().begin(), clean->values().end());
  std::vector<std::uint8_t> valid(clean->valid().begin(), clean->valid().end());
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    values[cell] *= factor(random);
    if (random() % 50 == 0) valid[cell] = 0;
  }
  return std::make_shared<const TabulatedBrdf>(grid, std::move(values), std::move(valid));
}

inline interpolation::InterpolationOptions options() {
  interpolation::InterpolationOptions result;
  result.ensemble = std::make_shared<const dictionary::Ensemble>(dictionary::test_support::randomEnsemble(3));
  result.pdv.terms = 2;
  result.pdv.deviationNodes = {0, 0.05, 0.2, 0.6, 1.2, 2};
  result.preserveDetail = false;                 // the published form; tests of measured_detail_test.cpp switch it on
  result.model = &models::findModel("lambert");  // fits at once; what is reported of fits is tested with others
  return result;
}

inline std::vector<interpolation::InterpolationMaterial> endsOf(const std::vector<Table>& tables) {
  std::vector<interpolation::InterpolationMaterial> ends;
  for (const Table& table : tables) ends.push_back({.table = table});
  return ends;
}

/// Three of them, and weights: what the tests of every space start from.
class ThreeMaterials {
 protected:
  const std::vector<Table> tables_{measured(0.3, 0.2, 1), measured(0.1, 0.45, 2), measured(0.2, 0.3, 3)};
  const std::vector<interpolation::InterpolationMaterial> ends_ = endsOf(tables_);
  const std::vector<double> weights_{0.5, 0.2, 0.3};
};

/// Largest |a - b| / (1 + b) over cells valid in both, which must be all that are valid in either when `sameCells`.
inline double maxDifference(const TabulatedBrdf& a, const TabulatedBrdf& b, bool sameCells = true) {
  double largest = a.grid() == b.grid() ? 0 : 1e300;
  for (std::size_t cell = 0; cell < b.values().size(); ++cell) {
    if (sameCells && a.valid()[cell] != b.valid()[cell]) return 1e300;
    if (a.valid()[cell] == 0 || b.valid()[cell] == 0) continue;
    for (int c = 0; c < 3; ++c) {
      const double x = a.values()[cell][c], y = b.values()[cell][c];
      largest = std::max(largest, std::abs(x - y) / (1 + y));
    }
  }
  return largest;
}

/// The mixture as a picture computes it.
inline Table mixed(const interpolation::TransformedMixture& mixture, std::span<const double> weights) {
  const auto& first = mixture.tables[0];
  std::vector<TabulatedBrdf::Value> values(first.grid.size());
  std::vector<std::uint8_t> valid(first.grid.size(), 1);
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    if (first.grid.nodeAboveHorizon(cell)) {
      const DirectionPair pair = first.grid.directions(cell);
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * double(mixture.tables[i].values[cell][c]);
        values[cell][c] = float(inverseTransformed(mixture.transform, sum, cosineWeight(pair.wi.z, pair.wo.z)));
      }
    }
    for (std::size_t i = 0; i < weights.size(); ++i) valid[cell] &= mixture.tables[i].valid[cell];
  }
  return std::make_shared<const TabulatedBrdf>(first.grid, std::move(values), std::move(valid));
}

}  // namespace gonio::editing::test_support
