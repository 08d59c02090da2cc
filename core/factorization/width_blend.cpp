// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/width_blend.h"

#include <algorithm>
#include <cmath>

namespace gonio::factorization {

namespace {

using Curve = std::vector<double>;

/// A curve of height 1 as its falling hull and what it has less than that.
struct Hull {
  Curve falling, less;
  double weight;

  Hull(const Curve& curve, double height, double w) : falling(curve), less(curve), weight(w) {
    for (double& value : falling) value /= height;
    for (std::size_t i = falling.size() - 1; i-- > 0;) falling[i] = std::max(falling[i], falling[i + 1]);
    for (std::size_t i = 0; i < less.size(); ++i) less[i] = falling[i] - curve[i] / height;
  }

  /// How far from 0 it is at least at `level`, in (0, 1].
  double width(std::span<const double> nodes, double level) const {
    const auto below = std::partition_point(falling.begin(), falling.end(), [&](double v) { return v >= level; });
    if (below == falling.begin()) return nodes.front();
    if (below == falling.end()) return nodes.back();
    const auto i = std::size_t(below - falling.begin());
    const double fraction = (falling[i - 1] - level) / (falling[i - 1] - falling[i]);
    return nodes[i - 1] + fraction * (nodes[i] - nodes[i - 1]);
  }
};

double blendedWidth(std::span<const double> nodes, const std::vector<Hull>& hulls, double level) {
  double width = 1;
  for (const Hull& hull : hulls) width *= std::pow(hull.width(nodes, level), hull.weight);
  return width;
}

/// The highest level at which the blend is still as wide.
double levelAt(std::span<const double> nodes, const std::vector<Hull>& hulls, double width) {
  constexpr double slack = 1e-12;  // of the powers
  double low = 0, high = 1;
  if (blendedWidth(nodes, hulls, high) >= width * (1 - slack)) return high;
  constexpr int bisections = 50;
  for (int step = 0; step < bisections; ++step) {
    const double level = (low + high) / 2;
    (blendedWidth(nodes, hulls, level) >= width * (1 - slack) ? low : high) = level;
  }
  return low;
}

}  // namespace

std::vector<double> blendedByWidth(std::span<const double> nodes, std::span<const std::vector<double>> curves,
                                   std::span<const double> weights) {
  std::vector<Hull> hulls;
  double total = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double height = *std::max_element(curves[i].begin(), curves[i].end());
    if (!(weights[i] > 0) || !(height > 0)) continue;
    hulls.emplace_back(curves[i], height, weights[i]);
    total += weights[i];
  }
  Curve result(nodes.size(), 0.0);
  if (hulls.empty()) return result;
  for (Hull& hull : hulls) hull.weight /= total;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result[i] = levelAt(nodes, hulls, nodes[i]);
    for (const Hull& hull : hulls) result[i] -= hull.weight * hull.less[i];
    result[i] = std::max(result[i], 0.0);
  }
  return result;
}

}  // namespace gonio::factorization
