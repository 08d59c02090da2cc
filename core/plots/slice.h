// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/plotted_values.h"

namespace gonio::plots {

/// Spacing of theta_h in a slice.
enum class ThetaHSpacing {
  linear,     ///< uniform
  squareRoot  ///< theta_h = u^2 pi/2 for u in [0, 1]: as in MERL tables, which magnifies the highlight
};

/// The plane (theta_h, theta_d) of half-difference space for one phi_d, as an image.
struct Slice {
  int width = 0;   ///< along theta_h
  int height = 0;  ///< along theta_d
  ThetaHSpacing spacing = ThetaHSpacing::squareRoot;
  double phiD = halfPi;  ///< rad
  PlottedValues cells;   ///< theta_h runs fastest

  /// Angles at the centre of a column or row, rad.
  double thetaH(int column) const;
  double thetaD(int row) const;
  std::size_t index(int column, int row) const { return std::size_t(row) * std::size_t(width) + std::size_t(column); }
};

/// Conversion of theta_h (rad) to a fraction of the axis, [0, 1], and back.
double thetaHFraction(ThetaHSpacing spacing, double thetaH);
double thetaHAt(ThetaHSpacing spacing, double fraction);

/// A slice of `size` x `size` cells (90 in MERL tables). Takes a few ms. @param coverage as in evaluatePlotted().
Slice halfDifferenceSlice(const Brdf& brdf, double phiD, ThetaHSpacing spacing, CosineFactor cosine,
                          const TabulatedBrdf* coverage = nullptr, int size = 90);

}  // namespace gonio::plots
