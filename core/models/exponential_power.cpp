// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/exponential_power.h"

#include <algorithm>
#include <cmath>

#include "core/math/quadrature.h"
#include "core/math/special_functions.h"

namespace gonio::models {

namespace {

using Distribution = ExponentialPowerDistribution;
using Row = std::array<double, Distribution::maskingNodes>;

constexpr std::size_t rows = 33;  ///< of the table, over ln p

double logPowerAt(std::size_t row) {
  const double low = std::log(Distribution::minPower), high = std::log(Distribution::maxPower);
  return low + (high - low) * double(row) / double(rows - 1);
}

/// E[max(0, x)] for beta = 1: a 1/pi of the mean slope E[r] = Gamma(3 / (2p)) / Gamma(1 / p).
double unitMeanSlope(double p) { return std::exp(logGamma(1.5 / p) - logGamma(1 / p)) / pi; }

/// E[max(0, x - mu)] for beta = 1: the mean over the azimuth is (sqrt(r^2 - mu^2) - mu acos(mu / r)) / pi for r > mu.
/// The integral over r runs over y = r^k, which spreads the decades that small p span, and z^2 = y - mu^k, in which the
/// integrand starts smoothly.
double excessSlope(double mu, double p) {
  static const QuadratureRule unit = compositeGaussLegendre(16, 4, 0, 1);
  const double k = std::min(1.0, 2 * p), a = 1 / p;
  const double start = std::pow(mu, k), end = std::pow(45 + a + 10 * std::sqrt(a), k / (2 * p));
  if (!(start < end)) return 0;
  const double logNorm = std::log(2 * p / k) - logGamma(a), last = std::sqrt(end - start);
  return last * unit.integrate([&](double part) {
    const double z = last * part, y = start + z * z, r = std::pow(y, 1 / k), ratio = std::min(1.0, mu / r);
    const double across = r * (std::sqrt((1 - ratio) * (1 + ratio)) - ratio * std::acos(ratio)) / pi;
    return 2 * z * across * std::exp(logNorm + (2 / k - 1) * std::log(y) - std::pow(y, 2 * p / k));
  });
}

Row makeRow(double p) {
  Row row{};
  const double mean = unitMeanSlope(p);
  row.front() = 1;
  for (std::size_t n = 1; n + 1 < row.size(); ++n) {
    const double s = double(n) / double(row.size() - 1);
    row[n] = excessSlope(Distribution::maskingScale * mean * s / (1 - s), p) / mean;
  }
  row.back() = 0;
  return row;
}

const std::array<Row, rows>& maskingTable() {
  static const std::array<Row, rows> table = [] {
    std::array<Row, rows> made;
    for (std::size_t row = 0; row < rows; ++row) made[row] = makeRow(std::exp(logPowerAt(row)));
    return made;
  }();
  return table;
}

}  // namespace

ExponentialPowerDistribution::ExponentialPowerDistribution(double beta, double p)
    : inverseBeta2_(1 / (beta * beta)),
      power_(p),
      logPeak_(std::log(p * inverseBeta2_ / pi) - logGamma(1 / p)),
      meanSlope_(beta * unitMeanSlope(p)),
      meanSquareSlope_(beta * beta * std::exp(logGamma(2 / p) - logGamma(1 / p))) {
  const std::array<Row, rows>& table = maskingTable();
  const double position = std::clamp((std::log(p) - logPowerAt(0)) / (logPowerAt(1) - logPowerAt(0)), 0.0, rows - 1.0);
  for (std::size_t n = 0; n < maskingNodes; ++n)
    masking_[n] = cubicInterpolation(position, rows, [&](int row) { return table[std::size_t(row)][n]; });
}

}  // namespace gonio::models
