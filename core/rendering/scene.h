// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/rendering/camera.h"
#include "core/rendering/environment.h"
#include "core/rendering/shape.h"

namespace gonio {

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

/// A scene in world coordinates (y up). Copies share meshes and environments.
struct Scene {
  std::string name, description;
  std::string source;  ///< the argument of openScene(): the name of a bundled scene, or a path; empty for others
  OrbitCamera camera;
  std::vector<SceneObject> objects;
  std::vector<DirectionalLight> directionalLights;
  std::vector<PointLight> pointLights;
  std::shared_ptr<const EnvironmentMap> environment;
  double environmentRotation = 0;  ///< rad, see EnvironmentRotation
  bool showEnvironment = false;    ///< whether the environment is visible behind the objects; false: black, alpha 0
  bool blurBackground = false;     ///< whether the visible environment is out of focus, see blurredEnvironment()
};

/// The number of materials that the scene needs: the highest slot number plus 1.
int materialSlotCount(const Scene& scene);

/// The scene of previews and thumbnails: the unit sphere at the origin in an environment, or in the default directional
/// light if it is null.
Scene sphereScene(std::shared_ptr<const EnvironmentMap> environment = nullptr, const OrbitCamera& camera = {});

}  // namespace gonio
