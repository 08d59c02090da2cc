// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/geometry/mesh_intersector.h"

#include <tbb/task_arena.h>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <string>

#include "core/support/error.h"

namespace gonio::geometry {

RTCDevice embreeDevice() {
  static const RTCDevice shared = rtcNewDevice(nullptr);
  return shared;
}

void throwIfEmbreeFailed() {
  if (const RTCError error = rtcGetDeviceError(embreeDevice()); error != RTC_ERROR_NONE)
    throw Error("mesh: the bounding volumes could not be built (Embree's error " + std::to_string(int(error)) +
                (error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory)" : ")"));
}

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

namespace {

/// A node or a leaf while Embree builds.
struct Built {
  Built* children[2] = {nullptr, nullptr};
  AxisBox boxes[2] = {};
  std::vector<std::uint32_t> primitives;  ///< of a leaf

  bool isLeaf() const { return !primitives.empty(); }
};
using BuiltTree = std::deque<Built>;

AxisBox boxOf(const RTCBounds& bounds) {
  return {{bounds.lower_x, bounds.lower_y, bounds.lower_z}, {bounds.upper_x, bounds.upper_y, bounds.upper_z}};
}

AxisBox emptyBox() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return {glm::vec3(infinity), glm::vec3(-infinity)};
}

void* createNode(RTCThreadLocalAllocator, unsigned int, void* tree) {
  return &static_cast<BuiltTree*>(tree)->emplace_back();
}

void setChildren(void* node, void** children, unsigned int count, void*) {
  for (unsigned int i = 0; i < count; ++i) static_cast<Built*>(node)->children[i] = static_cast<Built*>(children[i]);
}

void setBounds(void* node, const RTCBounds** bounds, unsigned int count, void*) {
  for (unsigned int i = 0; i < count; ++i) static_cast<Built*>(node)->boxes[i] = boxOf(*bounds[i]);
}

void* createLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t count, void* tree) {
  Built& leaf = static_cast<BuiltTree*>(tree)->emplace_back();
  for (std::size_t i = 0; i < count; ++i) leaf.primitives.push_back(primitives[i].primID);
  return &leaf;
}

/// Embree's tree of the primitives; the nodes live in `tree`.
const Built& build(std::vector<RTCBuildPrimitive>& primitives, BuiltTree& tree) {
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> volumes(rtcNewBVH(embreeDevice()), rtcReleaseBVH);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxLeafSize = BoundingVolumes::maxInLeaf;
  arguments.bvh = volumes.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = createNode;
  arguments.setNodeChildren = setChildren;
  arguments.setNodeBounds = setBounds;
  arguments.createLeaf = createLeaf;
  arguments.userPtr = &tree;
  void* root = nullptr;
  tbb::task_arena alone(1);
  alone.execute([&] { root = rtcBuildBVH(&arguments); });
  throwIfEmbreeFailed();
  assert(root);
  return *static_cast<const Built*>(root);
}

class Flattening {
 public:
  explicit Flattening(BoundingVolumes& volumes) : volumes_(volumes) {}

  BoundingVolumes::Child child(const Built& built, const AxisBox& box, int depth) {
    if (built.isLeaf()) {
      const auto first = std::uint32_t(volumes_.order.size());
      volumes_.order.insert(volumes_.order.end(), built.primitives.begin(), built.primitives.end());
      return {box, first, std::uint32_t(built.primitives.size())};
    }
    const std::size_t index = volumes_.nodes.size();
    volumes_.nodes.emplace_back();
    volumes_.depth = std::max(volumes_.depth, depth);
    for (int i = 0; i < 2; ++i) {
      const BoundingVolumes::Child found = child(*built.children[i], built.boxes[i], depth + 1);
      volumes_.nodes[index].children[i] = found;
    }
    return {box, std::uint32_t(index), 0};
  }

 private:
  BoundingVolumes& volumes_;
};

}  // namespace

BoundingVolumes buildBoundingVolumes(std::span<const AxisBox> boxes) {
  assert(!boxes.empty());
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(boxes.size());
  AxisBox whole = emptyBox();
  for (const AxisBox& box : boxes) {
    primitives.push_back(
        {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, unsigned(primitives.size())});
    whole = {glm::min(whole.min, box.min), glm::max(whole.max, box.max)};
  }
  BuiltTree tree;
  const Built& root = build(primitives, tree);
  BoundingVolumes volumes;
  volumes.order.reserve(boxes.size());
  const BoundingVolumes::Child top = Flattening(volumes).child(root, whole, 1);
  if (volumes.nodes.empty()) {
    volumes.nodes.push_back({{top, {emptyBox(), 0, 0}}});
    volumes.depth = 1;
  }
  return volumes;
}

}  // namespace gonio::geometry
