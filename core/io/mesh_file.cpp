// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <algorithm>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

std::string suffixOf(const std::filesystem::path& path) { return lowerCase(path.extension().string()); }

}  // namespace

const std::vector<std::string>& meshSuffixes() {
  static const std::vector<std::string> suffixes{".obj", ".ply", ".gltf", ".glb"};
  return suffixes;
}

std::string meshSuffixList(const std::string& prefix) {
  std::string list;
  for (const std::string& suffix : meshSuffixes()) list += (list.empty() ? "" : " ") + prefix + suffix;
  return list;
}

bool isMeshFile(const std::filesystem::path& path) {
  return std::ranges::find(meshSuffixes(), suffixOf(path)) != meshSuffixes().end();
}

geometry::TriangleMesh readMesh(const std::filesystem::path& path) {
  const std::string suffix = suffixOf(path);
  if (suffix == ".obj") return readObj(path);
  return withFileInErrors(path, [&] {
    if (!isMeshFile(path)) throw Error("found the suffix '" + suffix + "', expected one of " + meshSuffixList());
    const FileSource file(path);
    return suffix == ".ply" ? readPly(file) : readGltf(file, path.parent_path());
  });
}

}  // namespace gonio::io
