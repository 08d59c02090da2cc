// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include "core/math/image.h"
#include "core/rendering/environment.h"

namespace gonio {

/// A camera that orbits a point of the world (y up), for the sphere previews the centre of the unit sphere at the
/// origin. With both angles 0 it looks along -z.
struct OrbitCamera {
  double yaw = 0;             ///< rad, about +y; positive moves the camera toward +x
  double pitch = 0;           ///< rad, positive moves the camera up, (-pi/2, pi/2)
  double distance = 4;        ///< of the eye from the target; > 1 for the sphere
  double fieldOfView = 0.55;  ///< of the picture's smaller side, rad; 0 is an orthographic view that shows |y| <= 1.15
  Direction target{0};        ///< world
  bool operator==(const OrbitCamera&) const = default;
};

/// The camera's rays, for the CPU and the shader alike. A picture position (x, y) in [-1, 1], y up, with the extent e
/// of viewExtent() gives: perspective: origin eye, direction normalize(x e.x right + y e.y up + forward); orthographic:
/// origin eye + x e.x right + y e.y up, direction forward.
struct CameraFrame {
  Direction eye, right, up, forward;
  double halfExtent;  ///< of the picture's smaller side, at distance 1 (perspective) or in the world (orthographic)
  bool orthographic;
};
CameraFrame cameraFrame(const OrbitCamera& camera);

/// Half width and half height of the view for a picture of aspect width / height: the sphere fits into a narrow picture
/// as into a wide one.
glm::dvec2 viewExtent(const CameraFrame& frame, double aspect);

struct CameraRay {
  Direction origin, direction;  ///< world, `direction` unit
};
CameraRay cameraRay(const CameraFrame& frame, double x, double y, double aspect);
/// The same at (x e.x, y e.y).
inline CameraRay cameraRay(const CameraFrame& frame, const glm::dvec2& viewPoint) {
  const Direction across = viewPoint.x * frame.right + viewPoint.y * frame.up;
  if (frame.orthographic) return {frame.eye + across, frame.forward};
  return {frame.eye, glm::normalize(across + frame.forward)};
}

/// The normal (= position) at which a ray meets the unit sphere first, world; nothing where it passes by. Exact at the
/// silhouette: from the ray's closest point to the centre. The centre lies ahead of the ray's origin, outside.
std::optional<Direction> sphereHit(const CameraRay& ray);

/// The shading frame of a point on the sphere: `tangent` points along the right-handed rotation about +y (seen from
/// outside: to the right), `bitangent` = normal x tangent (seen from outside: up); at the poles the tangent is +x.
struct ShadingFrame {
  Direction tangent, bitangent, normal;  ///< world, orthonormal, right-handed

  Direction toLocal(const Direction& world) const {
    return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
  }
  Direction toWorld(const Direction& local) const { return local.x * tangent + local.y * bitangent + local.z * normal; }
};
inline ShadingFrame shadingFrame(const Direction& normal) {
  const double radius = std::sqrt(normal.x * normal.x + normal.z * normal.z);
  const Direction tangent = radius > 0 ? Direction{normal.z / radius, 0, -normal.x / radius} : Direction{1, 0, 0};
  return {tangent, glm::cross(normal, tangent), normal};
}

/// Radiance that arrives from one direction: `toLight` in world space (unit), `irradiance` perpendicular to it.
struct DirectionalLight {
  Direction toLight{0.4082482904638631, 0.4082482904638631, 0.8164965809277261};
  Rgb irradiance{pi};
};

/// One sphere under one light: what the previews, thumbnails and the rendered SNR show. The environment lights the
/// sphere where it is given, else the directional light does.
struct SphereScene {
  OrbitCamera camera;
  DirectionalLight light;
  std::shared_ptr<const EnvironmentMap> environment;
  double environmentRotation = 0;  ///< rad about +y; positive turns the surroundings from -z toward +x
  bool showEnvironment = false;    ///< draw the environment behind the sphere (else black, alpha 0)
};

/// The turn of an environment about +y: from a world direction to the direction of the environment's picture that is
/// seen there, and back. With c, s the cosine and sine of the angle (rad): (x c + z s, y, z c - x s).
class EnvironmentRotation {
 public:
  explicit EnvironmentRotation(double angle);
  Direction toEnvironment(const Direction& w) const { return {w.x * c_ + w.z * s_, w.y, w.z * c_ - w.x * s_}; }
  Direction fromEnvironment(const Direction& w) const { return {w.x * c_ - w.z * s_, w.y, w.z * c_ + w.x * s_}; }

 private:
  double c_, s_;
};

}  // namespace gonio
