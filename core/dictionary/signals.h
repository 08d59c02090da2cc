// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"

namespace gonio::dictionary {

/// Properties of the cells of a grid that do not depend on the table.
struct GridGeometry {
  Eigen::ArrayXf weights;                  ///< cosineWeight(); its lower bound for cells below the horizon
  std::vector<std::uint8_t> aboveHorizon;  ///< 1 where both directions are at or above the horizon
  /// Factors of signals per mode (phi_d, theta_d, theta_h). Their product is about the square root of a cell's
  /// projected solid angles of both directions (each cosine approximated by cos theta_h cos theta_d, which makes it
  /// separable). Errors are thus weighted by their effect in images, not by the density of the nodes. The mean square
  /// of each mode is 1, and no square is below a hundredth of the mode's largest.
  std::array<Eigen::ArrayXd, 3> cellScaling;

  /// The geometry of a grid: computed at the first call (about 100 ms), then shared. Callable from several threads.
  static std::shared_ptr<const GridGeometry> of(const HalfDifferenceGrid& grid);
};

/// The signals that training and encoding use: the three channels of a table, transformed, with invalid cells filled,
/// with cell scaling (GridGeometry::cellScaling) unless `scaled` is false. Along theta_h (toward the horizon) invalid
/// cells repeat the transformed value of the last valid one, so that no coefficients are spent on an artificial step at
/// the horizon. In double precision, so that rounding does not decide which coefficients are the largest; without
/// cancellation for small values. About 40 ms for a MERL table.
std::array<Eigen::ArrayXd, 3> signalsOf(const TabulatedBrdf& table, DataTransform transform,
                                        const GridGeometry& geometry, bool scaled = true);

/// Splits signals over the whole circle of phi_d into two parts over its first half: the mean of both orders of the
/// directions, and half their difference (first minus second half). A code of both orders has coefficients of these two
/// parts over the same dictionary (inBothOrders()), sqrt 2 times as large. The second part of a reciprocal table is 0.
/// @param phiDCount number of nodes of the whole circle, even.
std::array<Eigen::ArrayXd, 2> partsOfOrders(const Eigen::ArrayXd& signal, int phiDCount);

/// The factor of each cell by cell scaling.
Eigen::ArrayXf cellScales(const HalfDifferenceGrid& grid, const GridGeometry& geometry);
/// Smallest and largest transformed value of the valid cells of a signal (without cell scaling), at most and at least
/// 0: ChannelCode::lowest and highest.
struct SignalRange {
  float lowest = 0, highest = 0;
};
SignalRange rangeOf(const Eigen::ArrayXd& signal, const TabulatedBrdf& table, const GridGeometry& geometry,
                    bool scaled);

/// transformed() and inverseTransformed() of arrays, in place. BRDF values are in 1/sr; for negative ones both are
/// continued as odd functions. The inverse limits y of the logarithms to 88, so that results stay in the range of float
/// (a code of few coefficients may overshoot). @param lowest of y, at most 0: smaller ones become `lowest`.
void transform(Eigen::Ref<Eigen::ArrayXd> values, DataTransform transform,
               const Eigen::Ref<const Eigen::ArrayXf>& weights);
void invertTransform(Eigen::Ref<Eigen::ArrayXf> values, DataTransform transform,
                     const Eigen::Ref<const Eigen::ArrayXf>& weights, float lowest = 0);
void invertTransform(Eigen::Ref<Eigen::ArrayXd> values, DataTransform transform,
                     const Eigen::Ref<const Eigen::ArrayXf>& weights, float lowest = 0);

}  // namespace gonio::dictionary
