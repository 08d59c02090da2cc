// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio {

/// Slopes at the points of a monotone cubic interpolant, which rises and falls only where the points do: Fritsch and
/// Butland 1984, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants" (weighted harmonic mean; 0 at
/// extrema). @param nodes strictly increasing, one per value, at least one.
std::vector<double> monotoneSlopes(std::span<const double> nodes, std::span<const double> values);

/// The interval of nodes that contains a coordinate, and the position in it, clamped to the ends.
struct NodeInterval {
  std::size_t index;  ///< of the lower node; index + 1 is a node too, unless there is only one
  double fraction;    ///< position between the nodes, [0, 1]
};
NodeInterval findInterval(std::span<const double> nodes, double x);

/// Hermite weights of the values and slopes of two nodes; those of the slopes include the distance between the nodes.
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
