// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/unguided_selection.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <random>

namespace gonio::acquisition {

namespace {

/// Point `index` of R_3 in [0, 1)^3: multiples of the powers of 1 / g, g^4 = g + 1.
glm::dvec3 spreadPoint(std::size_t index) {
  constexpr double g = 1.2207440846057596;
  const glm::dvec3 step(1 / g, 1 / (g * g), 1 / (g * g * g));
  return glm::fract(0.5 + double(index + 1) * step);
}

/// Cells in ascending order and the measure before each.
class CumulativeMeasure {
 public:
  CumulativeMeasure(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells)
      : grid_(grid), cells_(cells), before_(cells.size() + 1, 0.0) {
    for (std::size_t i = 0; i < cells.size(); ++i) before_[i + 1] = before_[i] + grid.cellMeasure(cells[i]);
  }

  /// The fraction of the measure picks theta_h, its fraction of that theta_d, then phi_d.
  std::size_t at(const glm::dvec3& fractions) const {
    const std::size_t line = std::size_t(grid_.phiDCount), slice = line * std::size_t(grid_.thetaDCount);
    const Range thetaH = neighbours(within({0, cells_.size()}, fractions.x), slice);
    return within(neighbours(within(thetaH, fractions.y), line), fractions.z);
  }

 private:
  struct Range {
    std::size_t begin, end;
  };

  /// The index at a fraction of a range's measure.
  std::size_t within(const Range& range, double fraction) const {
    const double target = before_[range.begin] + fraction * (before_[range.end] - before_[range.begin]);
    const auto first = before_.begin() + std::ptrdiff_t(range.begin) + 1,
               last = before_.begin() + std::ptrdiff_t(range.end);
    return std::min(std::size_t(std::upper_bound(first, last, target) - before_.begin()), range.end) - 1;
  }
  /// The indices whose cells lie in the same group of `size` cells of the grid.
  Range neighbours(std::size_t index, std::size_t size) const {
    const std::size_t group = cells_[index] / size;
    const auto bound = [&](std::size_t cell) {
      return std::size_t(std::lower_bound(cells_.begin(), cells_.end(), cell) - cells_.begin());
    };
    return {bound(group * size), bound((group + 1) * size)};
  }

  const HalfDifferenceGrid& grid_;
  std::span<const std::uint32_t> cells_;
  std::vector<double> before_;
};

}  // namespace

std::vector<std::size_t> randomIndices(std::size_t count, std::size_t samples, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  const std::size_t chosen = std::min(samples, count);
  for (std::size_t i = 0; i < chosen; ++i)
    std::swap(indices[i], indices[std::uniform_int_distribution<std::size_t>(i, count - 1)(random)]);
  indices.resize(chosen);
  return indices;
}

std::vector<std::size_t> evenlySpreadIndices(const HalfDifferenceGrid& grid, std::span<const std::uint32_t> cells,
                                             std::size_t samples) {
  const CumulativeMeasure measure(grid, cells);
  std::vector<char> taken(cells.size(), 0);
  std::vector<std::size_t> result;
  for (std::size_t point = 0; result.size() < std::min(samples, cells.size()); ++point) {
    std::size_t index = measure.at(spreadPoint(point));
    while (taken[index]) index = (index + 1) % cells.size();
    taken[index] = 1;
    result.push_back(index);
  }
  return result;
}

}  // namespace gonio::acquisition
