// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_navigation.h"

#include <algorithm>
#include <cmath>

#include "core/rendering/shape.h"

namespace gonio::widgets {

namespace {
constexpr double orbitPerPixel = 0.008;  // rad
constexpr double maxPitch = 1.5;         // rad: short of the pole, where yaw loses its meaning
constexpr double nearestDistance = 1.2, farthestDistance = 40, farthestTarget = 10;
constexpr double zoomPerStep = 1.12;
}  // namespace

OrbitCamera orbited(const OrbitCamera& camera, double dx, double dy) {
  OrbitCamera result = camera;
  result.yaw = std::remainder(camera.yaw - orbitPerPixel * dx, 2 * pi);
  result.pitch = std::clamp(camera.pitch + orbitPerPixel * dy, -maxPitch, maxPitch);
  return result;
}

OrbitCamera panned(const OrbitCamera& camera, double x, double y) {
  const CameraFrame frame = cameraFrame(camera);
  const double atTarget = frame.halfExtent * (frame.orthographic ? 1 : camera.distance);
  OrbitCamera result = camera;
  result.target -= atTarget * (x * frame.right + y * frame.up);
  for (int axis = 0; axis < 3; ++axis)
    result.target[axis] = std::clamp(result.target[axis], -farthestTarget, farthestTarget);
  return result;
}

OrbitCamera zoomed(const OrbitCamera& camera, double steps, double x, double y) {
  OrbitCamera result = camera;
  result.distance = std::clamp(camera.distance * std::pow(zoomPerStep, -steps), nearestDistance, farthestDistance);
  if (cameraFrame(camera).orthographic) return result;
  const double ratio = camera.distance / result.distance;
  return panned(result, x * (1 - ratio), y * (1 - ratio));
}

double environmentTurn(double dx) { return orbitPerPixel * dx; }

Direction lightTowards(const OrbitCamera& camera, double x, double y, double aspect) {
  const Ray ray = cameraRay(cameraFrame(camera), x, y, aspect);
  const Direction closest = ray.origin - glm::dot(ray.origin, ray.direction) * ray.direction;
  const std::optional<ShapeHit> hit = nearestHit(Sphere{}, ray);
  const Direction normal = hit ? hit->shadingNormal : glm::normalize(closest);
  return glm::normalize(ray.direction - 2 * glm::dot(ray.direction, normal) * normal);
}

std::optional<double> viewerPolarAngle(const OrbitCamera& camera, double x, double y, double aspect) {
  const Ray ray = cameraRay(cameraFrame(camera), x, y, aspect);
  const std::optional<ShapeHit> hit = nearestHit(Sphere{}, ray);
  if (!hit) return std::nullopt;
  const Direction& normal = hit->shadingNormal;
  return std::atan2(glm::length(glm::cross(normal, ray.direction)), std::max(0.0, -glm::dot(normal, ray.direction)));
}

}  // namespace gonio::widgets
