// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/factorization/half_difference_samples.h"

namespace gonio::factorization {

/// A reflectance as a sum of separable products by the singular value decomposition, in the coordinates of the half and
/// the difference vector:
///   rho(theta_h, theta_d, phi_d) = max(0, sum_k u_k(theta_h) v_k(theta_d, phi_d)).
/// Kautz and McCool 1999, "Interactive Rendering with Arbitrary BRDFs using Separable Approximations".
/// Reciprocal.
///
/// Reduced and derived here: isotropic materials alone, so u has no azimuth, and phi_d is folded to a quarter; colour
/// lies in u (the channels stand side by side in the matrix); a cell with a direction below the horizon takes the value
/// of the nearest theta_h that has none, where a dense matrix needs one; rows and columns weigh by their solid angles
/// and by the cosines at phi_d = pi / 2, which the paper does not do (docs/factors.md).
struct KautzMcCoolFactors {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  HalfDifferenceAxes axes;
  RowMajor half;        ///< u: (3 thetaH) x terms, the channels of a node in rows that follow each other
  RowMajor difference;  ///< v: (thetaD phiD) x terms, phiD fastest
  /// Norm of what is left of the weighted matrix for 0, 1, .. terms, relative: never rises.
  std::vector<double> residuals;

  /// The model with only its first terms.
  KautzMcCoolFactors truncated(int terms) const;
  std::size_t bytes() const { return std::size_t(half.size() + difference.size()) * sizeof(float); }
};

/// The axes of comparisons: 90 x 30 x 7.
HalfDifferenceAxes kautzMcCoolAxes();
/// As many terms as fit, at least 1, at most those of an exact decomposition.
int kautzMcCoolTerms(const HalfDifferenceAxes& axes, std::size_t byteBudget);

/// Under a second. @param terms at most those of an exact decomposition. @throws Cancelled.
KautzMcCoolFactors factorizeKautzMcCool(const HalfDifferenceSamples& samples, int terms,
                                        const TaskControl& control = {});

/// The same model with u and v that are not negative, by the multiplicative updates of Lee and Seung 2001 (at most
/// 1000) on the same weighted matrix: no term takes away what another adds. `residuals` has those of 0 and of all
/// terms, which have no order: not to be truncated. Seconds. @throws Cancelled.
KautzMcCoolFactors factorizeNonnegativeHalfDifference(const HalfDifferenceSamples& samples, int terms,
                                                      const TaskControl& control = {});

/// Lines between the nodes.
std::shared_ptr<const Brdf> makeKautzMcCoolBrdf(KautzMcCoolFactors factors);

}  // namespace gonio::factorization
