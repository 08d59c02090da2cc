// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"
#include "core/support/task_control.h"

/// Meshes in Wavefront OBJ files: of the text, the lines v (positions), vn (normals) and f (faces: positions, or
/// positions and normals, counted from 1, or from the end where negative) are read, all groups and objects as one mesh;
/// faces of more than three corners are cut by cutPolygon(). Texture coordinates, materials, lines and curves are left
/// out. Numbers are read strictly, which the loaders at hand do not do: they take what is no number for 0.
namespace gonio::io {

/// @throws Error naming the file: the line, what was found there and what was expected; where there are no faces; over
/// 2 GB or 100 million triangles; as TriangleMesh does. @throws Cancelled.
TriangleMesh readObj(const std::filesystem::path& path, const TaskControl& control = {});
/// The same of bytes; an error names no file.
TriangleMesh readObj(const ByteSource& source, const TaskControl& control = {});

}  // namespace gonio::io
