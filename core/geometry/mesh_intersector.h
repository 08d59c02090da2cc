// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/geometry/triangle_mesh.h"

namespace gonio {

/// Where a ray meets a mesh.
struct MeshHit {
  double t;                   ///< position = origin + t direction, but for rounding
  std::uint32_t triangle;     ///< index into the mesh's triangles
  double u, v;                ///< weights of the triangle's second and third corner, not negative, u + v <= 1
  Direction geometricNormal;  ///< of the triangle, unit, outward, whichever side the ray came from
  /// Interpolated between the corners', unit; the geometric normal where that one would point inward.
  Direction shadingNormal;
  glm::dvec3 position;  ///< on the triangle, from its corners and u, v: more exact than by t
};

/// Finds where rays meet a mesh, by Embree's bounding volumes in single precision (Wald et al. 2014, "Embree: A Kernel
/// Framework for Efficient CPU Ray Tracing") with its watertight test: a ray does not slip through between triangles
/// that share an edge. What it finds is then computed again in double. The mesh is brought to unit size first, and rays
/// start near it, so that neither size nor place nor a far camera costs accuracy.
///
/// All const functions may be called from any number of threads. The same mesh and ray give the same bits, for any
/// number of threads; of triangles that a ray meets in a shared edge, one is reported.
class MeshIntersector {
 public:
  /// Builds the bounding volumes on the calling thread (their order must not depend on the number of threads): about
  /// 1 s a million triangles.
  /// @throws Error where Embree has not the memory.
  explicit MeshIntersector(std::shared_ptr<const TriangleMesh> mesh);
  ~MeshIntersector();
  MeshIntersector(MeshIntersector&&) noexcept;
  MeshIntersector& operator=(MeshIntersector&&) noexcept;

  const TriangleMesh& mesh() const { return *mesh_; }
  const std::shared_ptr<const TriangleMesh>& sharedMesh() const { return mesh_; }

  /// The first hit with tMin <= t <= tMax, of either side of a triangle; the limits count to single precision. tMin
  /// >= 0, tMax may be infinite; the direction has any length but 0, and t counts in it. O(log triangles).
  std::optional<MeshHit> closest(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const;
  /// Whether anything lies there: cheaper than the first hit.
  bool occluded(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const;

 private:
  struct Scene;
  std::shared_ptr<const TriangleMesh> mesh_;
  std::unique_ptr<const Scene> scene_;
};

/// Where a ray starts that leaves a surface on the side of `normal` (unit; negated for the other side): off the surface
/// by 2^-19 of `scale`, the radius of the mesh's bounding sphere. That is more than single precision mistakes, so the
/// ray does not meet the surface that it leaves (after Wächter and Binder 2019, "A Fast and Robust Method for Avoiding
/// Self-Intersection", who count in units of the last place; here the mesh has been brought to unit size).
inline glm::dvec3 offsetOrigin(const glm::dvec3& position, const Direction& normal, double scale) {
  return position + normal * (scale * 0x1p-19);
}

}  // namespace gonio
