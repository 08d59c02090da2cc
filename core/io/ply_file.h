// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"

/// Meshes in Stanford PLY files (Turk 1994, "The PLY Polygon File Format"), text or binary in either byte order: the
/// properties x, y, z and, if present, nx, ny, nz of the element "vertex", and the list vertex_indices or vertex_index
/// of the element "face"; triangulatePolygon() triangulates faces of more than three corners. All other content is
/// ignored. Parsed strictly by our own reader, because Assimp 5.2 crashed on damaged files.
namespace gonio::io {

/// @throws Error that states the line of the header or the element, what was found and what was expected; Error if
/// there are no faces, or more than 2 GB or 100 million triangles; Error as the constructor of TriangleMesh.
TriangleMesh readPly(const ByteSource& source);

/// The mesh with its shading normals as binary little-endian PLY, float32 and int32. Writes a vertex for each distinct
/// pair of position and corner normal, since the format only has normals at vertices. O(corners).
std::vector<std::byte> encodePly(const TriangleMesh& mesh);

}  // namespace gonio::io
