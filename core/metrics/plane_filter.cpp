// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/plane_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/parallel.h"

namespace gonio::metrics {

namespace {

/// Correlation along one axis: `count` pixels per line, `step` apart; line l starts at start(l).
template <typename Start>
Plane filteredLines(const Plane& plane, std::span<const double> kernel, int lines, int count, int step, Start start) {
  const int radius = int(kernel.size()) / 2;
  Plane result{.width = plane.width, .height = plane.height, .values = std::vector<double>(plane.values.size())};
  parallelForBlocks(std::size_t(lines), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
      for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (int k = -radius; k <= radius; ++k)
          sum += kernel[std::size_t(k + radius)] *
                 plane.values[start(line) + std::size_t(std::clamp(i + k, 0, count - 1)) * std::size_t(step)];
        result.values[start(line) + std::size_t(i) * std::size_t(step)] = sum;
      }
  });
  return result;
}

}  // namespace

Plane filtered(const Plane& plane, std::span<const double> row, std::span<const double> column) {
  const auto width = std::size_t(plane.width);
  const Plane rows = filteredLines(plane, row, plane.height, plane.width, 1, [&](std::size_t y) { return y * width; });
  return filteredLines(rows, column, plane.width, plane.height, plane.width, [](std::size_t x) { return x; });
}

std::vector<double> gaussianKernel(int radius, double deviation) {
  std::vector<double> weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-0.5 * x * x / (deviation * deviation)));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace gonio::metrics
