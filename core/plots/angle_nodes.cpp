// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/angle_nodes.h"

#include <algorithm>
#include <cmath>

namespace gonio::plots {

std::vector<double> nodesAbout(double centre, double first, double last, int count, double density) {
  centre = std::clamp(centre, first, last);
  // x = centre + scale sinh(t), t even from `from` to `to`: dx/dt grows from scale to scale cosh(t).
  const double farthest = std::max(last - centre, centre - first);
  const double scale = farthest / std::sqrt(density * density - 1);
  const double from = std::asinh((first - centre) / scale), to = std::asinh((last - centre) / scale);
  std::vector<double> nodes(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    nodes[std::size_t(i)] = centre + scale * std::sinh(from + (to - from) * i / double(count - 1));
  nodes.front() = first;
  nodes.back() = last;
  return nodes;
}

}  // namespace gonio::plots
