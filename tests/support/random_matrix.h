// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <random>

namespace gonio::test {

/// Entries from the normal distribution; the same for the same seed.
inline Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd result(rows, columns);
  for (double& value : result.reshaped()) value = normal(generator);
  return result;
}

}  // namespace gonio::test
