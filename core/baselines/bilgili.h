// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/baselines/half_out_samples.h"

namespace gonio::factorization {

/// A reflectance by its luminance Y alone, a sum of products of curves in half-out coordinates,
///   ln(1 + Y) = sum_l a_l(theta_h) b_l(|phi_h|) c_l(theta_o),   rho = max(0, kd + ks Y),
/// with kd and ks one number per channel. Bilgili, Öztürk and Kurt 2011, "A General BRDF Representation Based on Tensor
/// Decomposition": Tucker decompositions of rank (1, 1, ..), each of what those before left. Where the colour changes
/// from the highlight to the rest in more than this line, it shifts. Not reciprocal.
///
/// Reduced and derived here: isotropic materials alone (three modes, not four); a cell without a light above the
/// horizon takes the value of the nearest theta_h that has one, where a dense tensor needs one; ln(1 + Y), the
/// logarithm of all of Gonio's factorisations; kd and ks by least squares in the projected solid angles, kd of either
/// sign (a coloured body under a white highlight needs it).
struct BilgiliFactors {
  struct Term {
    std::vector<double> a, b, c;
  };
  HalfOutAxes axes;
  std::vector<Term> terms;
  double highest = 0;  ///< largest ln(1 + Y) of the measurement: sums between nodes are held below it
  Rgb kd{0}, ks{0};
  /// Norm of what is left of ln(1 + Y), for 0, 1, .. terms, relative: never rises.
  std::vector<double> residuals;

  std::size_t bytes() const;
};

/// The axes of comparisons: 90 x 45 x 45.
HalfOutAxes bilgiliAxes();
/// As many terms as fit, at least 1.
int bilgiliTerms(const HalfOutAxes& axes, std::size_t byteBudget);

/// Some seconds for 60 terms. @throws Cancelled.
BilgiliFactors factorizeBilgili(const HalfOutSamples& samples, int terms, const TaskControl& control = {});

/// The model with only its first terms, kd and ks fitted to them. @param samples those that were factorised.
BilgiliFactors truncateBilgili(const BilgiliFactors& factors, int terms, const HalfOutSamples& samples);

/// Lines between the nodes.
std::shared_ptr<const Brdf> makeBilgiliBrdf(BilgiliFactors factors);

}  // namespace gonio::factorization
