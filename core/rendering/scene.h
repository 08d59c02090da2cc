// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "core/rendering/camera.h"
#include "core/rendering/environment.h"
#include "core/rendering/shape.h"

namespace gonio {

/// What an object is made of: the material in one of the scene's slots, which the user fills, or a Lambertian surface
/// of some reflectance (linear RGB, 0 to 1), which grounds and backdrops have.
struct MaterialSlot {
  int number = 0;
};
struct Diffuse {
  Rgb reflectance{0.5};
};
using SceneMaterial = std::variant<MaterialSlot, Diffuse>;

/// One thing in a scene. A rectangle may emit: then it sends `radiance` (linear RGB) from its front, equal in all
/// directions, and reflects nothing.
struct SceneObject {
  std::string name;
  Shape shape;
  SceneMaterial material = MaterialSlot{};
  Rgb radiance{0};

  bool emits() const { return maxChannel(radiance) > 0; }
};

/// Radiance that arrives from one direction.
struct DirectionalLight {
  Direction toLight{0.4082482904638631, 0.4082482904638631, 0.8164965809277261};  ///< world, unit
  Rgb irradiance{pi};                                                             ///< perpendicular to the direction
};

/// Light from one point: radiant intensity, linear RGB per sr.
struct PointLight {
  Direction position{0, 4, 0};
  Rgb intensity{10};
};

/// What a picture shows, in world coordinates (y up). Plain values: two scenes may share meshes and environments.
struct Scene {
  std::string name, description;
  std::string source;  ///< what openScene() took: the name of a bundled one, or a path; empty for others
  OrbitCamera camera;
  std::vector<SceneObject> objects;
  std::vector<DirectionalLight> directionalLights;
  std::vector<PointLight> pointLights;
  std::shared_ptr<const EnvironmentMap> environment;
  double environmentRotation = 0;  ///< rad, see EnvironmentRotation
  bool showEnvironment = false;    ///< draw the environment behind the objects (else black, alpha 0)
  bool blurBackground = false;     ///< out of focus, see blurredEnvironment()
};

/// One more than the highest number of a slot: how many materials the scene asks for.
int materialSlotCount(const Scene& scene);

/// The unit sphere at the origin in an environment, or, where that is null, in the default directional light: what
/// previews and thumbnails show.
Scene sphereScene(std::shared_ptr<const EnvironmentMap> environment = nullptr, const OrbitCamera& camera = {});

}  // namespace gonio
