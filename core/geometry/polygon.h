// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/geometry/mesh_topology.h"

namespace gonio {

/// Cuts a polygon of n >= 3 corners, flat or nearly so, convex or not, into n - 2 triangles of its corners (0 to n - 1)
/// with its winding, by clipping ears (Meisters 1975, "Polygons Have Ears"); a convex quadrangle along its shorter
/// diagonal. Corners in line with their neighbours come last, so that no triangle is without an area where that can be
/// had. What crosses itself or has no area is cut somehow. O(n) for a convex polygon, else O(n^2) as a rule and at most
/// 10000 n: what is left then is cut into a fan.
std::vector<TriangleIndices> cutPolygon(std::span<const glm::vec3> corners);

}  // namespace gonio
