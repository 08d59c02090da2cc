// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/math/types.h"

/// Parts of the model of He, Torrance, Sillion and Greenberg 1991 that are not closed forms.
namespace gonio::models {

/// The slope of the logarithm of the terms of heSeries() at the order m. From m = 2 on it decreases.
inline double heLogSlope(double g, double a, double m) { return fastLog(g / (m + 0.5)) - 1 / m + a / (m * m); }

/// A number for each colour channel; the fourth fills the vector registers.
using HeLanes = std::array<double, 4>;

/// Orders m >= 1 and widths (standard deviations, in orders) of Gaussians that resemble the terms of heSeries().
struct HeTerms {
  HeLanes order, width;
};
/// Newton steps in ln m; an order is accurate to a few percent of its width.
inline HeTerms heLargestTerms(const HeLanes& g, const HeLanes& a) {
  HeTerms terms;
  HeLanes distance;  // of the last step, in widths
  for (std::size_t n = 0; n < g.size(); ++n) terms.order[n] = std::max(1.0, std::max(g[n], std::sqrt(a[n])));
  for (int step = 0; step < 8; ++step) {
    for (std::size_t n = 0; n < g.size(); ++n) {
      const double m = terms.order[n];
      const double curvature = std::max(1 / (m + 0.5) - 1 / (m * m) + 2 * a[n] / (m * m * m), 0.3 / m);
      const double change = heLogSlope(g[n], a[n], m) / (m * curvature);
      terms.order[n] = std::max(1.0, m * fastExp(std::min(1.0, std::max(-1.0, change))));
      terms.width[n] = 1 / std::sqrt(curvature);
      distance[n] = std::abs(change) * terms.order[n] / terms.width[n];
    }
    if (std::max(std::max(distance[0], distance[1]), std::max(distance[2], distance[3])) < 0.02) break;
  }
  return terms;
}

/// heSeries() term by term, where the largest term has a low order.
inline double heSumOfTerms(double g, double a) {
  constexpr int block = 8, blocks = 13;
  static constexpr auto reciprocals = [] {
    std::array<double, block * blocks> values{};
    for (std::size_t m = 0; m < values.size(); ++m) values[m] = 1 / double(m + 1);
    return values;
  }();
  constexpr double smallest = 1e-12;
  double power = fastExp(-g), sum = 0;
  for (int first = 0; first < block * blocks; first += block) {
    const double* reciprocal = &reciprocals[std::size_t(first)];
    double terms[block];
    for (int n = 0; n < block; ++n) terms[n] = fastExp(-a * reciprocal[n]) * reciprocal[n];
    double last = 0, before = 0;
    for (int n = 0; n < block; ++n) {
      before = last;
      power *= g * reciprocal[n];
      last = power * terms[n];
      sum += last;
    }
    if (last < before && last <= smallest * sum) break;
  }
  return sum;
}

/// heSeries() as an integral over m, where the largest term has a high order: n! by Stirling's series (error below 1e-9
/// for n >= 10), and the trapezoidal rule, with an error that falls exponentially with smaller steps.
/// @param order, width of the terms: HeTerms.
inline double heIntegralOfTerms(double g, double a, double order, double width) {
  constexpr int nodes = 16;
  constexpr double step = 0.9;  // widths
  double values[nodes];
  for (int n = 0; n < nodes; ++n) {
    const double at = order + (n - 7) * step * width, m = std::max(at, 1.0);
    const double u = m / g - 1, inverse = 1 / m;
    const double exponent =
        -g * ((1 + u) * fastLog1p(u) - u) - inverse * (a + 1.0 / 12 - inverse * inverse * (1.0 / 360));
    values[n] = at < 1 ? 0.0 : fastExp(exponent) * inverse / std::sqrt(m);
  }
  double sum = 0;
  for (const double value : values) sum += value;
  return sum * step * width / std::sqrt(2 * pi);
}

/// For each channel the sum over m >= 1 of g^m exp(-g - a / m) / (m! m): eq. 78 of the paper without its constant,
/// g > 0, a >= 0. Relative error below 1e-7. About 0.15 us a channel.
inline Rgb heSeries(const Rgb& g, const Rgb& a) {
  constexpr double directOrder = 25;
  const auto hasLowOrder = [&](int channel) { return heLogSlope(g[channel], a[channel], directOrder) <= 0; };
  const bool isLow[] = {hasLowOrder(0), hasLowOrder(1), hasLowOrder(2)};
  HeTerms terms;
  if (!isLow[0] || !isLow[1] || !isLow[2]) terms = heLargestTerms({g.x, g.y, g.z, g.z}, {a.x, a.y, a.z, a.z});
  Rgb result;
  for (int channel = 0; channel < 3; ++channel) {
    const auto n = std::size_t(channel);
    result[channel] = isLow[n] ? heSumOfTerms(g[channel], a[channel])
                               : heIntegralOfTerms(g[channel], a[channel], terms.order[n], terms.width[n]);
  }
  return result;
}

/// (sigma / sigma_0)^2, the part of the mean square height that light and viewer see (eq. 80, 81): 1 / (1 + t^2) with
/// t exp(t^2 / 2) = c. @param c (K_i + K_r) / sqrt(8 pi) >= 0. By Newton's method for ln t^2.
inline double heVisibleRoughness(double c) {
  if (!(c > 1e-8)) return 1;
  const double right = 2 * std::log(c);
  double y = right > 1 ? std::log(right) : right;  // t^2 = exp(y): y + exp(y) = right
  for (int step = 0; step < 8; ++step) {
    const double square = fastExp(y), change = (y + square - right) / (1 + square);
    y -= change;
    if (std::abs(change) < 1e-12) break;
  }
  return 1 / (1 + fastExp(y));
}

}  // namespace gonio::models
