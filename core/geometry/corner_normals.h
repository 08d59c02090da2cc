// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/geometry/mesh_topology.h"
#include "core/math/types.h"

namespace gonio {

/// Faces whose normals are further apart (rad) meet in a crease and are shaded apart.
inline constexpr double creaseAngle = radians(40);

/// Twice the area times the unit normal of a triangle, by the right hand from its winding. In double: exact but for the
/// rounding of products.
Direction areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Shading normals of all corners, 3 a triangle, unit: the mean of the face normals about the corner's place that are
/// within creaseAngle of the corner's own face, weighted by the faces' angles there (Thürmer and Wüthrich 1998,
/// "Computing Vertex Normals from Polygonal Facets"). So a cube stays sharp and a torus is smooth, and how a face is
/// cut into triangles does not matter. Where more than 1000 faces meet, a corner takes its face's own. `welded` are the
/// triangles with welded vertices, none degenerate. O(corners x faces about a vertex).
std::vector<glm::vec3> makeCornerNormals(std::span<const glm::vec3> positions, std::span<const TriangleIndices> welded);

}  // namespace gonio
