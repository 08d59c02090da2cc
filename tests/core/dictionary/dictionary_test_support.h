// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/mode_products.h"
#include "core/dictionary/signals.h"
#include "core/dictionary/training_materials.h"
#include "core/factorization/tensor.h"
#include "tests/support/function_brdf.h"
#include "tests/support/linear_oracles.h"

namespace gonio::dictionary::test_support {

inline Eigen::MatrixXd randomOrthonormal(int size, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd m = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
  return test::orthonormalised(m);
}

inline ModeMatrices<double> randomDictionary(const Sizes& sizes, std::mt19937_64& random) {
  return {randomOrthonormal(sizes[0], random), randomOrthonormal(sizes[1], random),
          randomOrthonormal(sizes[2], random)};
}

inline factorization::Tensor tensorOf(const double* block, const Sizes& sizes) {
  factorization::Tensor tensor({sizes[0], sizes[1], sizes[2]});
  std::copy(block, block + tensor.count(), tensor.data());
  return tensor;
}

/// S x_0 U_0 x_1 U_1 x_2 U_2 by the general tensor products.
inline factorization::Tensor composed(factorization::Tensor coefficients, const ModeMatrices<double>& matrices) {
  for (int mode = 0; mode < 3; ++mode)
    coefficients = factorization::modeProduct(coefficients, matrices[std::size_t(mode)], mode);
  return coefficients;
}

/// Signals of `sparsity` random coefficients over random dictionaries, one a column.
inline Matrix<double> plantedSignals(const Sizes& sizes, const std::vector<ModeMatrices<double>>& dictionaries,
                                     int sparsity, int signals, std::mt19937_64& random) {
  Matrix<double> result(Eigen::Index(count(sizes)), signals);
  std::normal_distribution<double> normal;
  for (int s = 0; s < signals; ++s) {
    factorization::Tensor coefficients({sizes[0], sizes[1], sizes[2]});
    for (int t = 0; t < sparsity; ++t) coefficients[std::size_t(random() % coefficients.count())] = 1 + normal(random);
    const factorization::Tensor signal = composed(coefficients, dictionaries[std::size_t(s) % dictionaries.size()]);
    result.col(s) = Eigen::Map<const Eigen::VectorXd>(signal.data(), result.rows());
  }
  return result;
}

inline constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 12, .thetaDCount = 12, .phiDCount = 16};

/// The product of the cell scaling of its three nodes.
inline double cellScalingOf(const HalfDifferenceGrid& grid, const GridGeometry& geometry, std::size_t cell) {
  const std::size_t n0 = std::size_t(grid.phiDCount), n1 = std::size_t(grid.thetaDCount);
  return geometry.cellScaling[0][Eigen::Index(cell % n0)] * geometry.cellScaling[1][Eigen::Index(cell / n0 % n1)] *
         geometry.cellScaling[2][Eigen::Index(cell / (n0 * n1))];
}

inline Ensemble randomEnsemble(int dictionaries, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  Ensemble ensemble{.grid = smallGrid, .dictionaries = {}, .learnedFrom = {}};
  for (int d = 0; d < dictionaries; ++d)
    ensemble.dictionaries.push_back({randomDictionary(modeSizes(smallGrid), random), 10});
  return ensemble;
}

/// GGX materials of rising roughness over a small grid.
inline TrainingMaterials ggxMaterials(int materials) {
  TrainingMaterials result;
  result.grid = smallGrid;
  std::vector<std::shared_ptr<const TabulatedBrdf>> tables;
  for (int m = 0; m < materials; ++m) {
    const double x = double(m + 1) / (materials + 1);
    result.names.push_back("material " + std::to_string(m));
    tables.push_back(
        bakeTable(*test::ggx(Rgb(0.4 * x, 0.2, 0.5 - 0.3 * x), Rgb(x), 0.08 + 0.5 * x, 0.05 + 0.4 * x), smallGrid));
  }
  result.load = [tables](std::size_t m) { return tables[m]; };
  return result;
}

/// Over the whole circle of smallGrid. Differs in both orders of the directions, and is negative at grazing light in
/// red.
inline std::shared_ptr<const TabulatedBrdf> oneWayTable() {
  const test::FunctionBrdf oneWay(
      [](const Direction& wi, const Direction& wo) {
        const double along = wi.x * wo.x + wi.y * wo.y;
        return Rgb(0.3 * wi.z - 0.2, 0.2 + 0.4 * wo.z * wo.z + 0.1 * along, 3 * std::exp(-4 * wi.z) + 0.05 * wo.z);
      },
      true, false);
  return bakeTable(oneWay, smallGrid.wholeCircle(), {}, 1, NegativeValues::stay);
}

}  // namespace gonio::dictionary::test_support
