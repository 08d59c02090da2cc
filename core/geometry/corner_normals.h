// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/geometry/mesh_topology.h"
#include "core/math/types.h"

namespace gonio {

/// Two faces form a crease, without a common shading normal, if the angle between their normals exceeds this (rad).
inline constexpr double creaseAngle = radians(40);

/// Twice the area times the unit normal of a triangle, by the right-hand rule from its winding. Computed in double
/// precision.
Direction areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Unit shading normals of all corners, 3 per triangle: the mean of the face normals at the corner's vertex that are
/// within creaseAngle of the corner's own face, weighted by the faces' angles there (Thürmer and Wüthrich 1998,
/// "Computing Vertex Normals from Polygonal Facets"). Thus a cube is sharp and a torus smooth, independently of the
/// triangulation of faces. Corners at vertices with more than 1000 faces have the normal of their face.
/// @param welded triangles with welded vertices (weldedVertices()), none degenerate. O(corners x faces per vertex).
std::vector<glm::vec3> makeCornerNormals(std::span<const glm::vec3> positions, std::span<const TriangleIndices> welded);

}  // namespace gonio
