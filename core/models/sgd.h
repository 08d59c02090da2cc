// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

/// Parts of the SGD model. Source: Bagher, Soler and
/// Holzschuch, "Accurate Fitting of Measured Reflectances using a Shifted Gamma Micro-facet Distribution" (2012).
namespace gonio::models {

/// ln K, K = 1 / (alpha Gamma(1 - p, alpha)): makes the integral of D cos theta_h over the hemisphere 1. alpha > 0.
double sgdLogNormalisation(double alpha, double p);

/// G1 in [0, 1] at the polar angle theta (rad): exactly 1 up to theta0. `logC` is ln c: c goes up to 1e109 in published
/// fits, where c (theta - theta0)^k must not be formed factor by factor.
double sgdMasking(double theta, double lambda, double logC, double k, double theta0);

}  // namespace gonio::models
