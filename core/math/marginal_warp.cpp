// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/marginal_warp.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/math/sampling.h"
#include "core/support/error.h"

namespace gonio {

namespace {

struct WarpBracket {
  std::size_t low;
  double weight;  ///< of the node after `low`; 0 where there is none
};

WarpBracket bracket(const std::vector<float>& nodes, double x) {
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), x);
  if (above == nodes.begin()) return {0, 0};
  const std::size_t low = std::size_t(above - nodes.begin()) - 1;
  if (above == nodes.end()) return {low, 0};
  return {low, (x - nodes[low]) / (double(*above) - nodes[low])};
}

}  // namespace

ParameterGrid::ParameterGrid(std::vector<float> phis, std::vector<float> thetas)
    : phis_(std::move(phis)), thetas_(std::move(thetas)) {
  assert(!phis_.empty() && !thetas_.empty());
}

SliceBlend ParameterGrid::blend(double phi, double theta) const {
  const WarpBracket p = bracket(phis_, phi), t = bracket(thetas_, theta);
  SliceBlend result;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const bool upperP = corner & 2, upperT = corner & 1;
    const double weight = (upperP ? p.weight : 1 - p.weight) * (upperT ? t.weight : 1 - t.weight);
    if (weight == 0) continue;
    result.slice[std::size_t(result.count)] =
        std::uint32_t((p.low + std::size_t(upperP)) * thetas_.size() + t.low + std::size_t(upperT));
    result.weight[std::size_t(result.count++)] = weight;
  }
  return result;
}

MarginalWarp::MarginalWarp(SliceStack<float> density, const std::string& name, EmptySlice empty)
    : density_(std::move(density)), conditional_{density_.width, density_.height, density_.values} {
  const std::size_t width = density_.width, height = density_.height;
  const std::size_t slices = density_.values.size() / (width * height);
  const auto negative = std::ranges::find_if(density_.values, [](float value) { return value < 0; });
  if (negative != density_.values.end())
    throw Error("value " + std::to_string(negative - density_.values.begin()) + " of '" + name + "' is " +
                std::to_string(*negative) + ", expected a density of 0 or more");
  marginal_.resize(slices * height);
  std::vector<double> rows(width * height), marginal(height);
  for (std::size_t slice = 0; slice < slices; ++slice) {
    float* values = &density_.values[slice * width * height];
    if (empty == EmptySlice::uniform && std::all_of(values, values + width * height, [](float v) { return v == 0; }))
      std::fill_n(values, width * height, 1.f);
    for (std::size_t row = 0; row < height; ++row) {
      double* sums = &rows[row * width];
      sums[0] = 0;
      for (std::size_t x = 1; x < width; ++x)
        sums[x] = sums[x - 1] + 0.5 * (double(values[row * width + x - 1]) + double(values[row * width + x]));
      marginal[row] = row == 0 ? 0 : marginal[row - 1] + 0.5 * (rows[row * width - 1] + rows[(row + 1) * width - 1]);
    }
    const double total = marginal[height - 1];
    if (!(total > 0))
      throw Error("slice " + std::to_string(slice) + " of '" + name + "' is 0 everywhere, expected a positive total");
    for (std::size_t i = 0; i < width * height; ++i) {
      values[i] = float(values[i] / total);
      conditional_.values[slice * width * height + i] = float(rows[i] / total);
    }
    for (std::size_t row = 0; row < height; ++row) marginal_[slice * height + row] = float(marginal[row] / total);
  }
}

/// What invert() and sample() read of the strip between two rows: quantities of the blended density, each linear in y.
struct MarginalWarp::Strip {
  const SliceBlend& blend;
  std::size_t row;
  double below = 0, lowTotal = 0, highTotal = 0;

  double total(double y) const { return (1 - y) * lowTotal + y * highTotal; }
  /// The density, or the integral of a row up to a column, in the strip.
  double at(const SliceStack<float>& stack, std::size_t column, double y) const {
    double sum = 0;
    for (int i = 0; i < blend.count; ++i) {
      const float* low = stack.node(blend.slice[i], row, column);
      sum += blend.weight[i] * ((1 - y) * low[0] + y * low[stack.width]);
    }
    return sum;
  }
};

MarginalWarp::Strip MarginalWarp::strip(const SliceBlend& blend, std::size_t row) const {
  Strip strip{blend, row};
  for (int i = 0; i < blend.count; ++i) {
    const double weight = blend.weight[i];
    const float* total = conditional_.node(blend.slice[i], row, density_.width - 1);
    strip.below += weight * marginal_[blend.slice[i] * density_.height + row];
    strip.lowTotal += weight * total[0];
    strip.highTotal += weight * total[density_.width];
  }
  return strip;
}

MarginalWarp::Sample MarginalWarp::invert(const SliceBlend& blend, const glm::dvec2& point) const {
  const GridCell cell = gridCell(point, density_.width, density_.height);
  const Strip strip = this->strip(blend, cell.row);
  const double left = strip.at(density_, cell.column, cell.y), right = strip.at(density_, cell.column + 1, cell.y);
  const double total = strip.total(cell.y);
  const double across = strip.at(conditional_, cell.column, cell.y) + cell.x * (left + 0.5 * cell.x * (right - left));
  const double along = strip.below + cell.y * (strip.lowTotal + 0.5 * cell.y * (strip.highTotal - strip.lowTotal));
  const double density = ((1 - cell.x) * left + cell.x * right) * cells();
  // Where a whole row has no density every x is as good: it stays.
  return {{total > 0 ? std::clamp(across / total, 0.0, 1.0) : point.x, std::clamp(along, 0.0, 1.0)}, density};
}

MarginalWarp::Sample MarginalWarp::sample(const SliceBlend& blend, const glm::dvec2& u) const {
  const std::size_t width = density_.width, height = density_.height;
  const auto below = [&](std::size_t row) {
    double sum = 0;
    for (int i = 0; i < blend.count; ++i) sum += blend.weight[i] * marginal_[blend.slice[i] * height + row];
    return sum;
  };
  // The last node whose integral is not above the number sought, but never the very last.
  const auto search = [](std::size_t count, double sought, const auto& integral) {
    std::size_t low = 0, high = count - 1;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (integral(middle) <= sought ? low : high) = middle;
    }
    return low;
  };
  const std::size_t row = search(height, u.y, below);
  const Strip strip = this->strip(blend, row);
  const double y = inverseOfRamp(strip.lowTotal, strip.highTotal, u.y - strip.below);
  const double sought = u.x * strip.total(y);
  const std::size_t column = search(width, sought, [&](std::size_t c) { return strip.at(conditional_, c, y); });
  const double left = strip.at(density_, column, y), right = strip.at(density_, column + 1, y);
  const double x = inverseOfRamp(left, right, sought - strip.at(conditional_, column, y));
  return {{(double(column) + x) / double(width - 1), (double(row) + y) / double(height - 1)},
          ((1 - x) * left + x * right) * cells()};
}

double MarginalWarp::density(const SliceBlend& blend, const glm::dvec2& point) const {
  return interpolate<double>(density_, blend, point) * cells();
}

}  // namespace gonio
