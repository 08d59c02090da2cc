// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio::editing {

/// What a hand does to a curve: control points that lie on it move, and the curve follows them smoothly. All curves are
/// monotone cubic, so that nothing overshoots between the points.
struct CurveDrag {
  enum class Mode {
    add,      ///< the amounts are added; 0 leaves the curve
    multiply  ///< the curve is multiplied by them; 1 leaves it
  };
  std::vector<double> from;     ///< where the points stood, strictly increasing
  std::vector<double> to;       ///< where they stand, strictly increasing; as many
  std::vector<double> amounts;  ///< one a point
  Mode mode = Mode::add;
};

/// The curve after the drag: stretched along its axis as the points move, then changed by the amounts between them;
/// values below 0 become 0. Detail that lies between the points survives.
/// @param nodes strictly increasing, as many as values. The ends of the axis stay where they are.
std::vector<double> draggedCurve(std::span<const double> nodes, std::span<const double> curve, const CurveDrag& drag);

/// Nodes whose monotone cubic follows a curve to within a fraction of its largest size: few where it is smooth. The
/// ends belong to them. At most `most`, at least two (one for a curve of one node).
std::vector<double> controlPoints(std::span<const double> nodes, std::span<const double> curve, double fraction,
                                  int most);

}  // namespace gonio::editing
