// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

/// Topology of triangle meshes by the positions of vertices, since files repeat a vertex where texture coordinates or
/// normals differ.
namespace gonio {

/// A triangle of a mesh: three indices of vertices, counter-clockwise as seen from outside.
using TriangleIndices = glm::uvec3;

/// For each vertex, the lowest index of a vertex at the same position. O(n log n).
std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions);

/// An edge, as the indices of its two triangles.
struct SharedEdge {
  std::uint32_t triangle, other;
};

/// All edges of a closed, consistently wound surface, where each edge belongs to exactly two triangles, in opposite
/// directions; empty for any other surface. @param welded triangles with welded vertices. O(n log n).
std::optional<std::vector<SharedEdge>> closedEdges(std::span<const TriangleIndices> welded);

}  // namespace gonio
