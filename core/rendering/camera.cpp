// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/camera.h"

#include <cmath>

namespace gonio {

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

}  // namespace gonio
