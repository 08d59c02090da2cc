// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/plotted_values.h"

namespace gonio::plots {

/// How theta_h is laid out in a slice.
enum class ThetaHSpacing {
  linear,     ///< even
  squareRoot  ///< theta_h = u^2 pi/2 for u in [0, 1]: MERL's own spacing, wide at the highlight
};

/// The plane theta_h by theta_d of half-difference space at one phi_d, as a picture.
struct Slice {
  int width = 0;   ///< along theta_h
  int height = 0;  ///< along theta_d
  ThetaHSpacing spacing = ThetaHSpacing::squareRoot;
  double phiD = halfPi;  ///< rad
  PlottedValues cells;   ///< theta_h runs fastest

  /// Angles of the middle of a column and of a row, rad.
  double thetaH(int column) const;
  double thetaD(int row) const;
  std::size_t index(int column, int row) const { return std::size_t(row) * std::size_t(width) + std::size_t(column); }
};

/// Place of theta_h along the axis, [0, 1], and back.
double thetaHShare(ThetaHSpacing spacing, double thetaH);
double thetaHAt(ThetaHSpacing spacing, double fraction);

/// `size` by `size` cells (a MERL table has 90). Some ms.
Slice halfDifferenceSlice(const Brdf& brdf, double phiD, ThetaHSpacing spacing, CosineFactor cosine,
                          const TabulatedBrdf* coverage = nullptr, int size = 90);

}  // namespace gonio::plots
