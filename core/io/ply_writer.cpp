// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <bit>
#include <cstring>
#include <map>
#include <string>
#include <tuple>

#include "core/io/append_bytes.h"
#include "core/io/ply_file.h"

namespace gonio::io {

std::vector<std::byte> encodePly(const TriangleMesh& mesh) {
  using Corner = std::tuple<std::uint32_t, float, float, float>;
  std::map<Corner, std::int32_t> indices;
  std::vector<std::byte> vertices, faces;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    append(faces, std::uint8_t(3));
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t position = mesh.triangles()[i][k];
      const glm::vec3 normal = mesh.cornerNormals()[3 * i + std::size_t(k)];
      const auto [at, added] =
          indices.try_emplace({position, normal.x, normal.y, normal.z}, std::int32_t(indices.size()));
      if (added) {
        append(vertices, mesh.positions()[position]);
        append(vertices, normal);
      }
      append(faces, at->second);
    }
  }
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(indices.size());
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"}) header += std::string("\nproperty float ") + property;
  header += "\nelement face " + std::to_string(mesh.triangles().size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
  std::vector<std::byte> bytes(header.size());
  std::memcpy(bytes.data(), header.data(), header.size());
  bytes.insert(bytes.end(), vertices.begin(), vertices.end());
  bytes.insert(bytes.end(), faces.begin(), faces.end());
  return bytes;
}

}  // namespace gonio::io
