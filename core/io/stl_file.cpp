// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/mesh_file.h"
#include "core/io/text_lines.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::io {

namespace {

constexpr std::uint64_t maxStlBytes = std::uint64_t(2) << 30;
constexpr std::size_t stlHeaderBytes = 80, stlTriangleBytes = 50, stlStart = stlHeaderBytes + sizeof(std::uint32_t);

/// The number of triangles that a binary file states, if it has the size of as many. Its header may begin with "solid",
/// as text files do.
std::optional<std::size_t> binaryCount(std::string_view data) {
  if (data.size() < stlStart) return std::nullopt;
  std::uint32_t count = 0;
  std::memcpy(&count, data.data() + stlHeaderBytes, sizeof count);
  if (data.size() != stlStart + std::uint64_t(count) * stlTriangleBytes) return std::nullopt;
  return count;
}

std::vector<glm::dvec3> binaryCorners(std::string_view data, std::size_t count) {
  std::vector<glm::dvec3> corners;
  corners.reserve(3 * count);
  for (std::size_t triangle = 0; triangle < count; ++triangle)
    for (int corner = 0; corner < 3; ++corner) {
      glm::vec3 position;
      // The normal of the face precedes the corners.
      std::memcpy(&position, data.data() + stlStart + triangle * stlTriangleBytes + std::size_t(1 + corner) * 12,
                  sizeof position);
      corners.emplace_back(position);
    }
  return corners;
}

/// Three lines "vertex x y z" in each "facet"; the other lines repeat what follows from them.
std::vector<glm::dvec3> textCorners(std::string_view text) {
  TextLines lines(text);
  const auto first = lines.next();
  if (!first || !first->text.starts_with("solid"))
    throw Error(
        "found neither 'solid' at the start nor the size of a binary STL file (84 bytes and 50 for each triangle), "
        "expected one of them");
  std::vector<glm::dvec3> corners;
  while (const auto line = lines.next()) {
    const auto part = words(line->text);
    if (lowerCase(std::string(part.empty() ? "" : part[0])) != "vertex") continue;
    glm::dvec3 position;
    for (int i = 0; i < 3; ++i) {
      const auto number = part.size() == 4 ? finiteNumber(part[std::size_t(i) + 1]) : std::nullopt;
      if (!number || std::abs(*number) > std::numeric_limits<float>::max())
        line->fail("'vertex' and three finite numbers in the range of single precision");
      position[i] = *number;
    }
    corners.push_back(position);
  }
  if (corners.size() % 3 != 0)
    throw Error("found " + std::to_string(corners.size()) + " vertices, expected three for each triangle");
  return corners;
}

}  // namespace

MeshFile readStl(const ByteSource& source) {
  const std::vector<std::byte> bytes = source.readAll(maxStlBytes);
  const std::string_view data(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto count = binaryCount(data);
  const std::vector<glm::dvec3> corners = count ? binaryCorners(data, *count) : textCorners(data);
  if (corners.empty()) throw Error("an STL mesh: found no triangles, expected at least one");
  geometry::MeshArrays arrays;
  glm::dvec3 origin;
  arrays.positions = localPositions(corners, origin);
  for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) arrays.triangles.push_back({i, i + 1, i + 2});
  return {geometry::TriangleMesh(std::move(arrays)), origin, {}};
}

}  // namespace gonio::io
