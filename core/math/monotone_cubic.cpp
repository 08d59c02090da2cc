// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/monotone_cubic.h"

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

/// One-sided three-point slope at an end, held to the sign and to three times the secant next to it.
double endSlope(double h0, double h1, double secant0, double secant1) {
  const double slope = ((2 * h0 + h1) * secant0 - h0 * secant1) / (h0 + h1);
  if (slope * secant0 <= 0) return 0;
  if (secant0 * secant1 <= 0 && std::abs(slope) > 3 * std::abs(secant0)) return 3 * secant0;
  return slope;
}

}  // namespace

std::vector<double> monotoneSlopes(std::span<const double> nodes, std::span<const double> values) {
  const std::size_t n = nodes.size();
  std::vector<double> slopes(n, 0.0), widths, secants;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    widths.push_back(nodes[i + 1] - nodes[i]);
    secants.push_back((values[i + 1] - values[i]) / widths[i]);
  }
  if (n == 2) slopes[0] = slopes[1] = secants[0];
  if (n < 3) return slopes;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (secants[i - 1] * secants[i] <= 0) continue;
    const double before = 2 * widths[i] + widths[i - 1], after = widths[i] + 2 * widths[i - 1];
    slopes[i] = (before + after) / (before / secants[i - 1] + after / secants[i]);
  }
  slopes[0] = endSlope(widths[0], widths[1], secants[0], secants[1]);
  slopes[n - 1] = endSlope(widths[n - 2], widths[n - 3], secants[n - 2], secants[n - 3]);
  return slopes;
}

NodeInterval findInterval(std::span<const double> nodes, double x) {
  if (nodes.size() < 2 || !(x > nodes.front())) return {0, 0};
  if (x >= nodes.back()) return {nodes.size() - 2, 1};
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), x);
  const std::size_t index = std::size_t(above - nodes.begin()) - 1;
  return {index, (x - nodes[index]) / (nodes[index + 1] - nodes[index])};
}

double evaluateMonotoneCubic(std::span<const double> nodes, std::span<const double> values,
                             std::span<const double> slopes, double x) {
  if (nodes.size() < 2) return values[0];
  const NodeInterval at = findInterval(nodes, x);
  const HermiteWeights w(at.fraction, nodes[at.index + 1] - nodes[at.index]);
  return w.before * values[at.index] + w.after * values[at.index + 1] + w.slopeBefore * slopes[at.index] +
         w.slopeAfter * slopes[at.index + 1];
}

}  // namespace gonio
