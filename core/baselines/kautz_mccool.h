// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/factorization/half_difference_samples.h"

namespace gonio::baselines {

/// A BRDF as a sum of separable products in half-difference coordinates, by singular value decomposition:
///   rho(theta_h, theta_d, phi_d) = max(0, sum_k u_k(theta_h) v_k(theta_d, phi_d)).
/// Kautz and McCool 1999, "Interactive Rendering with Arbitrary BRDFs using Separable Approximations".
/// Reciprocal.
///
/// Differences from the paper: isotropic materials only, so u has no azimuth, and phi_d is folded to [0, pi/2]; u
/// contains the colours (the channels are separate rows of one matrix); a cell with a direction below the horizon takes
/// the value of the nearest theta_h where both are above, because a dense matrix needs a value in every cell; rows and
/// columns are weighted by their solid angles and by the cosines at phi_d = pi/2 (docs/results/factors.md); channels
/// that are less than a thousandth as bright as the brightest one count as if they were as bright.
struct KautzMcCoolFactors {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  factorization::HalfDifferenceAxes axes;
  RowMajor half;        ///< u: (3 thetaH) x terms; the channels of a node are consecutive rows
  RowMajor difference;  ///< v: (thetaD phiD) x terms, phiD fastest
  /// Relative norm of the residual of the weighted matrix for 0, 1, ... terms; never increases.
  std::vector<double> residuals;

  /// The model of the first `terms` terms.
  KautzMcCoolFactors truncated(int terms) const;
  std::size_t bytes() const { return std::size_t(half.size() + difference.size()) * sizeof(float); }
};

/// The axes used in comparisons: 90 x 30 x 7 nodes.
factorization::HalfDifferenceAxes kautzMcCoolAxes();
/// The number of terms that fits in the budget, from 1 to that of an exact decomposition.
int kautzMcCoolTerms(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget);

/// Takes under a second. @param terms at most those of an exact decomposition. @throws Cancelled.
KautzMcCoolFactors factorizeKautzMcCool(const factorization::HalfDifferenceSamples& samples, int terms,
                                        const TaskControl& control = {});

/// The same model with u, v >= 0, by at most 1000 multiplicative updates (Lee and Seung 2001, "Algorithms for
/// Non-negative Matrix Factorization") on the same weighted matrix. `residuals` contains only those of 0 and of all
/// terms; the terms have no order, so do not truncate the model. Takes seconds. @throws Cancelled.
KautzMcCoolFactors factorizeNonnegativeHalfDifference(const factorization::HalfDifferenceSamples& samples, int terms,
                                                      const TaskControl& control = {});

/// Linear between the nodes.
std::shared_ptr<const Brdf> makeKautzMcCoolBrdf(KautzMcCoolFactors factors);

}  // namespace gonio::baselines
