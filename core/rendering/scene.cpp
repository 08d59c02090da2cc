// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene.h"

#include <algorithm>

namespace gonio {

int lookedAtCount(const Scene& scene) {
  int count = 0;
  for (const SceneObject& object : scene.objects)
    if (const auto* lookedAt = std::get_if<LookedAt>(&object.material); lookedAt && !object.emits())
      count = std::max(count, lookedAt->number + 1);
  return count;
}

Scene sceneOf(const SphereScene& sphere) {
  Scene scene;
  scene.name = "sphere";
  scene.camera = sphere.camera;
  scene.objects.push_back({.name = "sphere", .shape = Sphere{}});
  if (sphere.environment)
    scene.environment = sphere.environment;
  else
    scene.directionalLights.push_back(sphere.light);
  scene.environmentRotation = sphere.environmentRotation;
  scene.showEnvironment = sphere.showEnvironment;
  return scene;
}

}  // namespace gonio
