// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/fitting/bounded_quadratic.h"
#include "core/fitting/metric_transform.h"

namespace gonio::fitting {

/// One colour channel of a fit with the non-linear parameters fixed: the model is sum_j p_j basis_j.
struct ChannelProblem {
  MetricTransform metric;
  std::span<const double> factor;  ///< what the metric multiplies the reflectance by
  std::span<const double> rootWeight;
  std::span<const double> transformed;  ///< transform(measured factor)
  std::span<const double> startWeight;  ///< rootWeight slope(measured factor) factor
  std::span<const double> values;       ///< measured, 1/sr
  std::vector<std::span<const double>> bases;
  LinearVector lower, upper;
  double costTolerance = 1e-13;  ///< relative change of the cost at which it is solved

  std::size_t size() const { return factor.size(); }
  /// The model at all cells, 1/sr.
  std::vector<double> model(const LinearVector& p) const;
  /// The same at the cells from `begin` on, as many as `values` has.
  void evaluateModel(const LinearVector& p, std::size_t begin, std::span<double> values) const;
};

struct ChannelSolution {
  LinearVector parameters;
  double cost = 0;                  ///< sum of the squared residuals
  std::vector<double> model;        ///< at the cells, 1/sr
  std::vector<double> differences;  ///< transform(model factor) - transformed
  std::vector<double> residuals;    ///< rootWeight shape(difference)
};

/// Bounded least squares in the metric's own domain: Gauss-Newton steps, each an exact bounded linear problem
/// (for metrics without a transform the first is the answer), with step halving: the cost never rises.
/// @param guess where to start if that is better than the solution linearised at the measurement; may be empty.
ChannelSolution solveLinearParameters(const ChannelProblem& problem, const LinearVector& guess);

}  // namespace gonio::fitting
