// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/corner_normals.h"

#include <cmath>

#include "core/math/fast_atan2.h"
#include "core/math/parallel.h"

namespace gonio {

namespace {

/// Beyond, the square of their number would make bad files slow.
constexpr std::size_t maxFacesAboutAVertex = 1000;

constexpr std::size_t trianglesABlock = 4096;

/// A face's part in the mean about one of its corners.
struct CornerFace {
  Direction normal;  ///< unit, of the face
  double angle;      ///< of the face at the corner, rad
};

std::vector<CornerFace> cornerFaces(std::span<const glm::vec3> positions, std::span<const TriangleIndices> triangles) {
  std::vector<CornerFace> faces(3 * triangles.size());
  parallelForBlocks(triangles.size(), trianglesABlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t triangle = begin; triangle < end; ++triangle) {
      const TriangleIndices& t = triangles[triangle];
      const Direction normal = glm::normalize(areaNormal(positions[t[0]], positions[t[1]], positions[t[2]]));
      for (int i = 0; i < 3; ++i) {
        const Direction at(positions[t[i]]);
        const Direction a = Direction(positions[t[(i + 1) % 3]]) - at, b = Direction(positions[t[(i + 2) % 3]]) - at;
        faces[3 * triangle + std::size_t(i)] = {normal, fastAtan2(glm::length(glm::cross(a, b)), glm::dot(a, b))};
      }
    }
  });
  return faces;
}

/// The corners at each vertex: those of vertex v are corners[begin[v]] to corners[begin[v + 1] - 1], ascending.
struct CornersOfVertices {
  std::vector<std::size_t> begin;
  std::vector<std::size_t> corners;

  CornersOfVertices(std::size_t vertices, std::span<const TriangleIndices> triangles)
      : begin(vertices + 1), corners(3 * triangles.size()) {
    for (const TriangleIndices& t : triangles)
      for (int i = 0; i < 3; ++i) ++begin[t[i] + 1];
    for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
      corners[next[triangles[corner / 3][int(corner % 3)]]++] = corner;
  }
  std::span<const std::size_t> at(std::size_t vertex) const {
    return std::span(corners).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

}  // namespace

Direction areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return glm::cross(Direction(b) - Direction(a), Direction(c) - Direction(a));
}

std::vector<glm::vec3> makeCornerNormals(std::span<const glm::vec3> positions,
                                         std::span<const TriangleIndices> welded) {
  const std::vector<CornerFace> faces = cornerFaces(positions, welded);
  const CornersOfVertices about(positions.size(), welded);
  static const double cosCrease = std::cos(creaseAngle);
  const auto normalAt = [&](std::size_t corner) {
    const Direction own = faces[corner].normal;
    const std::span<const std::size_t> others = about.at(welded[corner / 3][int(corner % 3)]);
    Direction sum(0);
    if (others.size() <= maxFacesAboutAVertex)
      for (const std::size_t other : others)
        if (glm::dot(faces[other].normal, own) >= cosCrease) sum += faces[other].angle * faces[other].normal;
    // All parts lie within the crease angle of `own`, so the sum is never short unless there is none.
    return glm::vec3(glm::dot(sum, own) > 0 ? glm::normalize(sum) : own);
  };
  std::vector<glm::vec3> normals(faces.size());
  parallelForBlocks(welded.size(), trianglesABlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t corner = 3 * begin; corner < 3 * end; ++corner) normals[corner] = normalAt(corner);
  });
  return normals;
}

}  // namespace gonio
