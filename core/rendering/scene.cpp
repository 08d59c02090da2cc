// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene.h"

#include <algorithm>
#include <cmath>

namespace gonio::rendering {

CameraFrame cameraFrame(const OrbitCamera& camera) {
  constexpr double orthographicHalfExtent = 1.15;
  const double cosPitch = std::cos(camera.pitch);
  const Direction backward{std::sin(camera.yaw) * cosPitch, std::sin(camera.pitch), std::cos(camera.yaw) * cosPitch};
  CameraFrame frame;
  frame.eye = camera.target + camera.distance * backward;
  frame.forward = -backward;
  frame.right = {std::cos(camera.yaw), 0, -std::sin(camera.yaw)};
  frame.up = glm::cross(frame.right, frame.forward);
  frame.orthographic = camera.fieldOfView <= 0;
  frame.halfExtent = frame.orthographic ? orthographicHalfExtent : std::tan(camera.fieldOfView / 2);
  return frame;
}

glm::dvec2 viewExtent(const CameraFrame& frame, double aspect) {
  return frame.halfExtent * (aspect > 1 ? glm::dvec2(aspect, 1) : glm::dvec2(1, 1 / aspect));
}

Ray cameraRay(const CameraFrame& frame, double x, double y, double aspect) {
  return cameraRay(frame, glm::dvec2(x, y) * viewExtent(frame, aspect));
}

int materialSlotCount(const Scene& scene) {
  int count = 0;
  for (const SceneObject& object : scene.objects)
    if (const auto* slot = std::get_if<MaterialSlot>(&object.material); slot && !object.emits())
      count = std::max(count, slot->number + 1);
  return count;
}

Scene sphereScene(std::shared_ptr<const EnvironmentMap> environment, const OrbitCamera& camera) {
  Scene scene;
  scene.name = "sphere";
  scene.camera = camera;
  scene.objects.push_back({.name = "sphere", .shape = Sphere{}});
  if (!environment) scene.directionalLights.emplace_back();
  scene.environment = std::move(environment);
  return scene;
}

}  // namespace gonio::rendering
