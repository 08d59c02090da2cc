// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/fitting/bounded_quadratic.h"
#include "core/fitting/metric_transform.h"

namespace gonio::fitting {

/// The fit of one colour channel for fixed non-linear parameters: the model is sum_j p_j basis_j.
struct ChannelProblem {
  MetricTransform metric;
  std::span<const double> factor;  ///< factor of the metric per BRDF value
  std::span<const double> rootWeight;
  std::span<const double> transformed;  ///< transform(measured * factor)
  std::span<const double> startWeight;  ///< rootWeight * slope(measured * factor) * factor
  std::span<const double> values;       ///< measured, 1/sr
  std::vector<std::span<const double>> bases;
  LinearVector lower, upper;
  double costTolerance = 1e-13;  ///< relative change of the cost at which iterations stop

  std::size_t size() const { return factor.size(); }
  /// The model in all cells, 1/sr.
  std::vector<double> model(const LinearVector& p) const;
  /// The model in values.size() cells from `begin` on.
  void evaluateModel(const LinearVector& p, std::size_t begin, std::span<double> values) const;
};

struct ChannelSolution {
  LinearVector parameters;
  double cost = 0;                  ///< sum of squared residuals
  std::vector<double> model;        ///< in the cells, 1/sr
  std::vector<double> differences;  ///< transform(model * factor) - transformed
  std::vector<double> residuals;    ///< rootWeight * shape(difference)
};

/// Bounded least squares in the metric's own domain by Gauss-Newton steps, each an exact bounded linear problem, with
/// step halving, so that the cost never rises. For metrics without a transform the first step is the solution.
/// @param guess a start, used if it is better than the solution linearised at the measurement; may be empty.
ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess);

}  // namespace gonio::fitting
