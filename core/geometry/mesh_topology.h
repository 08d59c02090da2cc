// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

/// Which corners of triangles meet, by the places of the vertices: files repeat a vertex where texture or normal
/// change.
namespace gonio {

/// A triangle of a mesh: three indices of vertices, counter-clockwise as seen from outside.
using TriangleIndices = glm::uvec3;

/// For each vertex the number of the first vertex (in the order of the indices) at the same place. O(n log n).
std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions);

/// An edge, by the two triangles that it lies between.
struct SharedEdge {
  std::uint32_t triangle, other;
};

/// All edges of a closed, evenly wound surface: each lies between exactly two triangles that run through it in opposite
/// directions. None where an edge is otherwise. The triangles' indices are welded ones. O(n log n).
std::optional<std::vector<SharedEdge>> closedEdges(std::span<const TriangleIndices> welded);

}  // namespace gonio
