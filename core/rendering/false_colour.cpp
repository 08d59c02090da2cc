// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/false_colour.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace gonio {

namespace {

/// Linear between anchors that are spaced evenly over [0, 1].
DisplayColour between(std::span<const DisplayColour> anchors, double x) {
  const double at = (x > 0 ? std::min(x, 1.0) : 0.0) * double(anchors.size() - 1);
  const std::size_t low = std::min(std::size_t(at), anchors.size() - 2);
  DisplayColour colour;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] =
        std::uint8_t(std::lround(anchors[low][c] + (at - double(low)) * (anchors[low + 1][c] - anchors[low][c])));
  return colour;
}

}  // namespace

DisplayColour viridis(double x) {
  constexpr DisplayColour anchors[] = {{68, 1, 84},    {72, 40, 120},  {62, 73, 137},  {49, 104, 142}, {38, 130, 142},
                                       {31, 158, 137}, {53, 183, 121}, {110, 206, 88}, {181, 222, 43}, {253, 231, 37}};
  return between(anchors, x);
}

DisplayColour signedColour(double x) {
  constexpr DisplayColour anchors[] = {{196, 232, 255}, {66, 150, 230}, {18, 18, 20}, {226, 120, 40}, {255, 226, 180}};
  return between(anchors, 0.5 + 0.5 * x);
}

}  // namespace gonio
