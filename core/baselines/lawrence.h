// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/baselines/half_vector_sampler.h"

namespace gonio::baselines {

/// Numbers of products of the factored form.
struct LawrenceRanks {
  int terms = 1;     ///< J, terms of the first factorisation
  int products = 1;  ///< K, products of the second factorisation, per term
};

/// A BRDF times the cosine of the light, as a sum of non-negative products of curves in half-out coordinates:
///   rho cos theta_i = sum_j F_j(theta_o) sum_k u_jk(theta_h) v_jk(|phi_h|).
/// Lawrence, Rusinkiewicz and Ramamoorthi 2004, "Efficient BRDF Importance Sampling Using a Factored Representation",
/// eq. 5-7. Cells without a measurement count as 0, as the paper does for light below the horizon. Not reciprocal.
///
/// Differences from the paper: isotropic materials only, so F has no azimuth, and phi_h is folded; only F contains
/// colours (the channels are separate columns of one matrix); theta_h is sampled as in MERL tables, because uniform
/// steps of 1 - cos theta_h miss narrow highlights; cells are weighted by their solid angle, which improves the result
/// considerably (docs/results/factors.md); the divisor cos theta_i is at least cos(maxPolarAngle).
struct LawrenceFactors {
  HalfOutAxes axes;
  LawrenceRanks ranks;
  Eigen::MatrixXd viewer;   ///< F: terms x (3 thetaO); the channels of a node are consecutive
  Eigen::MatrixXd polar;    ///< u: thetaH x (terms products); the products of a term are consecutive
  Eigen::MatrixXd azimuth;  ///< v: phiH x (terms products)

  std::size_t bytes() const { return std::size_t(viewer.size() + polar.size() + azimuth.size()) * sizeof(float); }
};

/// The axes used in comparisons: 90 x 24 x 30 nodes.
HalfOutAxes lawrenceAxes();
/// The ranks that fit in the budget: K = 4, 3 or 2 products, the largest K with which more than K terms fit; if there
/// is none, K = 1, with at least one term.
LawrenceRanks lawrenceRanks(const HalfOutAxes& axes, std::size_t byteBudget);

/// Takes a few seconds for 20 terms. @throws Cancelled.
LawrenceFactors factorizeLawrence(const HalfOutSamples& samples, const LawrenceRanks& ranks,
                                  const TaskControl& control = {});

/// Linear between the nodes, so never negative. sample() uses the factors (core/baselines/half_vector_sampler.h).
std::shared_ptr<const Brdf> makeLawrenceBrdf(LawrenceFactors factors);

}  // namespace gonio::baselines
