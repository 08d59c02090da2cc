// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/math/types.h"
#include "core/rendering/environment.h"
#include "core/rendering/shape.h"

namespace gonio::rendering {

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

/// The material of an object: one of the scene's slots, to which the user assigns materials, or a Lambertian surface
/// (linear RGB reflectance, 0 to 1), for grounds and backdrops.
struct MaterialSlot {
  int number = 0;
};
struct Diffuse {
  Rgb reflectance{0.5};
};
using SceneMaterial = std::variant<MaterialSlot, Diffuse>;

/// An object of a scene. A rectangle may emit: then it has `radiance` (linear RGB) on its front, equal in all
/// directions, and does not reflect.
struct SceneObject {
  std::string name;
  Shape shape;
  SceneMaterial material = MaterialSlot{};
  Rgb radiance{0};

  bool emits() const { return maxChannel(radiance) > 0; }
};

/// Light from one direction.
struct DirectionalLight {
  Direction toLight{0.4082482904638631, 0.4082482904638631, 0.8164965809277261};  ///< world, unit
  Rgb irradiance{pi};  ///< linear RGB, perpendicular to the direction
};

/// Light from one point: radiant intensity, linear RGB per sr.
struct PointLight {
  Direction position{0, 4, 0};
  Rgb intensity{10};
};

/// The axis of a mesh file that points up.
enum class UpAxis { y, z };

/// How a mesh file stands in its scene: the axis that points up, then quarter turns about it, counterclockwise as seen
/// from above. Without turns, the viewer sees the side of the mesh that faces along +z (y up, as in glTF) or -y (z up).
struct MeshPose {
  MeshPose(UpAxis upAxis = UpAxis::y, int turns = 0) : up(upAxis), quarterTurns(turns) {}

  UpAxis up;
  int quarterTurns;  ///< 0 to 3
  bool operator==(const MeshPose&) const = default;
};

/// A scene in world coordinates (y up). Copies share meshes and environments.
struct Scene {
  std::string name, description;
  std::string source;  ///< the argument of openScene(): the name of a bundled scene, or a path; empty for others
  MeshPose pose;       ///< the argument of openScene()
  OrbitCamera camera;
  std::vector<SceneObject> objects;
  std::vector<DirectionalLight> directionalLights;
  std::vector<PointLight> pointLights;
  std::shared_ptr<const EnvironmentMap> environment;
  double environmentRotation = 0;  ///< rad, see EnvironmentRotation
  bool showEnvironment = false;    ///< whether the environment is visible behind the objects; false: black, alpha 0
  bool blurBackground = false;     ///< whether the visible environment is out of focus, see blurredEnvironment()
  std::vector<std::string> notes;  ///< what the readers of its meshes changed, for people
};

/// The number of materials that the scene needs: the highest slot number plus 1.
int materialSlotCount(const Scene& scene);

/// The scene of previews and thumbnails: the unit sphere at the origin in an environment, or in the default directional
/// light if it is null.
Scene sphereScene(std::shared_ptr<const EnvironmentMap> environment = nullptr, const OrbitCamera& camera = {});

}  // namespace gonio::rendering
