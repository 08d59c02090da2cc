// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/factorization/half_difference_samples.h"

namespace gonio::baselines {

/// A BRDF as one product of positive curves, in each channel
///   rho + bias = p(theta_i) q(theta_h) p(theta_o).
/// McCool, Ang and Ahmad 2001, "Homomorphic Factorization of BRDFs for High-Performance Rendering": linear least
/// squares of the logarithm. The bias makes the logarithm finite. Reciprocal. The size is fixed: there are no further
/// terms.
///
/// Differences from the paper: for isotropic materials the least squares have a solution that does not depend on
/// azimuths (the mean over all rotations), so two-dimensional maps become curves; the size of the bias; cells are
/// weighted by their projected solid angles. As in the paper, a small weight of the second differences smooths the
/// curves.
struct McCoolFactors {
  struct Channel {
    std::vector<double> logP, logQ;  ///< ln p and ln q at the nodes
    double bias = 0;                 ///< 1/sr; 0 for a black channel, where the model is 0
    double highest = 0;              ///< largest ln(rho + bias) of the measurement; products are clamped to it
  };
  std::vector<double> theta;   ///< nodes of p, rad
  std::vector<double> thetaH;  ///< nodes of q, rad
  std::array<Channel, 3> channels;

  std::size_t bytes() const { return 3 * (theta.size() + thetaH.size() + 2) * sizeof(float); }
};

/// The axes used in comparisons: 90 x 90 x 10 nodes; p also has 90 nodes.
factorization::HalfDifferenceAxes mcCoolAxes();

/// About 0.1 s. @throws Cancelled.
McCoolFactors factorizeMcCool(const factorization::HalfDifferenceSamples& samples, const TaskControl& control = {});

/// The logarithms are linear between the nodes.
std::shared_ptr<const Brdf> makeMcCoolBrdf(McCoolFactors factors);

}  // namespace gonio::baselines
