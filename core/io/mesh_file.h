// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/triangle_mesh.h"

/// Reading of meshes in all supported formats: obj_file.h, ply_file.h, gltf_file.h.
namespace gonio::io {

/// The suffixes with their dots, in the order of display.
const std::vector<std::string>& meshSuffixes();
/// The suffixes separated by spaces, each after `prefix`: "*.obj *.ply ..." for "*".
std::string meshSuffixList(const std::string& prefix = {});
/// Whether the suffix is that of a mesh format, in upper or lower case.
bool isMeshFile(const std::filesystem::path& path);

/// All content of a file as one mesh. @throws Error that names the file, for an unknown suffix or as the format's
/// reader.
TriangleMesh readMesh(const std::filesystem::path& path);

}  // namespace gonio::io
