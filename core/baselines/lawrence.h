// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/baselines/half_out_samples.h"

namespace gonio::factorization {

/// Counts of products of the factored form.
struct LawrenceRanks {
  int terms = 1;     ///< J, of the first factorisation
  int products = 1;  ///< K, of each factor of the half vector again
};

/// A reflectance times the cosine of the light as a sum of non-negative products of curves in half-out coordinates:
///   rho cos theta_i = sum_j F_j(theta_o) sum_k u_jk(theta_h) v_jk(|phi_h|).
/// Lawrence, Rusinkiewicz and Ramamoorthi 2004, "Efficient BRDF Importance Sampling Using a Factored Representation",
/// eq. 5-7. Cells without a measurement count as 0, as light below the horizon does there. Not reciprocal.
///
/// Reduced and derived here: isotropic materials alone, so F has no azimuth, and phi_h is folded; colour lies in F
/// alone (the channels stand side by side in the matrix); theta_h is sampled as in MERL tables, where even steps of
/// 1 - cos theta_h miss narrow highlights; cells weigh by their solid angle, which the paper does not do and which
/// helps much (docs/factors.md); the divisor cos theta_i is at least that of largestPolarAngle.
struct LawrenceFactors {
  HalfOutAxes axes;
  LawrenceRanks ranks;
  Eigen::MatrixXd viewer;   ///< F: terms x (3 thetaO), the channels of a node side by side
  Eigen::MatrixXd polar;    ///< u: thetaH x (terms products), the products of a term side by side
  Eigen::MatrixXd azimuth;  ///< v: phiH x (terms products)

  std::size_t bytes() const { return std::size_t(viewer.size() + polar.size() + azimuth.size()) * sizeof(float); }
};

/// The axes of comparisons: 90 x 24 x 30.
HalfOutAxes lawrenceAxes();
/// As many terms of four products as fit; with less room fewer products, then one.
LawrenceRanks lawrenceRanks(const HalfOutAxes& axes, std::size_t byteBudget);

/// Some seconds for 20 terms. @throws Cancelled.
LawrenceFactors factorizeLawrence(const HalfOutSamples& samples, const LawrenceRanks& ranks,
                                  const TaskControl& control = {});

/// Lines between the nodes: not negative anywhere.
std::shared_ptr<const Brdf> makeLawrenceBrdf(LawrenceFactors factors);

}  // namespace gonio::factorization
