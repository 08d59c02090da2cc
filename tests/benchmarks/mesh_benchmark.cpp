// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include <filesystem>
#include <limits>
#include <random>

#include "core/geometry/bundled_meshes.h"
#include "core/geometry/mesh_intersector.h"
#include "core/io/mesh_file.h"

using namespace gonio;
using namespace gonio::geometry;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using MeshPointer = std::shared_ptr<const TriangleMesh>;

const std::filesystem::path spotFile = std::filesystem::path(GONIO_SHARED_DIR) / "data/meshes/spot.obj";

MeshPointer shaderBall() { return bundledMesh("shader-ball"); }
/// Null where the shared data are not at hand.
MeshPointer spot() {
  static const MeshPointer mesh =
      std::filesystem::exists(spotFile) ? std::make_shared<const TriangleMesh>(io::readObj(spotFile).mesh) : nullptr;
  return mesh;
}

struct Ray {
  glm::dvec3 origin, direction;
};

/// From all sides at points in the bounding sphere: neighbours have nothing in common, as after a bounce.
std::vector<Ray> scatteredRays(const TriangleMesh& mesh, std::size_t count) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto onSphere = [&] { return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))); };
  const auto& [centre, radius] = mesh.boundingSphere();
  std::vector<Ray> rays(count);
  for (Ray& ray : rays) {
    ray.origin = centre + 2 * radius * onSphere();
    ray.direction = glm::normalize(centre + 0.7 * radius * onSphere() - ray.origin);
  }
  return rays;
}

/// Those of a picture, row by row.
std::vector<Ray> cameraRays(const TriangleMesh& mesh, int perAxis) {
  const auto& [centre, radius] = mesh.boundingSphere();
  std::vector<Ray> rays;
  for (int y = 0; y < perAxis; ++y)
    for (int x = 0; x < perAxis; ++x) {
      const glm::dvec3 target(2 * (x + 0.5) / perAxis - 1, 1 - 2 * (y + 0.5) / perAxis, 0);
      const glm::dvec3 eye(0, 0, 4);
      rays.push_back({centre + radius * eye, glm::normalize(target - eye)});
    }
  return rays;
}

/// `trace(ray)` for all rays, over and over; rays a second.
template <typename Trace>
void measure(benchmark::State& state, const std::vector<Ray>& rays, Trace trace) {
  for (auto _ : state)
    for (const Ray& ray : rays) benchmark::DoNotOptimize(trace(ray));
  state.SetItemsProcessed(state.iterations() * std::int64_t(rays.size()));
}

template <MeshPointer (*mesh)()>
void scattered(benchmark::State& state) {
  if (!mesh()) return state.SkipWithError("the shared data are not at hand");
  const MeshIntersector intersector(mesh());
  measure(state, scatteredRays(*mesh(), 1 << 16),
          [&](const Ray& ray) { return intersector.closest(ray.origin, ray.direction, 0, infinity); });
}
void meshScatteredRaysShaderBall(benchmark::State& state) { scattered<shaderBall>(state); }
void meshScatteredRaysSpot(benchmark::State& state) { scattered<spot>(state); }
BENCHMARK(meshScatteredRaysShaderBall);
BENCHMARK(meshScatteredRaysSpot);

template <MeshPointer (*mesh)()>
void camera(benchmark::State& state) {
  if (!mesh()) return state.SkipWithError("the shared data are not at hand");
  const MeshIntersector intersector(mesh());
  measure(state, cameraRays(*mesh(), 256),
          [&](const Ray& ray) { return intersector.closest(ray.origin, ray.direction, 0, infinity); });
}
void meshCameraRaysShaderBall(benchmark::State& state) { camera<shaderBall>(state); }
void meshCameraRaysSpot(benchmark::State& state) { camera<spot>(state); }
BENCHMARK(meshCameraRaysShaderBall);
BENCHMARK(meshCameraRaysSpot);

void meshShadowRaysShaderBall(benchmark::State& state) {
  const MeshIntersector intersector(shaderBall());
  measure(state, scatteredRays(*shaderBall(), 1 << 16),
          [&](const Ray& ray) { return intersector.occluded(ray.origin, ray.direction, 0, infinity); });
}
BENCHMARK(meshShadowRaysShaderBall);

/// The plain baseline: Möller and Trumbore 1997 over all triangles.
void meshPlainBaselineShaderBall(benchmark::State& state) {
  const TriangleMesh& mesh = *shaderBall();
  measure(state, scatteredRays(mesh, 64), [&](const Ray& ray) {
    double nearest = infinity;
    for (const TriangleIndices& t : mesh.triangles()) {
      const glm::dvec3 a(mesh.positions()[t[0]]),
          ab = glm::dvec3(mesh.positions()[t[1]]) - a, ac = glm::dvec3(mesh.positions()[t[2]]) - a,
          p = glm::cross(ray.direction, ac), arm = ray.origin - a, q = glm::cross(arm, ab);
      const double inverse = 1 / glm::dot(ab, p), u = glm::dot(arm, p) * inverse,
                   v = glm::dot(ray.direction, q) * inverse, distance = glm::dot(ac, q) * inverse;
      if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest) nearest = distance;
    }
    return nearest;
  });
}
BENCHMARK(meshPlainBaselineShaderBall)->Unit(benchmark::kMillisecond);

/// The floor: Embree alone, the same scene and rays in single precision, no hit made of what it finds.
void meshEmbreeFloorShaderBall(benchmark::State& state) {
  const TriangleMesh& mesh = *shaderBall();
  const RTCDevice device = rtcNewDevice(nullptr);
  const RTCScene scene = rtcNewScene(device);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions().size()));
  auto* indices = static_cast<TriangleIndices*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(TriangleIndices), mesh.triangles().size()));
  std::copy(mesh.positions().begin(), mesh.positions().end(), vertices);
  std::copy(mesh.triangles().begin(), mesh.triangles().end(), indices);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene);
  measure(state, scatteredRays(mesh, 1 << 16), [&](const Ray& ray) {
    const glm::vec3 o(ray.origin), d(ray.direction);
    RTCRayHit hit{};
    hit.ray = {.org_x = o.x, .org_y = o.y, .org_z = o.z, .dir_x = d.x, .dir_y = d.y, .dir_z = d.z};
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.mask = ~0u;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(scene, hit);
    return hit.ray.tfar;
  });
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}
BENCHMARK(meshEmbreeFloorShaderBall);

/// Bounding volumes of 50,528 triangles.
void meshBuildShaderBall(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(MeshIntersector(shaderBall()));
}
BENCHMARK(meshBuildShaderBall)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The arrays, and all that a TriangleMesh finds out of them.
void meshMakeShaderBall(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(shaderBallMesh());
}
BENCHMARK(meshMakeShaderBall)->Unit(benchmark::kMillisecond)->UseRealTime();

void meshReadSpot(benchmark::State& state) {
  if (!spot()) return state.SkipWithError("the shared data are not at hand");
  for (auto _ : state) benchmark::DoNotOptimize(io::readObj(spotFile));
}
BENCHMARK(meshReadSpot)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
