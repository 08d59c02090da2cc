// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/math/types.h"

/// Topology of triangle meshes by the positions of vertices, since files repeat a vertex where texture coordinates or
/// normals differ.
namespace gonio::geometry {

/// A triangle of a mesh: three indices of vertices, counter-clockwise as seen from outside.
using TriangleIndices = glm::uvec3;

/// For each vertex, the lowest index of a vertex at the same position. O(n log n).
std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions);

/// An edge, as the indices of its two triangles.
struct SharedEdge {
  std::uint32_t triangle, other;
};

/// All edges of a closed, consistently wound surface, where each edge belongs to exactly two triangles, in opposite
/// directions; empty for any other surface. @param welded triangles with welded vertices. O(n log n).
std::optional<std::vector<SharedEdge>> closedEdges(std::span<const TriangleIndices> welded);

/// The arrays of a mesh.
struct MeshArrays {
  std::vector<glm::vec3> positions;
  std::vector<TriangleIndices> triangles;
  /// Shading normals, 3 per triangle, of any length; empty: computed from the faces. Normals that have length 0 or are
  /// not finite count as missing.
  std::vector<glm::vec3> normals;
};

/// An immutable triangle mesh, with properties of its shape that a renderer needs. Seen from the outside, the vertices
/// of a triangle are counter-clockwise.
class TriangleMesh {
 public:
  /// Builds a mesh from arrays as read from a file, with corrections: drops triangles without area and vertices that no
  /// triangle uses; computes missing normals with makeCornerNormals(); reverses the winding if the given normals,
  /// weighted by area, point against it, or if a closed mesh without normals is inside out. O(n log n), plus the test
  /// of convexity (isConvex()). @throws Error that names the first vertex that is not finite or the first triangle with
  /// an index out of range; also if the number of normals is not three per triangle, or no triangle has an area.
  explicit TriangleMesh(MeshArrays arrays);

  std::span<const glm::vec3> positions() const { return positions_; }
  std::span<const TriangleIndices> triangles() const { return triangles_; }
  /// Unit shading normals, 3 per triangle.
  std::span<const glm::vec3> cornerNormals() const { return normals_; }
  /// Number of triangles that were dropped because they have no area (a repeated vertex, or collinear corners).
  std::size_t droppedTriangles() const { return dropped_; }

  /// Unit normal of a triangle's plane, outward.
  Direction geometricNormal(std::size_t triangle) const;

  struct Bounds {
    glm::dvec3 min, max;
  };
  const Bounds& bounds() const { return bounds_; }
  /// A sphere around all vertices, about the centre of the bounds; its radius is at most sqrt(3) times the smallest.
  struct Sphere {
    glm::dvec3 centre;
    double radius;
  };
  const Sphere& boundingSphere() const { return sphere_; }

  /// Whether, with vertices at equal positions merged, every edge belongs to exactly two triangles with consistent
  /// winding: then the mesh encloses its inside without gaps.
  bool isClosed() const { return shape_.closed; }
  /// Whether the mesh is closed and every vertex is behind the plane of every triangle, within shapeTolerance: then no
  /// ray that leaves it to the outside hits it again. Only tested if vertices x triangles <= 2e8 (0.2 s); larger meshes
  /// count as not convex.
  bool isConvex() const { return shape_.convex; }
  /// Whether all triangles lie in one plane, within shapeTolerance, and face the same side: then the mesh does not
  /// occlude itself.
  bool isPlanar() const { return shape_.planar; }
  /// Tolerated distance of a vertex from a plane, as a fraction of the bounding sphere's radius: single precision tilts
  /// the planes of small triangles by that much.
  static constexpr double shapeTolerance = 1e-5;

  /// The support function: maximum of dot(vertex, direction). O(vertices).
  double support(const Direction& direction) const;

  /// The signed volume of a closed mesh, negative if it is inside out; meaningless for an open mesh. O(triangles).
  double volume() const;

 private:
  friend TriangleMesh transformed(const TriangleMesh& mesh, const glm::dmat4& matrix);

  struct Shape {
    bool closed = false, convex = false, planar = false;
  };
  TriangleMesh() = default;
  void dropDegenerate();
  void dropUnusedVertices();
  void completeNormals(std::span<const TriangleIndices> welded);
  bool isInsideOut(bool normalsGiven, bool closed) const;
  void turnWinding();
  void findBounds();
  bool liesInOnePlane() const;
  bool provenConvex(std::span<const SharedEdge> edges) const;
  double heightAbove(std::size_t triangle, std::uint32_t vertex) const;

  std::vector<glm::vec3> positions_;
  std::vector<TriangleIndices> triangles_;
  std::vector<glm::vec3> normals_;
  std::size_t dropped_ = 0;
  Bounds bounds_{};
  Sphere sphere_{};
  Shape shape_;
};

/// The mesh under an affine map (the last row of the matrix is 0 0 0 1). Normals are transformed by the inverse
/// transpose; a reflection reverses the winding, so that the outside remains outside. isClosed(), isConvex() and
/// isPlanar() do not change, unless triangles lose their area. O(n). @throws Error if the matrix is singular or not
/// finite, or moves a vertex beyond the range of float.
TriangleMesh transformed(const TriangleMesh& mesh, const glm::dmat4& matrix);

/// Scales by `scale`, then rotates about +y by `yaw` (rad, from +z toward +x), then moves by `translation`.
glm::dmat4 placement(double scale, double yaw, const glm::dvec3& translation);

/// Two faces form a crease, without a common shading normal, if the angle between their normals exceeds this (rad).
inline constexpr double creaseAngle = radians(40);

/// Twice the area times the unit normal of a triangle, by the right-hand rule from its winding. Computed in double
/// precision.
Direction areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Unit shading normals of all corners, 3 per triangle: the mean of the face normals at the corner's vertex that are
/// within creaseAngle of the corner's own face, weighted by the faces' angles there (Thürmer and Wüthrich 1998,
/// "Computing Vertex Normals from Polygonal Facets"). Thus a cube is sharp and a torus smooth, independently of the
/// triangulation of faces. Corners at vertices with more than 1000 faces have the normal of their face.
/// @param welded triangles with welded vertices (weldedVertices()), none degenerate. O(corners x faces per vertex).
std::vector<glm::vec3> makeCornerNormals(std::span<const glm::vec3> positions, std::span<const TriangleIndices> welded);

}  // namespace gonio::geometry
