// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

namespace gonio::rendering {

namespace {

using Support = std::function<Direction(const Direction&)>;

bool isBlack(const EnvironmentMap& environment) {
  return std::ranges::all_of(environment.image().pixels, [](const glm::vec3& p) { return p == glm::vec3(0); });
}

/// The hull of a receiver and its light paths to a source; an environment has no such hull.
struct LightPaths {
  Support support;
  /// Direction in which the paths are unbounded; 0 if they are bounded.
  Direction unbounded{0};
};

LightPaths lightPathsTo(const Scene& scene, const SceneLight& light, const Shape& receiver) {
  if (light.kind == SceneLight::Kind::directional)
    return {[&receiver](const Direction& d) { return supportPoint(receiver, d); },
            scene.directionalLights[light.index].toLight};
  const auto with = [&receiver](Support end) -> Support {
    return [&receiver, end = std::move(end)](const Direction& d) {
      const Direction start = supportPoint(receiver, d), stop = end(d);
      return glm::dot(start, d) >= glm::dot(stop, d) ? start : stop;
    };
  };
  if (light.kind == SceneLight::Kind::point)
    return {with([p = scene.pointLights[light.index].position](const Direction&) { return p; })};
  return {with([&shape = scene.objects[light.index].shape](const Direction& d) { return supportPoint(shape, d); })};
}

/// Whether the plane with this normal has all paths on its side and the blocker on the other, or both touch it.
bool separates(const Direction& normal, const LightPaths& paths, const Shape& blocker, double tolerance) {
  if (glm::dot(paths.unbounded, normal) < -1e-12) return false;
  return glm::dot(paths.support(-normal), normal) >= support(blocker, normal) - tolerance;
}

/// Looks for a separating plane: first among the directions that scenes are built on, then by the method of Frank and
/// Wolfe (1956), which walks to the shortest vector of the difference of both hulls; that vector is the plane's normal.
bool areSeparated(const LightPaths& paths, const Shape& blocker, double size) {
  const double tolerance = 1e-9 * size;
  std::vector<Direction> candidates{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  if (const auto* rectangle = std::get_if<Rectangle>(&blocker))
    candidates.insert(candidates.end(), {rectangle->normal(), -rectangle->normal()});
  for (const Direction& normal : candidates)
    if (separates(normal, paths, blocker, tolerance)) return true;
  Direction shortest = paths.support({0, 1, 0}) - boundingSphere(blocker).centre;
  constexpr int steps = 64;
  for (int step = 0; step < steps; ++step) {
    const double length = glm::length(shortest);
    if (length < tolerance) return false;
    Direction normal = shortest / length;
    // LightPaths without end admit only normals that do not turn against them.
    const double against = std::min(0.0, glm::dot(paths.unbounded, normal));
    const Direction admitted = normal - against * paths.unbounded;
    if (glm::length(admitted) < 1e-6) return false;
    normal = glm::normalize(admitted);
    if (separates(normal, paths, blocker, tolerance)) return true;
    Direction farthest = paths.support(-normal) - supportPoint(blocker, normal);
    // Along the unbounded direction the hull is free: the nearest of these points to the origin.
    farthest -= std::min(0.0, glm::dot(farthest, paths.unbounded)) * paths.unbounded;
    shortest -= std::min(0.0, glm::dot(shortest, paths.unbounded)) * paths.unbounded;
    const Direction change = farthest - shortest;
    const double squared = glm::dot(change, change);
    if (squared < tolerance * tolerance) return false;
    shortest += std::clamp(-glm::dot(shortest, change) / squared, 0.0, 1.0) * change;
  }
  return false;
}

/// Whether some point of `other` lies before the front of a rectangle; other shapes have points that face everywhere.
bool someLiesBefore(const Shape& shape, const Shape& other) {
  const auto* rectangle = std::get_if<Rectangle>(&shape);
  if (!rectangle) return true;
  const Direction normal = rectangle->normal();
  return support(other, normal) > glm::dot(rectangle->centre, normal) + 1e-9 * boundingSphere(other).radius;
}

bool facesPoint(const Shape& shape, const Direction& point) {
  if (const auto* rectangle = std::get_if<Rectangle>(&shape))
    return glm::dot(point - rectangle->centre, rectangle->normal()) > 0;
  return !encloses(shape, point);
}

double distanceFrom(const Shape& shape, const Direction& point) {
  if (const auto* rectangle = std::get_if<Rectangle>(&shape)) {
    const Direction offset = point - rectangle->centre;
    const auto part = [&](const Direction& half) {
      return std::clamp(glm::dot(offset, half) / glm::dot(half, half), -1.0, 1.0) * half;
    };
    return glm::length(offset - part(rectangle->halfU) - part(rectangle->halfV));
  }
  const Sphere sphere = boundingSphere(shape);
  return std::max(0.0, glm::length(point - sphere.centre) - sphere.radius);
}

}  // namespace

std::vector<SceneLight> lightsOf(const Scene& scene) {
  using Kind = SceneLight::Kind;
  std::vector<SceneLight> lights;
  for (std::size_t i = 0; i < scene.directionalLights.size(); ++i)
    if (maxChannel(scene.directionalLights[i].irradiance) > 0) lights.push_back({Kind::directional, i});
  for (std::size_t i = 0; i < scene.pointLights.size(); ++i)
    if (maxChannel(scene.pointLights[i].intensity) > 0) lights.push_back({Kind::point, i});
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].emits()) lights.push_back({Kind::rectangle, i});
  if (scene.environment && !isBlack(*scene.environment)) lights.push_back({Kind::environment});
  return lights;
}

std::string lightName(const Scene& scene, const SceneLight& light) {
  const auto numbered = [&](const char* name, std::size_t count) {
    return count == 1 ? std::string("the ") + name : name + (' ' + std::to_string(light.index + 1));
  };
  switch (light.kind) {
    case SceneLight::Kind::directional:
      return numbered("distant light", scene.directionalLights.size());
    case SceneLight::Kind::point:
      return numbered("point light", scene.pointLights.size());
    case SceneLight::Kind::rectangle:
      return scene.objects[light.index].name;
    case SceneLight::Kind::environment:
      break;
  }
  return "the environment '" + std::filesystem::path(scene.environment->name()).stem().string() + "'";
}

bool canReach(const Scene& scene, const SceneLight& light, const SceneObject& receiver) {
  if (receiver.emits()) return false;
  switch (light.kind) {
    case SceneLight::Kind::environment:
      return true;
    case SceneLight::Kind::directional: {
      const auto* rectangle = std::get_if<Rectangle>(&receiver.shape);
      return !rectangle || glm::dot(rectangle->normal(), scene.directionalLights[light.index].toLight) > 0;
    }
    case SceneLight::Kind::point:
      return facesPoint(receiver.shape, scene.pointLights[light.index].position);
    case SceneLight::Kind::rectangle:
      break;
  }
  const auto& emitter = std::get<Rectangle>(scene.objects[light.index].shape);
  if (!someLiesBefore(emitter, receiver.shape)) return false;
  // Outside a convex receiver lies a corner, where any point of the emitter does.
  for (const auto& [u, v] : {std::pair{-1, -1}, {-1, 1}, {1, -1}, {1, 1}})
    if (facesPoint(receiver.shape, emitter.at(u, v))) return true;
  return false;
}

bool mayBlock(const Scene& scene, const SceneLight& light, const SceneObject& receiver, const SceneObject& blocker) {
  if (&receiver == &blocker) return !isConvex(receiver.shape);
  // The way to a rectangle ends at it.
  if (light.kind == SceneLight::Kind::rectangle && &scene.objects[light.index] == &blocker) return false;
  if (light.kind == SceneLight::Kind::environment) return someLiesBefore(receiver.shape, blocker.shape);
  const double size = std::min(boundingSphere(receiver.shape).radius, boundingSphere(blocker.shape).radius);
  return !areSeparated(lightPathsTo(scene, light, receiver.shape), blocker.shape, size);
}

bool maySee(const SceneObject& receiver, const SceneObject& other) {
  if (receiver.emits() || other.emits()) return false;
  if (&receiver == &other) return !isConvex(receiver.shape);
  return someLiesBefore(receiver.shape, other.shape) && someLiesBefore(other.shape, receiver.shape);
}

double maxFormFactor(const SceneObject& receiver, const SceneObject& other) {
  if (&receiver == &other) return 1;
  const Sphere bound = boundingSphere(other.shape);
  const double ratio = bound.radius / std::max(bound.radius, distanceFrom(receiver.shape, bound.centre));
  return ratio * ratio;
}

}  // namespace gonio::rendering
