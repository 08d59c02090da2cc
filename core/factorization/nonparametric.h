// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/factorization/half_difference_samples.h"

namespace gonio::factorization {

/// A microfacet model whose factors are tables instead of formulas, in each channel
///   rho = (diffuse + specular D(theta_h) F(theta_d) G(theta_i) G(theta_o) / (cos theta_i cos theta_o)) / pi.
/// Bagher, Snyder and Nowrouzezahrai 2016, "A Non-Parametric Factor Microfacet Model for Isotropic BRDFs". Reciprocal;
/// its size is what it is.
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
  /// Of each channel, the weighted norm of what is left, relative to that of the data, at the start and after each
  /// sweep: never rises.
  std::array<std::vector<double>, 3> residuals;
};

struct NonparametricOptions {
  int maxSweeps = 200;
  double tolerance = 1e-5;  ///< relative fall of the residual in a sweep below which it stops
};

/// The axes of comparisons: 90 x 90 x 10; others are refused by an assert, since D and F have those nodes.
HalfDifferenceAxes nonparametricAxes();

/// Alternating weighted least squares, not negative: D, F, the diffuse part, then G by Gauss-Newton steps that are cut
/// until the residual falls. The weight compresses the range as that paper asks for; its form is derived here: with
/// x = rho cos theta_i cos theta_o the error x - x^ counts ln(1 + x) / x times, to first order the error of ln(1 + x),
/// and cells by their solid angles. Some seconds. @throws Cancelled.
NonparametricFit fitNonparametric(const HalfDifferenceSamples& samples, const NonparametricOptions& options = {},
                                  const TaskControl& control = {});

/// Lines between the nodes; G / cos is held beyond the last node of G.
std::shared_ptr<const Brdf> makeNonparametricBrdf(NonparametricFactors factors);

}  // namespace gonio::factorization
