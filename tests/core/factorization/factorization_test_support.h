// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <random>

#include "core/factorization/tensor.h"

/// What the tests of the factorisations share.
namespace gonio::factorization::test_support {

/// Entries of both signs, or positive ones.
inline Eigen::MatrixXd randomMatrix(int rows, int columns, unsigned seed, bool positive = false) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(positive ? 0.1 : -1, 1);
  Eigen::MatrixXd result(rows, columns);
  for (double& value : result.reshaped()) value = uniform(generator);
  return result;
}

inline factorization::Tensor randomTensor(const std::vector<int>& sizes, unsigned seed) {
  int rest = 1;
  for (std::size_t mode = 1; mode < sizes.size(); ++mode) rest *= sizes[mode];
  return factorization::fold(randomMatrix(sizes[0], rest, seed), 0, sizes);
}

/// |a - b| / |b|.
inline double relativeDifference(const factorization::Tensor& a, const factorization::Tensor& b) {
  factorization::Tensor difference = a;
  for (std::size_t i = 0; i < a.count(); ++i) difference[i] -= b[i];
  return difference.norm() / b.norm();
}

}  // namespace gonio::factorization::test_support
