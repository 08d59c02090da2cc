// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/math/types.h"

/// Two-dimensional functions on the unit square that depend on two parameters (the azimuth and the polar angle of a
/// direction), as the EPFL RGL database stores them: bilinear between the nodes of a grid, and bilinear in the
/// parameters. Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and Rendering" (2018).
namespace gonio {

/// The up to four slices (pairs of parameter nodes) that a pair of parameter values lies between.
struct SliceBlend {
  int count = 0;
  std::array<std::uint32_t, 4> slice{};
  std::array<double, 4> weight{};  ///< they sum to 1; none is 0
};

/// The parameter nodes: slice = phi index * thetas.size() + theta index.
class ParameterGrid {
 public:
  /// Both strictly increasing, rad, at least one value each.
  ParameterGrid(std::vector<float> phis, std::vector<float> thetas);
  std::size_t slices() const { return phis_.size() * thetas_.size(); }
  const std::vector<float>& phis() const { return phis_; }
  const std::vector<float>& thetas() const { return thetas_; }
  /// Values outside the nodes are clamped to them.
  SliceBlend blend(double phi, double theta) const;

 private:
  std::vector<float> phis_, thetas_;
};

/// The cell of a width x height grid of nodes (at least 2 x 2) over the unit square that a point lies in.
struct GridCell {
  std::size_t column = 0, row = 0;
  double x = 0, y = 0;  ///< position inside the cell, [0, 1]
};
GridCell gridCell(const glm::dvec2& point, std::size_t width, std::size_t height);

/// Slices of values at the nodes of a grid; rows run slowest.
template <typename Value>
struct SliceStack {
  std::size_t width = 0, height = 0;
  std::vector<Value> values;

  const Value* node(std::size_t slice, std::size_t row, std::size_t column) const {
    return &values[(slice * height + row) * width + column];
  }
};

/// Bilinear interpolation. `Sum` is the type in which it is computed.
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

/// The map that carries a density on the unit square to the uniform one, by its marginal distribution over rows (y) and
/// its conditional one inside a row (x). The density is a bilinear interpolant, each slice scaled to the integral 1.
class MarginalWarp {
 public:
  /// What a slice without a positive value becomes.
  enum class EmptySlice { refused, uniform };

  /// @throws Error naming `name` where a value is negative, or a slice without a positive one is refused.
  MarginalWarp(SliceStack<float> density, const std::string& name, EmptySlice empty = EmptySlice::refused);

  struct Sample {
    glm::dvec2 point{0};
    double density = 0;  ///< at the point, of the unit square
  };

  /// Where the map takes a point: x = conditional distribution at point.x, y = marginal distribution at point.y.
  /// With the density there.
  Sample invert(const SliceBlend& blend, const glm::dvec2& point) const;
  /// The inverse: a point drawn from the density by two uniform numbers in [0, 1], and its density. Two binary
  /// searches.
  Sample sample(const SliceBlend& blend, const glm::dvec2& u) const;
  /// Of the unit square: integrates to 1.
  double density(const SliceBlend& blend, const glm::dvec2& point) const;

  /// The density of each slice in units of a cell: what density() returns is this times the number of cells.
  const SliceStack<float>& cellDensity() const { return density_; }
  /// Integral of each row up to a node, in cells; the last of a row is the row's total.
  const SliceStack<float>& conditional() const { return conditional_; }
  /// Integral over the rows up to a row; [slice][row], the last of a slice 1.
  const std::vector<float>& marginal() const { return marginal_; }

 private:
  struct Strip;
  Strip strip(const SliceBlend& blend, std::size_t row) const;
  double cells() const { return double(density_.width - 1) * double(density_.height - 1); }

  SliceStack<float> density_, conditional_;
  std::vector<float> marginal_;
};

}  // namespace gonio
