// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/mesh_file.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

std::string suffixOf(const std::filesystem::path& path) { return lowerCase(path.extension().string()); }

}  // namespace

std::vector<glm::vec3> localPositions(std::span<const glm::dvec3> positions, glm::dvec3& origin) {
  constexpr double largest = 64;  // float has 2^-24 of a coordinate, TriangleMesh::shapeTolerance is 1e-5 of the extent
  origin = glm::dvec3(0);
  if (!positions.empty()) {
    glm::dvec3 low = positions[0], high = positions[0];
    for (const glm::dvec3& position : positions) {
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    const glm::dvec3 extent = high - low, reach = glm::max(glm::abs(low), glm::abs(high));
    if (std::max({reach.x, reach.y, reach.z}) > largest * std::max({extent.x, extent.y, extent.z}))
      origin = 0.5 * (low + high);
  }
  std::vector<glm::vec3> result;
  result.reserve(positions.size());
  for (const glm::dvec3& position : positions) result.emplace_back(position - origin);
  return result;
}

const std::vector<std::string>& meshSuffixes() {
  static const std::vector<std::string> suffixes{".obj", ".ply", ".stl", ".gltf", ".glb"};
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

MeshFile readMesh(const std::filesystem::path& path) {
  const std::string suffix = suffixOf(path);
  if (suffix == ".obj") return readObj(path);
  return withFileInErrors(path, [&] {
    if (!isMeshFile(path)) throw Error("found the suffix '" + suffix + "', expected one of " + meshSuffixList());
    const FileSource file(path);
    if (suffix == ".stl") return readStl(file);
    return suffix == ".ply" ? readPly(file) : readGltf(file, path.parent_path());
  });
}

}  // namespace gonio::io
