// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/baselines/half_vector_sampler.h"

namespace gonio::baselines {

/// One channel of a BRDF, or its luminance Y, as a sum of products of curves in half-out coordinates,
///   ln(1 + Y) = sum_l a_l(theta_h) b_l(|phi_h|) c_l(theta_o),
/// for the luminance with rho = max(0, kd + ks Y), where kd and ks are one number per channel. Bilgili, Öztürk and Kurt
/// 2011, "A General BRDF Representation Based on Tensor Decomposition": a sequence of Tucker decompositions of rank (1,
/// 1, 1), each of the residual of the previous ones. With the luminance, colours off the line kd + ks Y are changed to
/// lie on it. Not reciprocal.
///
/// Differences from the paper: isotropic materials only (three modes, not four); a cell with the light below the
/// horizon has the value of the nearest theta_h for which the light is above it, because a dense tensor needs a value
/// in every cell; ln(1 + Y), as in all factorisations of Gonio. kd and ks are Gonio's, by least squares weighted by the
/// projected solid angles; kd may be negative (a coloured diffuse term under a white highlight needs it).
struct BilgiliFactors {
  struct Term {
    std::vector<double> a, b, c;
  };
  HalfOutAxes axes;
  std::vector<Term> terms;
  double highest = 0;          ///< largest ln(1 + Y) of the measurement; sums are clamped to [0, highest]
  std::optional<int> channel;  ///< represented; none: the luminance
  Rgb kd{0}, ks{0};            ///< of the luminance
  /// Relative norm of the residual of ln(1 + Y) for 0, 1, ... terms; never increases.
  std::vector<double> residuals;

  std::size_t bytes() const;
};

/// The axes used in comparisons: 90 x 45 x 45 nodes.
HalfOutAxes bilgiliAxes();
/// The number of terms that fits in the budget, at least 1.
int bilgiliTerms(const HalfOutAxes& axes, std::size_t byteBudget);

/// Takes a few seconds for 60 terms. @param channel 0 to 2; none: the luminance. @throws Cancelled.
BilgiliFactors factorizeBilgili(const HalfOutSamples& samples, int terms, std::optional<int> channel = {},
                                const TaskControl& control = {});

/// The model of the first `terms` terms, with kd and ks fitted again. @param samples the samples that were factorised.
BilgiliFactors truncateBilgili(const BilgiliFactors& factors, int terms, const HalfOutSamples& samples);

/// Linear between the nodes. sample() uses the factors (core/baselines/half_vector_sampler.h), which are
/// tabulated at the first sample (0.2 s for 60 terms).
std::shared_ptr<const Brdf> makeBilgiliBrdf(BilgiliFactors luminance);
std::shared_ptr<const Brdf> makeBilgiliBrdf(std::array<BilgiliFactors, 3> channels);

}  // namespace gonio::baselines
