// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "core/factorization/half_difference_samples.h"

namespace gonio::baselines {

/// A Gaussian process over half-difference coordinates (Rasmussen and Williams 2006, "Gaussian Processes for Machine
/// Learning"): the posterior mean of y = ln(1 + rho) in each channel,
///   y(x) = mean + sum_j weight_j k(|(x - x_j) / lengths|), k(r) = (1 + sqrt(3) r) exp(-sqrt(3) r) (Matern 3/2).
/// Reciprocal and symmetric about the plane of incidence.
struct GaussianProcess {
  using Points = Eigen::Matrix<float, 3, Eigen::Dynamic>;
  Points nodes;    ///< x_j divided by the lengths
  Points weights;  ///< rows are red, green and blue
  Eigen::Vector3f lengths, mean;

  std::size_t bytes() const { return (std::size_t(nodes.size() + weights.size()) + 6) * sizeof(float); }
};

inline constexpr int maxGaussianNodes = 512;
/// The largest number of nodes in [1, maxGaussianNodes] that fits in the budget.
int gaussianNodes(std::size_t byteBudget);

/// x: sqrt(2 theta_h / pi), 2 theta_d / pi, sin theta_h sin theta_d sin^2 phi_d. Continuous where phi_d is not defined.
Eigen::Vector3d gaussianPoint(const HalfDifference& at);

/// The axes that fitGaussianProcess() expects: 45 x 30 x 7 nodes.
factorization::HalfDifferenceAxes gaussianAxes();

/// Fits a process: lengths by the marginal likelihood of 300 samples (coordinate search), nodes by the largest
/// posterior variance in turn (pivoted Cholesky decomposition), weights by the projected-process approximation
/// (Rasmussen and Williams, section 8.3.4) to all samples with a noise of 1 % of the standard deviation. Deterministic.
/// A few seconds for 512 nodes. @throws Cancelled.
GaussianProcess fitGaussianProcess(const factorization::HalfDifferenceSamples& samples, int nodes,
                                   const TaskControl& control = {});

/// About 5 ns per node and pair.
std::shared_ptr<const Brdf> makeGaussianProcessBrdf(GaussianProcess process);

}  // namespace gonio::baselines
