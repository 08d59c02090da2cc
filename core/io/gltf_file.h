// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <optional>

#include "core/geometry/triangle_mesh.h"
#include "core/io/byte_source.h"

/// Meshes in glTF 2.0 files (Khronos Group 2021, ISO/IEC 12113:2022), text (.gltf) and binary (.glb): all triangles of
/// the default scene, at the places that its nodes give them, as one mesh. Materials, texture coordinates, skins, morph
/// targets, animations, points and lines are left out.
namespace gonio::io {

/// @param folder that relative addresses of buffers are taken from; nothing: files are not opened.
/// @throws Error with the member, what was found and what was expected; for files that need an extension which packs
/// geometry (Draco, meshopt, quantisation) or sparse accessors; where there are no triangles; over 2 GB or 100 million
/// triangles; as TriangleMesh does.
TriangleMesh readGltf(const ByteSource& source, const std::optional<std::filesystem::path>& folder = {});

}  // namespace gonio::io
