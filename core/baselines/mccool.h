// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/factorization/half_difference_samples.h"

namespace gonio::factorization {

/// A reflectance as one positive product, in each channel
///   rho + bias = p(theta_i) q(theta_h) p(theta_o).
/// McCool, Ang and Ahmad 2001, "Homomorphic Factorization of BRDFs for High-Performance Rendering": linear least
/// squares of the logarithm. The bias keeps the logarithm finite. Reciprocal; it has no more terms, and no finer curves
/// than the measurement: its size is what it is.
///
/// Reduced and derived here: for isotropic materials the least squares have a solution that does not depend on azimuths
/// (its mean over all rotations), so maps of two dimensions become curves; the size of the bias; cells weigh by their
/// projected solid angles; curves are held smooth by a small weight of their second differences, as there.
struct McCoolFactors {
  struct Channel {
    std::vector<double> logP, logQ;  ///< at the nodes
    double bias = 0;                 ///< 1/sr; 0 for a black channel, of which the curves are 0
    double highest = 0;  ///< largest ln(rho + bias) of the measurement: products between its cells are held below it
  };
  std::vector<double> theta;   ///< nodes of p, rad
  std::vector<double> thetaH;  ///< nodes of q, rad
  std::array<Channel, 3> channels;

  std::size_t bytes() const { return 3 * (theta.size() + thetaH.size() + 2) * sizeof(float); }
};

/// The axes of comparisons: 90 x 90 x 10; p has 90 nodes too.
HalfDifferenceAxes mcCoolAxes();

/// About 0.1 s. @throws Cancelled.
McCoolFactors factorizeMcCool(const HalfDifferenceSamples& samples, const TaskControl& control = {});

/// Lines between the nodes of the logarithms.
std::shared_ptr<const Brdf> makeMcCoolBrdf(McCoolFactors factors);

}  // namespace gonio::factorization
