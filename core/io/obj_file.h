// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"
#include "core/support/task_control.h"

/// Meshes in Wavefront OBJ files. Reads the lines v (positions), vn (normals) and f (faces: positions, or positions and
/// normals, counted from 1, or from the end if negative), all groups and objects as one mesh; triangulatePolygon()
/// triangulates faces of more than three corners. Texture coordinates, materials, lines and curves are ignored. Numbers
/// are parsed strictly, unlike in common loaders, which read invalid numbers as 0.
namespace gonio::io {

/// @throws Error that names the file and the line, what was found and what was expected; Error if there are no faces,
/// or more than 2 GB or 100 million triangles; Error as the constructor of TriangleMesh; Cancelled.
TriangleMesh readObj(const std::filesystem::path& path, const TaskControl& control = {});
/// The same for bytes; errors name no file.
TriangleMesh readObj(const ByteSource& source, const TaskControl& control = {});

}  // namespace gonio::io
