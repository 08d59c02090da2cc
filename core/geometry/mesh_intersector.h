// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/geometry/triangle_mesh.h"

namespace gonio {

/// An intersection of a ray and a mesh.
struct MeshHit {
  double t;                   ///< ray parameter: position = origin + t direction, up to rounding
  std::uint32_t triangle;     ///< index into the mesh's triangles
  double u, v;                ///< barycentric coordinates: weights of the second and third corner, >= 0, u + v <= 1
  Direction geometricNormal;  ///< of the triangle, unit, outward, independent of the side of the ray
  /// Interpolated between the corners' normals, unit; the geometric normal if the interpolated one points inward.
  Direction shadingNormal;
  glm::dvec3 position;  ///< computed from the corners and u, v, which is more accurate than from t
};

/// Intersects rays with a mesh by Embree's bounding volumes in single precision (Wald et al. 2014, "Embree: A Kernel
/// Framework for Efficient CPU Ray Tracing"), with its watertight test: no ray passes between triangles that share an
/// edge. Hits are then recomputed in double precision. The mesh is scaled to unit size and rays are moved close to it
/// first, so that size, position and a distant camera do not reduce the accuracy.
///
/// Const functions may be called from several threads at once. Deterministic: equal meshes and rays give bitwise equal
/// results. At a shared edge, one of the triangles is reported.
class MeshIntersector {
 public:
  /// Builds the bounding volumes, on the calling thread so that they do not depend on the number of threads: about 1 s
  /// per million triangles. @throws Error if Embree runs out of memory.
  explicit MeshIntersector(std::shared_ptr<const TriangleMesh> mesh);
  ~MeshIntersector();
  MeshIntersector(MeshIntersector&&) noexcept;
  MeshIntersector& operator=(MeshIntersector&&) noexcept;

  const TriangleMesh& mesh() const { return *mesh_; }
  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return mesh_; }

  /// The first hit with tMin <= t <= tMax, on either side of a triangle; the limits have single precision. tMin >= 0,
  /// tMax may be infinite. t is in units of the length of `direction`, which may be any length except 0. O(log
  /// triangles).
  std::optional<MeshHit> closest(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const;
  /// Whether there is any hit; faster than closest().
  bool occluded(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const;

 private:
  struct Scene;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::unique_ptr<const Scene> scene_;
};

/// The origin of a ray that leaves a surface on the side of `normal` (unit; negate it for the other side): moved off
/// the surface by 2^-19 of `scale`, the radius of the mesh's bounding sphere. This exceeds the error of single
/// precision, so the ray does not intersect its own surface (after Wächter and Binder 2019, "A Fast and Robust Method
/// for Avoiding Self-Intersection", who use units in the last place).
inline glm::dvec3 offsetOrigin(const glm::dvec3& position, const Direction& normal, double scale) {
  return position + normal * (scale * 0x1p-19);
}

}  // namespace gonio
