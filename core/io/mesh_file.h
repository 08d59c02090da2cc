// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
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

/// A mesh as it was read from a file.
struct MeshFile {
  geometry::TriangleMesh mesh;
  glm::dvec3 origin{0};  ///< of the positions: the coordinates in the file are origin + position (localPositions())
  std::vector<std::string> notes;  ///< what the reader changed, for people
};

/// All content of a file as one mesh. @throws Error that names the file, for an unknown suffix or as the format's
/// reader.
MeshFile readMesh(const std::filesystem::path& path);

/// For readers: positions in single precision, relative to an origin. The origin is 0 unless that would change the
/// shape: for coordinates above 64 times the extent of the mesh, as of maps and large CAD models, it is the centre of
/// the bounds.
std::vector<glm::vec3> localPositions(std::span<const glm::dvec3> positions, glm::dvec3& origin);

/// Meshes in Wavefront OBJ files. Reads the lines v (positions), vn (normals) and f (faces: positions, or positions and
/// normals, counted from 1, or from the end if negative), all groups and objects as one mesh; triangulatePolygon()
/// triangulates faces of more than three corners. Texture coordinates, materials, lines and curves are ignored. Normals
/// that do not exist (index 0 or too high) or are not finite are computed, and faces of fewer than three corners are
/// left out, with a note: the shape does not need them. Other numbers are parsed strictly, unlike in common loaders,
/// which read invalid numbers as 0.
/// @throws Error that names the file and the line, what was found and what was expected; Error if there are no faces,
/// or more than 2 GB or 100 million triangles; Error as the constructor of TriangleMesh; Cancelled.
MeshFile readObj(const std::filesystem::path& path, const TaskControl& control = {});
/// The same for bytes; errors name no file.
MeshFile readObj(const ByteSource& source, const TaskControl& control = {});

/// Meshes in Stanford PLY files (Turk 1994, "The PLY Polygon File Format"), text or binary in either byte order: the
/// properties x, y, z and, if present, nx, ny, nz of the element "vertex", and the list vertex_indices or vertex_index
/// of the elements "face" and "tristrips" (strips of triangles, which -1 ends), in any order of the elements;
/// triangulatePolygon() triangulates faces of more than three corners. All other content is ignored. Parsed strictly by
/// our own reader, because Assimp 5.2 crashed on damaged files.
/// @throws Error that states the line of the header or the element, what was found and what was expected; Error if
/// there are no faces, or more than 2 GB or 100 million triangles; Error as the constructor of TriangleMesh.
MeshFile readPly(const ByteSource& source);

/// Meshes in STL files (3D Systems 1989), binary and text. Their normals, which are those of the faces, are computed
/// from the corners; the attributes of binary files are ignored. @throws Error that states what was found and what was
/// expected; Error if there are no triangles or more than 2 GB; Error as the constructor of TriangleMesh.
MeshFile readStl(const ByteSource& source);

/// The mesh with its shading normals as binary little-endian PLY, float32 and int32. Writes a vertex for each distinct
/// pair of position and corner normal, since the format only has normals at vertices. O(corners).
std::vector<std::byte> encodePly(const geometry::TriangleMesh& mesh);

/// Meshes in glTF 2.0 files (Khronos Group 2021, ISO/IEC 12113:2022), text (.gltf) and binary (.glb): all triangles of
/// the default scene, with the transforms of its nodes applied, as one mesh. Skinned meshes are placed by their joints
/// and not by their node, and morph targets have their default weights, as the specification says. Accessors may be
/// sparse and quantised. Materials, texture coordinates, animations, points and lines are ignored.
/// @param folder for relative URIs of buffers; empty: no other files are opened.
/// @throws Error that states the member, what was found and what was expected; Error if the file requires an extension
/// that may change the shape, such as compressed geometry (Draco, meshopt), has no triangles, or has more than 2 GB or
/// 100 million triangles; Error as the constructor of TriangleMesh.
MeshFile readGltf(const ByteSource& source, const std::optional<std::filesystem::path>& folder = {});

}  // namespace gonio::io
