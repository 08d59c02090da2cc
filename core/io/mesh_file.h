// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.h"

/// Meshes in files of all formats that are read: obj_file.h, ply_file.h, gltf_file.h.
namespace gonio::io {

/// The suffixes, with their dots, in the order in which dialogs name them.
const std::vector<std::string>& meshSuffixes();
/// The same with spaces between them: "*.obj *.ply ..." with a `prefix` of "*".
std::string meshSuffixList(const std::string& prefix = {});
/// By its suffix, whatever its case.
bool isMeshFile(const std::filesystem::path& path);

/// All of a file as one mesh. @throws Error naming the file: where its suffix is none of these; as its reader does.
TriangleMesh readMesh(const std::filesystem::path& path);

}  // namespace gonio::io
