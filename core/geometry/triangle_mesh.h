// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "core/geometry/mesh_topology.h"
#include "core/math/types.h"

namespace gonio {

/// What a mesh is made of.
struct MeshArrays {
  std::vector<glm::vec3> positions;
  std::vector<TriangleIndices> triangles;
  /// Shading normals, one for each corner (3 a triangle, of any length), or empty: they are made from the faces.
  /// A normal of length 0 or one that is not finite counts as missing.
  std::vector<glm::vec3> normals;
};

/// A surface of triangles, immutable, with what a renderer wants to know of its shape, found once. The outside of a
/// triangle is the side from which its vertices run counter-clockwise.
class TriangleMesh {
 public:
  /// Takes arrays as files have them and sets them right: triangles without an area are dropped; so are vertices that
  /// no triangle uses; missing normals are made as makeCornerNormals() says. Where given normals point, weighted by
  /// area, rather against the winding than along it, the winding is turned; so it is where a closed mesh without
  /// normals has its inside outward. O(n log n) and the search for convexity (isConvex()).
  /// @throws Error that names the first vertex that is not finite, the first triangle with an index out of range, a
  /// number of normals that is not three a triangle; or where no triangle has an area.
  explicit TriangleMesh(MeshArrays arrays);

  std::span<const glm::vec3> positions() const { return positions_; }
  std::span<const TriangleIndices> triangles() const { return triangles_; }
  /// Shading normals, unit, 3 a triangle.
  std::span<const glm::vec3> cornerNormals() const { return normals_; }
  /// How many triangles had no area (a repeated vertex, or corners in line) and were left out.
  std::size_t droppedTriangles() const { return dropped_; }

  /// Unit normal of a triangle's plane, outward.
  Direction geometricNormal(std::size_t triangle) const;

  struct Bounds {
    glm::dvec3 min, max;
  };
  const Bounds& bounds() const { return bounds_; }
  /// A sphere that holds all vertices, about the middle of the bounds; not the smallest, but within a factor of
  /// sqrt(3).
  struct Sphere {
    glm::dvec3 centre;
    double radius;
  };
  const Sphere& boundingSphere() const { return sphere_; }

  /// Whether every edge, vertices at equal places being one, lies between exactly two triangles that are wound alike:
  /// then the mesh encloses its inside without a gap.
  bool isClosed() const { return shape_.closed; }
  /// Whether the mesh is closed and every vertex lies behind the plane of every triangle, within shapeTolerance: then
  /// no ray that leaves it to the outside meets it again. Proven only while vertices x triangles <= 2e8 (0.2 s); a
  /// larger mesh counts as not convex.
  bool isConvex() const { return shape_.convex; }
  /// Whether all lies in one plane, within shapeTolerance, facing one way: then it hides nothing of itself.
  bool isPlanar() const { return shape_.planar; }
  /// How far, as a fraction of the bounding sphere's radius, a vertex may lie off a plane that counts as its own:
  /// single precision tilts the planes of small triangles by that much.
  static constexpr double shapeTolerance = 1e-5;

  /// How far the mesh reaches in a direction: the maximum of dot(vertex, direction). O(vertices).
  double support(const Direction& direction) const;

  /// What a closed mesh encloses, negative where its inside is outward; of an open mesh it means nothing. O(triangles).
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

/// The mesh under an affine map (the matrix's last row is 0 0 0 1): normals go by the inverse transpose, a mirroring
/// turns the winding, so that outside stays outside. The shape's facts are kept. O(n).
/// @throws Error where the matrix is singular or not finite, or takes a vertex beyond single precision.
TriangleMesh transformed(const TriangleMesh& mesh, const glm::dmat4& matrix);

/// Scales by `scale`, then rotates about +y by `yaw` (rad, from +z toward +x), then moves by `translation`.
glm::dmat4 placement(double scale, double yaw, const glm::dvec3& translation);

}  // namespace gonio
