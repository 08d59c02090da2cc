// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/nonnegative_matrix.h"

#include <cassert>
#include <cmath>
#include <random>

namespace gonio::factorization {

namespace {

/// Keeps 0 / 0 of a dead component at 0.
constexpr double smallestDenominator = 1e-300;

void fillPositive(Eigen::MatrixXd& matrix, double scale, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(0.1, 1);
  for (double& value : matrix.reshaped()) value = scale * uniform(generator);
}

void update(Eigen::MatrixXd& factor, const Eigen::MatrixXd& above, const Eigen::MatrixXd& below) {
  factor.array() *= above.array() / (below.array() + smallestDenominator);
}

}  // namespace

NonnegativeFactors factorizeNonnegative(const Eigen::MatrixXd& matrix, int rank, const NonnegativeOptions& options,
                                        const TaskControl& control) {
  assert(rank >= 1);
  const Eigen::MatrixXd y = matrix.cwiseMax(0.0);
  NonnegativeFactors f{
      .left = Eigen::MatrixXd(y.rows(), rank), .right = Eigen::MatrixXd(rank, y.cols()), .residuals = {}};
  std::mt19937_64 generator(options.seed);
  // So scaled the product starts near the data's mean.
  const double scale = std::sqrt(y.mean() / rank);
  fillPositive(f.left, scale, generator);
  fillPositive(f.right, scale, generator);
  const auto residual = [&] { return (y - f.left * f.right).norm(); };
  f.residuals.push_back(residual());
  for (int iteration = 0; iteration < options.maxIterations; ++iteration) {
    control.throwIfStopped();
    update(f.right, f.left.transpose() * y, f.left.transpose() * f.left * f.right);
    update(f.left, y * f.right.transpose(), f.left * (f.right * f.right.transpose()));
    const double before = f.residuals.back();
    f.residuals.push_back(residual());
    control.report(double(iteration + 1) / options.maxIterations);
    if (before - f.residuals.back() <= options.tolerance * before) break;
  }
  return f;
}

}  // namespace gonio::factorization
