// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <limits>
#include <random>

#include "core/rendering/scene.h"
#include "core/rendering/scene_light.h"
#include "tests/support/simple_meshes.h"

/// Shapes and scenes of shapes drawn by chance, and points on them.
namespace gonio::test {

/// In [0, 1).
inline double uniform(std::mt19937_64& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

inline rendering::MeshShape meshShape(geometry::TriangleMesh mesh) {
  return std::make_shared<const geometry::MeshIntersector>(shared(std::move(mesh)));
}

/// About a place within `spread` of the origin, of half sides of 0.1 to 1.
inline rendering::Rectangle randomRectangle(std::mt19937_64& random, double spread) {
  const Direction u = randomDirection(random), v = glm::normalize(glm::cross(u, randomDirection(random)));
  return {spread * uniform(random) * randomDirection(random), (0.1 + 0.9 * uniform(random)) * u,
          (0.1 + 0.9 * uniform(random)) * v};
}

/// Points on the surface with their outward normals, spread over all of it.
struct SurfacePoint {
  Direction position, normal;
};
inline SurfacePoint randomSurfacePoint(const rendering::Shape& shape, std::mt19937_64& random) {
  if (const auto* sphere = std::get_if<rendering::Sphere>(&shape)) {
    const Direction normal = randomDirection(random);
    return {sphere->centre + sphere->radius * normal, normal};
  }
  if (const auto* rectangle = std::get_if<rendering::Rectangle>(&shape))
    return {rectangle->at(2 * uniform(random) - 1, 2 * uniform(random) - 1), rectangle->normal()};
  const geometry::TriangleMesh& mesh = std::get<rendering::MeshShape>(shape)->mesh();
  const std::size_t triangle = random() % mesh.triangles().size();
  const auto corner = [&](int i) { return Direction(mesh.positions()[mesh.triangles()[triangle][i]]); };
  double u = uniform(random), v = uniform(random);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0)), mesh.geometricNormal(triangle)};
}

inline std::vector<Direction> surfacePoints(const rendering::Shape& shape, int count, std::mt19937_64& random) {
  std::vector<Direction> points;
  for (int i = 0; i < count; ++i) points.push_back(randomSurfacePoint(shape, random).position);
  return points;
}

/// A way from a place to a source, drawn by chance; length 0 where the source does not send that way.
struct Way {
  Direction direction{0};
  double length = 0;
};
inline Way randomWay(const rendering::Scene& scene, const rendering::SceneLight& light, const Direction& from,
                     std::mt19937_64& random) {
  if (light.kind == rendering::SceneLight::Kind::directional)
    return {scene.directionalLights[light.index].toLight, std::numeric_limits<double>::infinity()};
  if (light.kind == rendering::SceneLight::Kind::environment)
    return {randomDirection(random), std::numeric_limits<double>::infinity()};
  const SurfacePoint end = light.kind == rendering::SceneLight::Kind::point
                               ? SurfacePoint{scene.pointLights[light.index].position, Direction(0)}
                               : randomSurfacePoint(scene.objects[light.index].shape, random);
  const double length = glm::length(end.position - from);
  const Direction direction = (end.position - from) / length;
  if (light.kind == rendering::SceneLight::Kind::rectangle && !(glm::dot(end.normal, direction) < 0)) return {};
  return {direction, length};
}

}  // namespace gonio::test
