// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/sphere_scene.h"

#include <cmath>

namespace gonio {

CameraFrame cameraFrame(const OrbitCamera& camera) {
  constexpr double orthographicHalfHeight = 1.15;
  const double cosPitch = std::cos(camera.pitch);
  const Direction backward{std::sin(camera.yaw) * cosPitch, std::sin(camera.pitch), std::cos(camera.yaw) * cosPitch};
  CameraFrame frame;
  frame.eye = camera.distance * backward;
  frame.forward = -backward;
  frame.right = {std::cos(camera.yaw), 0, -std::sin(camera.yaw)};
  frame.up = glm::cross(frame.right, frame.forward);
  frame.orthographic = camera.fieldOfView <= 0;
  frame.halfHeight = frame.orthographic ? orthographicHalfHeight : std::tan(camera.fieldOfView / 2);
  return frame;
}

}  // namespace gonio
