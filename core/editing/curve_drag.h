// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio::editing {

/// A drag of control points on a curve; the curve follows the points smoothly, without overshoot between them.
struct CurveDrag {
  enum class Mode {
    add,      ///< amounts are added to the curve; 0: no change
    multiply  ///< the curve is multiplied by the amounts; 1: no change
  };
  std::vector<double> from;     ///< positions of the points before the drag, strictly increasing
  std::vector<double> to;       ///< positions after the drag, strictly increasing
  std::vector<double> amounts;  ///< one per point
  Mode mode = Mode::add;
};

/// The curve after the drag: stretched along its axis as the points move (the ends of the axis stay fixed), then
/// changed by the difference (add) or the ratio (multiply) of two monotone cubics: that through the values of the
/// points after the drag, and that through their values before it. Detail between the points is preserved. Where the
/// curve rises or falls between two points, it does so after the drag, as the points do. Negative values become 0.
/// @param nodes strictly increasing, one per value of the curve.
std::vector<double> draggedCurve(std::span<const double> nodes, std::span<const double> curve, const CurveDrag& drag);

/// Selects nodes, including the ends, such that a monotone cubic through them approximates the curve to within
/// `fraction` of its largest absolute value. Returns at most `maxNodes` nodes, but at least two (one for a curve of one
/// node).
std::vector<double> controlPoints(std::span<const double> nodes, std::span<const double> curve, double fraction,
                                  int maxNodes);

}  // namespace gonio::editing
