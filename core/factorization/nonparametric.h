// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/factorization/half_difference_samples.h"
#include "core/math/monotone_cubic.h"

namespace gonio::factorization {

/// A microfacet model with tabulated factors instead of formulas, in each channel
///   rho = (diffuse + specular D(theta_h) F(theta_d) G(theta_i) G(theta_o) / (cos theta_i cos theta_o)) / pi.
/// Bagher, Snyder and Nowrouzezahrai 2016, "A Non-Parametric Factor Microfacet Model for Isotropic BRDFs". Reciprocal.
/// The size is fixed.
struct NonparametricFactors {
  static constexpr std::size_t nodes = 90;
  struct Channel {
    double diffuse = 0, specular = 0;
    std::array<double, nodes> d{};  ///< D at theta_h = (i / 90)^2 pi / 2, the nodes of MERL tables
    std::array<double, nodes> f{};  ///< F at theta_d = i degrees
    std::array<double, nodes> g{};  ///< G at theta = i + 1/2 degrees
    bool operator==(const Channel&) const = default;
  };
  std::array<Channel, 3> channels;
  bool operator==(const NonparametricFactors&) const = default;

  static constexpr std::size_t bytes() { return 3 * (2 + 3 * nodes) * sizeof(float); }
};

struct NonparametricFit {
  NonparametricFactors factors;
  /// Weighted norm of the residual per channel, relative to that of the data, at the start and after each sweep; never
  /// increases.
  std::array<std::vector<double>, 3> residuals;
};

struct NonparametricOptions {
  int maxSweeps = 200;
  double tolerance = 1e-5;  ///< stops when a sweep lowers the residual by less than this fraction
};

/// The axes that fitNonparametric() requires: 90 x 90 x 10 nodes, those of D and F.
HalfDifferenceAxes nonparametricAxes();

/// Fits the factors by alternating non-negative weighted least squares: D, F, the diffuse part, then G by damped
/// Gauss-Newton steps. As in the paper, weights compress the range of values; their form is our own: with x = rho cos
/// theta_i cos theta_o, the error x - x^ is weighted by ln(1 + x) / x, and cells by their solid angles. Takes a few
/// seconds. @throws Cancelled.
NonparametricFit fitNonparametric(const HalfDifferenceSamples& samples, const NonparametricOptions& options = {},
                                  const TaskControl& control = {});

/// Linear between the nodes; G / cos is constant beyond the last node of G.
std::shared_ptr<const Brdf> makeNonparametricBrdf(NonparametricFactors factors);

/// The two nodes around a position (in units of nodes) and the fraction between them, clamped to the ends.
NodeInterval nonparametricInterval(double position);
/// The two nodes of G around a polar angle (rad), and the fraction between them.
inline NodeInterval maskingInterval(double theta) { return nonparametricInterval(degrees(theta) - 0.5); }

}  // namespace gonio::factorization
