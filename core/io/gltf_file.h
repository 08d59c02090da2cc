// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"

/// Meshes in glTF 2.0 files (Khronos Group 2021, ISO/IEC 12113:2022), text (.gltf) and binary (.glb): all triangles of
/// the default scene, with the transforms of its nodes applied, as one mesh. Materials, texture coordinates, skins,
/// morph targets, animations, points and lines are ignored.
namespace gonio::io {

/// @param folder for relative URIs of buffers; empty: no other files are opened.
/// @throws Error that states the member, what was found and what was expected; Error if the file requires compressed
/// geometry (Draco, meshopt, quantisation) or sparse accessors, has no triangles, or has more than 2 GB or 100 million
/// triangles; Error as the constructor of TriangleMesh.
TriangleMesh readGltf(const ByteSource& source, const std::optional<std::filesystem::path>& folder = {});

}  // namespace gonio::io
