// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"
#include "core/support/task_control.h"

/// Reading and writing of meshes in all supported formats.
namespace gonio::io {

/// The suffixes with their dots, in the order of display.
const std::vector<std::string>& meshSuffixes();
/// The suffixes separated by spaces, each after `prefix`: "*.obj *.ply ..." for "*".
std::string meshSuffixList(const std::string& prefix = {});
/// Whether the suffix is that of a mesh format, in upper or lower case.
bool isMeshFile(const std::filesystem::path& path);

/// All content of a file as one mesh. @throws Error that names the file, for an unknown suffix or as the format's
/// reader.
geometry::TriangleMesh readMesh(const std::filesystem::path& path);

/// Meshes in Wavefront OBJ files. Reads the lines v (positions), vn (normals) and f (faces: positions, or positions and
/// normals, counted from 1, or from the end if negative), all groups and objects as one mesh; triangulatePolygon()
/// triangulates faces of more than three corners. Texture coordinates, materials, lines and curves are ignored. Numbers
/// are parsed strictly, unlike in common loaders, which read invalid numbers as 0.
/// @throws Error that names the file and the line, what was found and what was expected; Error if there are no faces,
/// or more than 2 GB or 100 million triangles; Error as the constructor of TriangleMesh; Cancelled.
geometry::TriangleMesh readObj(const std::filesystem::path& path, const TaskControl& control = {});
/// The same for bytes; errors name no file.
geometry::TriangleMesh readObj(const ByteSource& source, const TaskControl& control = {});

/// Meshes in Stanford PLY files (Turk 1994, "The PLY Polygon File Format"), text or binary in either byte order: the
/// properties x, y, z and, if present, nx, ny, nz of the element "vertex", and the list vertex_indices or vertex_index
/// of the element "face"; triangulatePolygon() triangulates faces of more than three corners. All other content is
/// ignored. Parsed strictly by our own reader, because Assimp 5.2 crashed on damaged files.
/// @throws Error that states the line of the header or the element, what was found and what was expected; Error if
/// there are no faces, or more than 2 GB or 100 million triangles; Error as the constructor of TriangleMesh.
geometry::TriangleMesh readPly(const ByteSource& source);

/// The mesh with its shading normals as binary little-endian PLY, float32 and int32. Writes a vertex for each distinct
/// pair of position and corner normal, since the format only has normals at vertices. O(corners).
std::vector<std::byte> encodePly(const geometry::TriangleMesh& mesh);

/// Meshes in glTF 2.0 files (Khronos Group 2021, ISO/IEC 12113:2022), text (.gltf) and binary (.glb): all triangles of
/// the default scene, with the transforms of its nodes applied, as one mesh. Materials, texture coordinates, skins,
/// morph targets, animations, points and lines are ignored.
/// @param folder for relative URIs of buffers; empty: no other files are opened.
/// @throws Error that states the member, what was found and what was expected; Error if the file requires compressed
/// geometry (Draco, meshopt, quantisation) or sparse accessors, has no triangles, or has more than 2 GB or 100 million
/// triangles; Error as the constructor of TriangleMesh.
geometry::TriangleMesh readGltf(const ByteSource& source, const std::optional<std::filesystem::path>& folder = {});

}  // namespace gonio::io
