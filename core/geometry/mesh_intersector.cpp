// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/mesh_intersector.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/embree_device.h"

namespace gonio {

namespace {

RTCRayHit emptyHit(const RTCRay& ray) {
  RTCRayHit hit{};
  hit.ray = ray;
  hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return hit;
}

/// Weights of the second and third corner where the ray meets the triangle's plane, held inside the triangle; those
/// that were found in single precision where the ray runs along the plane. Möller and Trumbore 1997.
glm::dvec2 exactWeights(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& corner,
                        const glm::dvec3& ab, const glm::dvec3& ac, const glm::dvec2& found) {
  const glm::dvec3 p = glm::cross(direction, ac), arm = origin - corner, q = glm::cross(arm, ab);
  const double determinant = glm::dot(ab, p);
  glm::dvec2 weights = found;
  if (determinant * determinant > 1e-18 * glm::dot(ab, ab) * glm::dot(ac, ac) * glm::dot(direction, direction))
    weights = glm::dvec2(glm::dot(arm, p), glm::dot(direction, q)) / determinant;
  weights = glm::max(weights, glm::dvec2(0));
  return weights / std::max(1.0, weights.x + weights.y);
}

}  // namespace

struct MeshIntersector::Scene {
  RTCScene scene = rtcNewScene(embreeDevice());
  glm::dvec3 centre;
  double radius;

  explicit Scene(const TriangleMesh& mesh)
      : centre(mesh.boundingSphere().centre), radius(mesh.boundingSphere().radius) {
    RTCGeometry geometry = rtcNewGeometry(embreeDevice(), RTC_GEOMETRY_TYPE_TRIANGLE);
    try {
      fill(geometry, mesh);
    } catch (...) {
      rtcReleaseGeometry(geometry);
      rtcReleaseScene(scene);
      throw;
    }
    rtcReleaseGeometry(geometry);
  }
  ~Scene() { rtcReleaseScene(scene); }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void fill(RTCGeometry geometry, const TriangleMesh& mesh) {
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.positions().size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles().size()));
    throwIfEmbreeFailed();
    for (const glm::vec3& p : mesh.positions())
      for (int i = 0; i < 3; ++i) *vertices++ = float((double(p[i]) - centre[i]) / radius);
    for (const TriangleIndices& t : mesh.triangles())
      for (int i = 0; i < 3; ++i) *indices++ = t[i];
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    // The high quality's order of triangles depends on chance, that of the others on the number of threads.
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    tbb::task_arena alone(1);
    alone.execute([&] { rtcCommitScene(scene); });
    throwIfEmbreeFailed();
  }

  /// The part of a ray that lies in the bounding sphere, where that is the unit sphere; none where the ray passes by.
  std::optional<RTCRay> localRay(const glm::dvec3& origin, const glm::dvec3& direction, double tMin,
                                 double tMax) const {
    constexpr double margin = 1 + 1e-6;
    const double speed = glm::length(direction) / radius;
    const glm::dvec3 start = (origin - centre) / radius, velocity = direction / radius;
    const double nearest = -glm::dot(start, velocity) / (speed * speed);
    const glm::dvec3 pass = start + nearest * velocity;
    const double squared = margin * margin - glm::dot(pass, pass);
    if (!(squared > 0)) return std::nullopt;
    const double reach = std::sqrt(squared) / speed;
    const double from = std::max(tMin, nearest - reach), to = std::min(tMax, nearest + reach);
    if (!(from <= to)) return std::nullopt;
    // Far origins are moved up to the sphere: single precision would lose the place of the hit.
    const double moved = std::max(0.0, nearest - reach);
    const glm::vec3 o(start + moved * velocity), d(velocity / speed);
    return RTCRay{.org_x = o.x,
                  .org_y = o.y,
                  .org_z = o.z,
                  .tnear = float((from - moved) * speed),
                  .dir_x = d.x,
                  .dir_y = d.y,
                  .dir_z = d.z,
                  .tfar = float((to - moved) * speed),
                  .mask = ~0u};
  }
};

MeshIntersector::MeshIntersector(std::shared_ptr<const TriangleMesh> mesh)
    : mesh_(std::move(mesh)), scene_(std::make_unique<const Scene>(*mesh_)) {}
MeshIntersector::~MeshIntersector() = default;
MeshIntersector::MeshIntersector(MeshIntersector&&) noexcept = default;
MeshIntersector& MeshIntersector::operator=(MeshIntersector&&) noexcept = default;

std::optional<MeshHit> MeshIntersector::closest(const glm::dvec3& origin, const glm::dvec3& direction, double tMin,
                                                double tMax) const {
  const std::optional<RTCRay> ray = scene_->localRay(origin, direction, tMin, tMax);
  if (!ray) return std::nullopt;
  RTCRayHit found = emptyHit(*ray);
  intersect(scene_->scene, found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  const std::size_t index = found.hit.primID;
  const TriangleIndices& triangle = mesh_->triangles()[index];
  const auto corner = [&](int i) { return glm::dvec3(mesh_->positions()[triangle[i]]); };
  const auto normal = [&](std::size_t i) { return Direction(mesh_->cornerNormals()[3 * index + i]); };
  const glm::dvec3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
  const glm::dvec2 w = exactWeights(origin, direction, a, ab, ac, {found.hit.u, found.hit.v});
  MeshHit hit{
      .t = 0, .triangle = found.hit.primID, .u = w.x, .v = w.y, .geometricNormal = glm::normalize(glm::cross(ab, ac))};
  hit.position = a + w.x * ab + w.y * ac;
  hit.t = glm::dot(hit.position - origin, direction) / glm::dot(direction, direction);
  const Direction shading = (1 - w.x - w.y) * normal(0) + w.x * normal(1) + w.y * normal(2);
  hit.shadingNormal = glm::dot(shading, hit.geometricNormal) > 0 ? glm::normalize(shading) : hit.geometricNormal;
  return hit;
}

bool MeshIntersector::occluded(const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const {
  std::optional<RTCRay> ray = scene_->localRay(origin, direction, tMin, tMax);
  if (!ray) return false;
  occlude(scene_->scene, *ray);
  return ray->tfar < 0;
}

}  // namespace gonio
