// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/ray.h"

namespace gonio {

/// A camera that orbits `target` in world coordinates (y up). With both angles 0 it looks along -z.
struct OrbitCamera {
  double yaw = 0;       ///< rad, about +y; positive moves the camera toward +x
  double pitch = 0;     ///< rad, positive moves the camera up, (-pi/2, pi/2)
  double distance = 4;  ///< of the eye from the target, in world units
  /// Full angle of view along the image's smaller side, rad; 0: an orthographic view with half extent 1.15, in world
  /// units about the target, along the image's smaller side.
  double fieldOfView = 0.55;
  Direction target{0};  ///< world
  bool operator==(const OrbitCamera&) const = default;
};

/// Defines the camera's rays, for CPU and shader. For a picture position (x, y) in [-1, 1], y up, and e = viewExtent():
/// perspective: origin eye, direction normalize(x e.x right + y e.y up + forward); orthographic: origin eye + x e.x
/// right + y e.y up, direction forward.
struct CameraFrame {
  Direction eye, right, up, forward;
  double halfExtent;  ///< half extent of the picture's smaller side, at distance 1 (perspective) or in world units
                      ///< (orthographic)
  bool orthographic;
};
CameraFrame cameraFrame(const OrbitCamera& camera);

/// Half width and half height of the view. The smaller side has the extent `halfExtent`, so that the target fits in
/// narrow and wide pictures. @param aspect width / height.
glm::dvec2 viewExtent(const CameraFrame& frame, double aspect);

Ray cameraRay(const CameraFrame& frame, double x, double y, double aspect);
/// The same for a given point (x e.x, y e.y).
inline Ray cameraRay(const CameraFrame& frame, const glm::dvec2& viewPoint) {
  const Direction across = viewPoint.x * frame.right + viewPoint.y * frame.up;
  if (frame.orthographic) return {frame.eye + across, frame.forward};
  return {frame.eye, glm::normalize(across + frame.forward)};
}

}  // namespace gonio
