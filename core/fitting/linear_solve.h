// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/fitting/metric_transform.h"

namespace gonio::fitting {

/// More linear parameters than any model has; their solver tries all active sets.
inline constexpr int maxLinearParameters = 4;
using LinearVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, maxLinearParameters, 1>;
using LinearMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, maxLinearParameters, maxLinearParameters>;

/// Minimises x^T N x / 2 - b^T x subject to 0 <= x <= upper by trying every active set: exact, O(3^n). `N` is
/// symmetric and positive semi-definite; a variable that it does not see (zero row) becomes 0.
LinearVector solveBounded(const LinearMatrix& normal, const LinearVector& rightSide, const LinearVector& upper);

/// One colour channel of a fit with the non-linear parameters fixed: the model is sum_j p_j basis_j.
struct ChannelProblem {
  MetricTransform metric;
  std::span<const double> factor;  ///< what the metric multiplies the reflectance by
  std::span<const double> rootWeight;
  std::span<const double> transformed;  ///< transform(measured factor)
  std::span<const double> startWeight;  ///< rootWeight slope(measured factor) factor
  std::span<const double> values;       ///< measured, 1/sr
  std::vector<std::span<const double>> bases;
  LinearVector upper;

  std::size_t size() const { return factor.size(); }
  double model(const LinearVector& p, std::size_t cell) const {
    double sum = 0;
    for (std::size_t j = 0; j < bases.size(); ++j) sum += p[Eigen::Index(j)] * bases[j][cell];
    return sum;
  }
};

struct ChannelSolution {
  LinearVector parameters;
  double cost = 0;                ///< sum of the squared residuals
  std::vector<double> residuals;  ///< rootWeight shape(transform(model) - transformed)
};

/// Non-negative least squares in the metric's own domain: Gauss-Newton steps, each an exact bounded linear problem
/// (for metrics without a transform the first is the answer), with step halving: the cost never rises.
/// @param guess where to start if that is better than the solution linearised at the measurement; may be empty.
ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess);

}  // namespace gonio::fitting
