// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gonio::factorization {

/// Where the cell of a node begins and ends: half way to its neighbours, at the node itself where there is none.
inline std::pair<double, double> nodeCell(const std::vector<double>& nodes, std::size_t i) {
  return {(nodes[i == 0 ? 0 : i - 1] + nodes[i]) / 2, (nodes[i] + nodes[std::min(i + 1, nodes.size() - 1)]) / 2};
}

inline double nodeSpacing(const std::vector<double>& nodes, std::size_t i) {
  const auto [begin, end] = nodeCell(nodes, i);
  return end - begin;
}

/// Solid angle of a polar node's cell for a unit of azimuth.
inline double solidAngle(const std::vector<double>& nodes, std::size_t i) {
  const auto [begin, end] = nodeCell(nodes, i);
  return std::cos(begin) - std::cos(end);
}

}  // namespace gonio::factorization
