// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "core/brdf/data_transform.h"
#include "core/brdf/tabulated_brdf.h"

namespace gonio::dictionary {

/// What the cells of a grid have in common for all tables.
struct GridGeometry {
  Eigen::ArrayXf weights;                  ///< cosineWeight(); that of the floor beyond the horizon
  std::vector<std::uint8_t> aboveHorizon;  ///< 1 where both directions are at or above the horizon
  /// For each mode (phi_d, theta_d, theta_h) the factors by which signals are scaled: their product is about the square
  /// root of a cell's projected solid angles of both directions (cos theta_h cos theta_d stands for either cosine, so
  /// that it is a product). Coefficients then go where pictures show it, not where nodes crowd. The mean square of each
  /// mode is 1, no square is below a hundredth of the mode's largest.
  std::array<Eigen::ArrayXd, 3> importance;

  /// Computed once for a grid (some 100 ms), then shared.
  static std::shared_ptr<const GridGeometry> of(const HalfDifferenceGrid& grid);
};

/// The three channels of a table, transformed, every cell filled, scaled by the importance: what dictionaries are
/// trained on and what is encoded. Invalid cells hold, along theta_h (toward the horizon), the transformed value of the
/// last valid one: no dictionary may spend coefficients on a cliff at the horizon that is not there. In single
/// precision, without cancellation for small values. About 20 ms for a MERL table.
std::array<Eigen::ArrayXf, 3> signalsOf(const TabulatedBrdf& table, DataTransform transform,
                                        const GridGeometry& geometry);

/// In place: reflectances (1/sr, >= 0) become transformed values, and back, as transformed() and inverseTransformed()
/// do in double. Back, values that no reflectance has give 0, and those beyond the range of float its largest number
/// (a code of few coefficients may overshoot).
void transform(Eigen::Ref<Eigen::ArrayXf> values, DataTransform transform,
               const Eigen::Ref<const Eigen::ArrayXf>& weights);
void invertTransform(Eigen::Ref<Eigen::ArrayXf> values, DataTransform transform,
                     const Eigen::Ref<const Eigen::ArrayXf>& weights);

}  // namespace gonio::dictionary
