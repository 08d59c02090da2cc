// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/scene.h"

#include <algorithm>

namespace gonio {

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

}  // namespace gonio
