// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio {

/// Slopes of the cubic curve through points that rises and falls only where the points do: Fritsch and Butland 1984, "A
/// Method for Constructing Local Monotone Piecewise Cubic Interpolants" (the weighted harmonic mean; 0 at extremes).
/// @param nodes strictly increasing, as many as values, at least one.
std::vector<double> monotoneSlopes(std::span<const double> nodes, std::span<const double> values);

/// Where a coordinate lies between nodes; beyond the ends it is held at the end.
struct NodePlace {
  std::size_t index;  ///< of the node before; index + 1 is a node too, unless there is only one
  double fraction;    ///< of the way to the next, [0, 1]
};
NodePlace placeBetween(std::span<const double> nodes, double x);

/// Weights of two nodes' values and slopes in the cubic between them (Hermite), the slopes' times the distance.
struct HermiteWeights {
  double before, after, slopeBefore, slopeAfter;

  HermiteWeights(double fraction, double distance) {
    const double t = fraction, s = 1 - fraction;
    before = s * s * (1 + 2 * t);
    after = t * t * (1 + 2 * s);
    slopeBefore = distance * t * s * s;
    slopeAfter = -distance * t * t * s;
  }
};

/// The curve at x. O(log n).
double evaluateMonotoneCubic(std::span<const double> nodes, std::span<const double> values,
                             std::span<const double> slopes, double x);

}  // namespace gonio
