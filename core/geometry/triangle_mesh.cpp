// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

#include "core/math/fast_functions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::geometry {

namespace {

/// An edge of one triangle under the smaller of its vertices.
struct HalfEdge {
  std::uint32_t low, high, triangle;
  bool ascending;

  bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

}  // namespace

std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto keyA = key(a), keyB = key(b);
    return keyA != keyB ? keyA < keyB : a < b;
  });
  std::vector<std::uint32_t> result(positions.size());
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    if (key(order[i]) != key(order[first])) first = i;
    result[order[i]] = order[first];
  }
  return result;
}

std::optional<std::vector<SharedEdge>> closedEdges(std::span<const TriangleIndices> welded) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * welded.size());
  for (std::size_t triangle = 0; triangle < welded.size(); ++triangle)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = welded[triangle][i], to = welded[triangle][(i + 1) % 3];
      halves.push_back({std::min(from, to), std::max(from, to), std::uint32_t(triangle), from < to});
    }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  if (halves.size() % 2 != 0) return std::nullopt;
  std::vector<SharedEdge> edges;
  edges.reserve(halves.size() / 2);
  for (std::size_t i = 0; i < halves.size(); i += 2) {
    const HalfEdge &a = halves[i], &b = halves[i + 1];
    const bool third = i + 2 < halves.size() && halves[i + 2].sameEdge(a);
    if (!a.sameEdge(b) || a.ascending == b.ascending || third) return std::nullopt;
    edges.push_back({a.triangle, b.triangle});
  }
  return edges;
}

namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
constexpr double maxConvexityTests = 2e8;

template <typename Vector>
bool isFinite(const Vector& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string text(const glm::vec3& v) {
  return "(" + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + ")";
}

void requireUsable(const MeshArrays& arrays) {
  if (arrays.positions.size() >= unused || arrays.triangles.size() >= unused / 3)
    throw Error("mesh: found " + std::to_string(arrays.positions.size()) + " vertices and " +
                std::to_string(arrays.triangles.size()) + " triangles, expected fewer than " + std::to_string(unused) +
                " vertices and " + std::to_string(unused / 3) + " triangles");
  for (std::size_t i = 0; i < arrays.positions.size(); ++i)
    if (!isFinite(arrays.positions[i]))
      throw Error("mesh: vertex " + std::to_string(i) + " is at " + text(arrays.positions[i]) +
                  ", expected finite numbers");
  for (std::size_t i = 0; i < arrays.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      if (const std::uint32_t index = arrays.triangles[i][corner]; index >= arrays.positions.size())
        throw Error("mesh: triangle " + std::to_string(i) + " refers to vertex " + std::to_string(index) +
                    ", but there are only " + std::to_string(arrays.positions.size()) + ", counted from 0");
  if (!arrays.normals.empty() && arrays.normals.size() != 3 * arrays.triangles.size())
    throw Error("mesh: found " + std::to_string(arrays.normals.size()) + " normals, expected three for each of " +
                std::to_string(arrays.triangles.size()) + " triangles");
}

/// The area is lost in the rounding of the products, or 0.
bool isDegenerate(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const Direction ab = Direction(b) - Direction(a), ac = Direction(c) - Direction(a), bc = Direction(c) - Direction(b);
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return !(glm::length(glm::cross(ab, ac)) > 1e-14 * longest);
}

/// The normal with length 1, or the zero vector if there is none.
glm::vec3 unitOrMissing(const glm::vec3& normal) {
  const double length = glm::length(Direction(normal));
  return isFinite(normal) && length > 0 ? glm::vec3(Direction(normal) / length) : glm::vec3(0);
}

std::vector<TriangleIndices> renumbered(std::span<const TriangleIndices> triangles,
                                        std::span<const std::uint32_t> numbers) {
  std::vector<TriangleIndices> result;
  result.reserve(triangles.size());
  for (const TriangleIndices& t : triangles) result.emplace_back(numbers[t[0]], numbers[t[1]], numbers[t[2]]);
  return result;
}

}  // namespace

TriangleMesh::TriangleMesh(MeshArrays arrays) {
  requireUsable(arrays);
  positions_ = std::move(arrays.positions);
  triangles_ = std::move(arrays.triangles);
  normals_ = std::move(arrays.normals);
  const bool normalsGiven = !normals_.empty();
  normals_.resize(3 * triangles_.size());
  for (glm::vec3& normal : normals_) normal = unitOrMissing(normal);
  dropDegenerate();
  dropUnusedVertices();
  const std::vector<std::uint32_t> places = weldedVertices(positions_);
  const auto edges = closedEdges(renumbered(triangles_, places));
  if (isInsideOut(normalsGiven, edges.has_value())) turnWinding();
  completeNormals(renumbered(triangles_, places));
  findBounds();
  shape_ = {.closed = edges.has_value(), .convex = edges && provenConvex(*edges), .planar = liesInOnePlane()};
}

void TriangleMesh::dropDegenerate() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const TriangleIndices t = triangles_[i];
    if (isDegenerate(positions_[t[0]], positions_[t[1]], positions_[t[2]])) continue;
    triangles_[kept] = t;
    std::copy_n(normals_.begin() + std::ptrdiff_t(3 * i), 3, normals_.begin() + std::ptrdiff_t(3 * kept));
    ++kept;
  }
  const std::size_t degenerate = triangles_.size() - kept;
  if (kept == 0)
    throw Error(degenerate == 0 ? "mesh: found no triangles, expected at least one"
                                : "mesh: found only triangles with zero area (" + std::to_string(degenerate) +
                                      "), expected at least one with a positive area");
  triangles_.resize(kept);
  normals_.resize(3 * kept);
  dropped_ += degenerate;
}

void TriangleMesh::dropUnusedVertices() {
  std::vector<std::uint32_t> numbers(positions_.size(), unused);
  for (const TriangleIndices& t : triangles_)
    for (int i = 0; i < 3; ++i) numbers[t[i]] = 0;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (numbers[i] == unused) continue;
    positions_[count] = positions_[i];
    numbers[i] = count++;
  }
  if (count == positions_.size()) return;
  positions_.resize(count);
  triangles_ = renumbered(triangles_, numbers);
}

bool TriangleMesh::isInsideOut(bool normalsGiven, bool closed) const {
  if (!normalsGiven) return closed && volume() < 0;
  double along = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const TriangleIndices& t = triangles_[i];
    const Direction shading =
        Direction(normals_[3 * i]) + Direction(normals_[3 * i + 1]) + Direction(normals_[3 * i + 2]);
    along += glm::dot(areaNormal(positions_[t[0]], positions_[t[1]], positions_[t[2]]), shading);
  }
  return along < 0;
}

void TriangleMesh::turnWinding() {
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    std::swap(triangles_[i][1], triangles_[i][2]);
    std::swap(normals_[3 * i + 1], normals_[3 * i + 2]);
  }
}

void TriangleMesh::completeNormals(std::span<const TriangleIndices> welded) {
  const auto missing = [](const glm::vec3& normal) { return normal == glm::vec3(0); };
  if (std::none_of(normals_.begin(), normals_.end(), missing)) return;
  const std::vector<glm::vec3> made = makeCornerNormals(positions_, welded);
  for (std::size_t i = 0; i < normals_.size(); ++i)
    if (missing(normals_[i])) normals_[i] = made[i];
}

void TriangleMesh::findBounds() {
  bounds_ = {glm::dvec3(positions_[0]), glm::dvec3(positions_[0])};
  for (const glm::vec3& p : positions_)
    bounds_ = {glm::min(bounds_.min, glm::dvec3(p)), glm::max(bounds_.max, glm::dvec3(p))};
  sphere_.centre = 0.5 * (bounds_.min + bounds_.max);
  double squared = 0;
  for (const glm::vec3& p : positions_) {
    const glm::dvec3 arm = glm::dvec3(p) - sphere_.centre;
    squared = std::max(squared, glm::dot(arm, arm));
  }
  sphere_.radius = std::sqrt(squared);
}

bool TriangleMesh::liesInOnePlane() const {
  Direction sum(0);
  for (const TriangleIndices& t : triangles_) sum += areaNormal(positions_[t[0]], positions_[t[1]], positions_[t[2]]);
  if (!(glm::length(sum) > 0)) return false;
  const Direction normal = glm::normalize(sum);
  for (const glm::vec3& p : positions_)
    if (std::abs(glm::dot(Direction(p) - sphere_.centre, normal)) > shapeTolerance * sphere_.radius) return false;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (!(glm::dot(geometricNormal(i), normal) > 0)) return false;
  return true;
}

double TriangleMesh::heightAbove(std::size_t triangle, std::uint32_t vertex) const {
  const Direction at(positions_[triangles_[triangle][0]]);
  return glm::dot(geometricNormal(triangle), Direction(positions_[vertex]) - at);
}

bool TriangleMesh::provenConvex(std::span<const SharedEdge> edges) const {
  const double tolerance = shapeTolerance * sphere_.radius;
  for (const SharedEdge& edge : edges)
    for (int i = 0; i < 3; ++i)
      if (heightAbove(edge.triangle, triangles_[edge.other][i]) > tolerance) return false;
  if (double(positions_.size()) * double(triangles_.size()) > maxConvexityTests) return false;
  Eigen::Matrix3Xd vertices(3, positions_.size());
  for (std::size_t i = 0; i < positions_.size(); ++i)
    vertices.col(Eigen::Index(i)) << positions_[i].x, positions_[i].y, positions_[i].z;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Direction normal = geometricNormal(i), at(positions_[triangles_[i][0]]);
    const double reach = (Eigen::RowVector3d(normal.x, normal.y, normal.z) * vertices).maxCoeff();
    if (reach > glm::dot(normal, at) + tolerance) return false;
  }
  return true;
}

Direction TriangleMesh::geometricNormal(std::size_t triangle) const {
  const TriangleIndices& t = triangles_[triangle];
  return glm::normalize(areaNormal(positions_[t[0]], positions_[t[1]], positions_[t[2]]));
}

double TriangleMesh::support(const Direction& direction) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const glm::vec3& p : positions_) most = std::max(most, glm::dot(Direction(p), direction));
  return most;
}

double TriangleMesh::volume() const {
  // From a vertex rather than from the origin, which may be far off.
  const Direction origin(positions_[triangles_[0][0]]);
  double sum = 0;
  for (const TriangleIndices& t : triangles_)
    sum += glm::dot(Direction(positions_[t[0]]) - origin,
                    areaNormal(positions_[t[0]], positions_[t[1]], positions_[t[2]]));
  return sum / 6;
}

TriangleMesh transformed(const TriangleMesh& mesh, const glm::dmat4& matrix) {
  const glm::dmat3 linear(matrix);
  const double determinant = glm::determinant(linear);
  if (!std::isfinite(determinant) || determinant == 0)
    throw Error("mesh: the matrix of its transform has the determinant " + numberText(determinant) +
                ", expected a finite one that is not 0");
  // The adjugate's transpose: the inverse transpose but for a positive factor, and finite where that overflows.
  const glm::dmat3 normalMatrix = determinant * glm::transpose(glm::inverse(linear)) * (determinant < 0 ? -1.0 : 1.0);
  TriangleMesh result = mesh;
  for (glm::vec3& p : result.positions_) {
    p = glm::vec3(glm::dvec3(matrix * glm::dvec4(p, 1)));
    if (!isFinite(p)) throw Error("mesh: its transform moves a vertex to " + text(p) + ", expected finite numbers");
  }
  for (glm::vec3& normal : result.normals_) normal = glm::vec3(glm::normalize(normalMatrix * Direction(normal)));
  if (determinant < 0) result.turnWinding();
  const std::size_t dropped = result.dropped_;
  result.dropDegenerate();
  if (result.dropped_ != dropped) {
    const std::size_t total = result.dropped_;
    result = TriangleMesh({std::move(result.positions_), std::move(result.triangles_), std::move(result.normals_)});
    result.dropped_ += total;
    return result;
  }
  result.findBounds();
  return result;
}

glm::dmat4 placement(double scale, double yaw, const glm::dvec3& translation) {
  const glm::dmat4 unit(1);
  return glm::translate(unit, translation) * glm::rotate(unit, yaw, glm::dvec3(0, 1, 0)) *
         glm::scale(unit, glm::dvec3(scale));
}

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

}  // namespace gonio::geometry
