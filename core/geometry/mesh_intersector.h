// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/triangle_mesh.h"
#include "core/math/types.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace gonio::geometry {

/// The Embree device of the process; it exists until the process ends.
RTCDevice embreeDevice();

/// rtcIntersect1() and rtcOccluded1() of one ray; Embree 3 takes a context with each.
inline void intersect(RTCScene scene, RTCRayHit& hit) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &hit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &hit);
#endif
}
inline void occlude(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
}

/// @throws Error with Embree's error number if its last call on this thread failed.
void throwIfEmbreeFailed();

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

struct AxisBox {
  glm::vec3 min, max;
};

/// A binary hierarchy of axis-aligned boxes in flat arrays, for ray queries on the GPU. CPU queries use
/// MeshIntersector.
struct BoundingVolumes {
  /// The content of one of a node's two boxes: another node, or a leaf with primitives.
  struct Child {
    AxisBox box;
    std::uint32_t first = 0;  ///< index of the node, or of the leaf's first entry in `order`
    std::uint32_t count = 0;  ///< number of primitives of the leaf; 0: a node, or nothing if box.min > box.max
  };
  struct Node {
    Child children[2];
  };

  static constexpr std::uint32_t maxInLeaf = 4;

  std::vector<Node> nodes;           ///< the root first; parents before their children
  std::vector<std::uint32_t> order;  ///< indices of the primitives: each once, those of a leaf are consecutive
  int depth = 0;                     ///< number of nodes on the longest path from the root to a leaf
};

/// Builds a hierarchy with Embree's builder, by the surface area heuristic: about 0.5 s per million primitives, on the
/// calling thread. Deterministic. If there is only one leaf, the root's second child is empty: its box has min > max,
/// and it has no primitives.
/// @param boxes at least one, finite.
/// @throws Error if Embree runs out of memory.
BoundingVolumes buildBoundingVolumes(std::span<const AxisBox> boxes);

}  // namespace gonio::geometry
