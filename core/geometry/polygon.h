// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/geometry/triangle_mesh.h"

namespace gonio::geometry {

/// Triangulates a polygon of n >= 3 corners, planar or nearly so, convex or not, into n - 2 triangles of its corners (0
/// to n - 1) with the same winding, by ear clipping (Meisters 1975, "Polygons Have Ears"). A convex quadrangle is cut
/// along its shorter diagonal. Corners on a straight line are cut last, to avoid triangles without area if possible.
/// For self-intersecting polygons and those without area the result is some triangulation. O(n) for convex polygons,
/// otherwise typically O(n^2), limited to 10000 n steps; then the rest becomes a fan.
std::vector<TriangleIndices> triangulatePolygon(std::span<const glm::vec3> corners);

}  // namespace gonio::geometry
