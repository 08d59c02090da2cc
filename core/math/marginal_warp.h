// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/math/types.h"

/// Functions on the unit square that depend on two parameters (azimuth and polar angle of a direction), as in the EPFL
/// RGL database: bilinear between the nodes of a grid, and bilinear in the parameters. Dupuy and Jakob, "An Adaptive
/// Parameterization for Efficient Material Acquisition and Rendering" (2018).
namespace gonio {

/// The up to four slices (pairs of parameter nodes) around a pair of parameter values, with bilinear weights.
struct SliceBlend {
  int count = 0;
  std::array<std::uint32_t, 4> slice{};
  std::array<double, 4> weight{};  ///< sum 1; none is 0
};

/// The parameter nodes. The index of a slice is phi index * thetas.size() + theta index.
class ParameterGrid {
 public:
  /// @param phis, thetas strictly increasing, rad, at least one value each.
  ParameterGrid(std::vector<float> phis, std::vector<float> thetas);
  std::size_t slices() const { return phis_.size() * thetas_.size(); }
  const std::vector<float>& phis() const { return phis_; }
  const std::vector<float>& thetas() const { return thetas_; }
  /// Values outside the nodes are clamped to them.
  SliceBlend blend(double phi, double theta) const;

 private:
  std::vector<float> phis_, thetas_;
};

/// The cell of a point in a width x height grid of nodes (at least 2 x 2) over the unit square.
struct GridCell {
  std::size_t column = 0, row = 0;
  double x = 0, y = 0;  ///< position inside the cell, [0, 1]
};
inline GridCell gridCell(const glm::dvec2& point, std::size_t width, std::size_t height) {
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

/// Values at the nodes of a grid, [slice][row][column].
template <typename Value>
struct SliceStack {
  std::size_t width = 0, height = 0;
  std::vector<Value> values;

  const Value* node(std::size_t slice, std::size_t row, std::size_t column) const {
    return &values[(slice * height + row) * width + column];
  }
};

/// Bilinear interpolation on the square and between slices. `Sum` is the type of the computation.
template <typename Sum, typename Value>
Sum interpolate(const SliceStack<Value>& stack, const SliceBlend& blend, const glm::dvec2& point) {
  const GridCell cell = gridCell(point, stack.width, stack.height);
  Sum sum(0);
  for (int i = 0; i < blend.count; ++i) {
    const Value* low = stack.node(blend.slice[i], cell.row, cell.column);
    const Value* high = low + stack.width;
    sum += blend.weight[i] * ((1 - cell.y) * ((1 - cell.x) * Sum(low[0]) + cell.x * Sum(low[1])) +
                              cell.y * ((1 - cell.x) * Sum(high[0]) + cell.x * Sum(high[1])));
  }
  return sum;
}

/// The map from a density on the unit square to the uniform density, by the marginal distribution over rows (y) and the
/// conditional distribution in a row (x). The density is a bilinear interpolant; each slice is normalised to integral
/// 1.
class MarginalWarp {
 public:
  /// Treatment of a slice without positive values: an error, or the uniform density.
  enum class EmptySlice { refused, uniform };

  /// @throws Error with `name` if a value is negative, or a slice has no positive value (EmptySlice::refused).
  MarginalWarp(SliceStack<float> density, const std::string& name, EmptySlice empty = EmptySlice::refused);

  struct Sample {
    glm::dvec2 point{0};
    double density = 0;  ///< at the point, per unit area of the square
  };

  /// Maps a point of the density to the uniform square (x: conditional distribution at point.x, y: marginal
  /// distribution at point.y), with the density at `point`.
  Sample invert(const SliceBlend& blend, const glm::dvec2& point) const;
  /// Samples the density, the inverse of invert(): a point from two uniform numbers in [0, 1], and its density. Two
  /// binary searches.
  Sample sample(const SliceBlend& blend, const glm::dvec2& u) const;
  /// Density per unit area; integrates to 1 over the square.
  double density(const SliceBlend& blend, const glm::dvec2& point) const;

  /// The density of each slice per cell: density() is this times the number of cells.
  const SliceStack<float>& cellDensity() const { return density_; }
  /// Integral of each row up to a node, per cell; the last value of a row is its total.
  const SliceStack<float>& conditional() const { return conditional_; }
  /// Integral over the rows up to a row, [slice][row]; the last value of a slice is 1.
  const std::vector<float>& marginal() const { return marginal_; }

 private:
  struct Strip;
  Strip strip(const SliceBlend& blend, std::size_t row) const;
  double cells() const { return double(density_.width - 1) * double(density_.height - 1); }

  SliceStack<float> density_, conditional_;
  std::vector<float> marginal_;
};

}  // namespace gonio
