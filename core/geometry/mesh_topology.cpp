// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/mesh_topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gonio {

namespace {

/// An edge of one triangle under the smaller of its vertices.
struct HalfEdge {
  std::uint32_t low, high, triangle;
  bool ascending;

  bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

}  // namespace

std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto keyA = key(a), keyB = key(b);
    return keyA != keyB ? keyA < keyB : a < b;
  });
  std::vector<std::uint32_t> result(positions.size());
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    if (key(order[i]) != key(order[first])) first = i;
    result[order[i]] = order[first];
  }
  return result;
}

std::optional<std::vector<SharedEdge>> closedEdges(std::span<const TriangleIndices> welded) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * welded.size());
  for (std::size_t triangle = 0; triangle < welded.size(); ++triangle)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = welded[triangle][i], to = welded[triangle][(i + 1) % 3];
      halves.push_back({std::min(from, to), std::max(from, to), std::uint32_t(triangle), from < to});
    }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  if (halves.size() % 2 != 0) return std::nullopt;
  std::vector<SharedEdge> edges;
  edges.reserve(halves.size() / 2);
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const HalfEdge &a = halves[i], &b = halves[i + 1];
    const bool third = i + 2 < halves.size() && halves[i + 2].sameEdge(a);
    if (!a.sameEdge(b) || a.ascending == b.ascending || third) return std::nullopt;
    edges.push_back({a.triangle, b.triangle});
  }
  return edges;
}

}  // namespace gonio
