// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/marginal_warp.h"

#include <algorithm>
#include <cassert>

#include "core/support/error.h"

namespace gonio::io {

namespace {

struct Bracket {
  std::size_t low;
  double weight;  ///< of the node after `low`; 0 where there is none
};

Bracket bracket(const std::vector<float>& nodes, double x) {
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
  const Bracket p = bracket(phis_, phi), t = bracket(thetas_, theta);
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

GridCell gridCell(const glm::dvec2& point, std::size_t width, std::size_t height) {
  assert(width >= 2 && height >= 2);
  const double x = std::clamp(point.x, 0.0, 1.0) * double(width - 1);
  const double y = std::clamp(point.y, 0.0, 1.0) * double(height - 1);
  GridCell cell;
  cell.column = std::min(static_cast<std::size_t>(x), width - 2);
  cell.row = std::min(static_cast<std::size_t>(y), height - 2);
  cell.x = x - double(cell.column);
  cell.y = y - double(cell.row);
  return cell;
}

MarginalWarp::MarginalWarp(SliceStack<float> density, const std::string& name)
    : density_(std::move(density)), conditional_{density_.width, density_.height, density_.values} {
  const std::size_t width = density_.width, height = density_.height;
  const std::size_t slices = density_.values.size() / (width * height);
  const auto negative = std::ranges::find_if(density_.values, [](float value) { return value < 0; });
  if (negative != density_.values.end())
    throw Error("value " + std::to_string(negative - density_.values.begin()) + " of '" + name + "' is " +
                std::to_string(*negative) + ", expected a density, which is nowhere negative");
  marginal_.resize(slices * height);
  std::vector<double> rows(width * height), marginal(height);
  for (std::size_t slice = 0; slice < slices; ++slice) {
    float* values = &density_.values[slice * width * height];
    for (std::size_t row = 0; row < height; ++row) {
      double* sums = &rows[row * width];
      sums[0] = 0;
      for (std::size_t x = 1; x < width; ++x)
        sums[x] = sums[x - 1] + 0.5 * (double(values[row * width + x - 1]) + double(values[row * width + x]));
      marginal[row] = row == 0 ? 0 : marginal[row - 1] + 0.5 * (rows[row * width - 1] + rows[(row + 1) * width - 1]);
    }
    const double total = marginal[height - 1];
    if (!(total > 0)) throw Error("slice " + std::to_string(slice) + " of '" + name + "' is 0, expected a density");
    for (std::size_t i = 0; i < width * height; ++i) {
      values[i] = float(values[i] / total);
      conditional_.values[slice * width * height + i] = float(rows[i] / total);
    }
    for (std::size_t row = 0; row < height; ++row) marginal_[slice * height + row] = float(marginal[row] / total);
  }
}

glm::dvec2 MarginalWarp::invert(const SliceBlend& blend, const glm::dvec2& point) const {
  const std::size_t width = density_.width;
  const GridCell cell = gridCell(point, width, density_.height);
  // Along y, every quantity of the blended density is linear between two rows: `low` and `high`.
  struct Row {
    double left = 0, right = 0, before = 0, total = 0;
  } low, high;
  double rowsBefore = 0;
  for (int i = 0; i < blend.count; ++i) {
    const double weight = blend.weight[i];
    rowsBefore += weight * marginal_[blend.slice[i] * density_.height + cell.row];
    for (const bool upper : {false, true}) {
      Row& row = upper ? high : low;
      const std::size_t y = cell.row + std::size_t(upper);
      const float* value = density_.node(blend.slice[i], y, cell.column);
      const float* sum = conditional_.node(blend.slice[i], y, 0);
      row.left += weight * value[0];
      row.right += weight * value[1];
      row.before += weight * sum[cell.column];
      row.total += weight * sum[width - 1];
    }
  }
  const auto atY = [&](double lowValue, double highValue) { return (1 - cell.y) * lowValue + cell.y * highValue; };
  const double left = atY(low.left, high.left), right = atY(low.right, high.right);
  const double total = atY(low.total, high.total);
  const double across = atY(low.before, high.before) + cell.x * (left + 0.5 * cell.x * (right - left));
  const double along = rowsBefore + cell.y * (low.total + 0.5 * cell.y * (high.total - low.total));
  // Where a whole row has no density every x is as good: it stays.
  return {total > 0 ? std::clamp(across / total, 0.0, 1.0) : point.x, std::clamp(along, 0.0, 1.0)};
}

}  // namespace gonio::io
