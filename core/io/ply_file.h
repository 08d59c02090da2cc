// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"

/// Meshes in Stanford PLY files (Turk 1994, "The PLY Polygon File Format"), as text and binary of either byte order:
/// the properties x, y, z and, where they are there, nx, ny, nz of the element "vertex", and the list vertex_indices or
/// vertex_index of the element "face"; faces of more than three corners are cut by cutPolygon(). All else is passed
/// over. Read strictly, as OBJ files are; the loader at hand (Assimp 5.2) crashed on damaged files.
namespace gonio::io {

/// @throws Error with the line of the header, or the element, what was found and what was expected; where there are no
/// faces; over 2 GB or 100 million triangles; as TriangleMesh does.
TriangleMesh readPly(const ByteSource& source);

/// The mesh with its shading normals as binary little-endian PLY, float32 and int32: a vertex for each pair of a
/// position and a normal that a corner has, since the format has normals at vertices alone. O(corners).
std::vector<std::byte> encodePly(const TriangleMesh& mesh);

}  // namespace gonio::io
