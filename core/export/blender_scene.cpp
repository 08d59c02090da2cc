// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/blender_scene.h"

#include "core/export/blender_scene_program.h"
#include "core/io/json_text.h"
#include "core/support/plain_text.h"

namespace gonio::exports {

namespace {

using SceneJson = nlohmann::ordered_json;

SceneJson triple(const Rgb& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// From y up to z up.
SceneJson blenderAxes(const Direction& v) { return triple({v.x, -v.z, v.y}); }

SceneJson blenderCamera(const OrbitCamera& view) {
  const CameraFrame camera = cameraFrame(view);
  SceneJson json{{"eye", blenderAxes(camera.eye)},
                 {"right", blenderAxes(camera.right)},
                 {"up", blenderAxes(camera.up)},
                 {"back", blenderAxes(-camera.forward)}};
  if (camera.orthographic)
    json["width"] = 2 * camera.halfExtent;
  else
    json["field_of_view"] = view.fieldOfView;
  return json;
}

SceneJson blenderObject(const SceneObject& object, const std::string& mesh) {
  SceneJson json{{"name", plainText(object.name)}};
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
    json["sphere"] = {{"centre", blenderAxes(sphere->centre)}, {"radius", sphere->radius}};
  } else if (const auto* rectangle = std::get_if<Rectangle>(&object.shape)) {
    for (const auto& [u, v] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      json["rectangle"].push_back(blenderAxes(rectangle->at(u, v)));
  } else {
    json["mesh"] = mesh;
  }
  if (object.emits())
    json["radiance"] = triple(object.radiance);
  else if (const auto* diffuse = std::get_if<Diffuse>(&object.material))
    json["diffuse"] = triple(diffuse->reflectance);
  return json;
}

std::string blenderSceneText(const Scene& scene, const SceneFileNames& files) {
  SceneJson json{
      {"name", files.name},         {"material", files.material},     {"camera", blenderCamera(scene.camera)},
      {"pixels", scenePixels},      {"samples", scenePictureSamples}, {"objects", SceneJson::array()},
      {"suns", SceneJson::array()}, {"points", SceneJson::array()}};
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    json["objects"].push_back(blenderObject(scene.objects[i], files.meshes[i]));
  for (const DirectionalLight& light : scene.directionalLights)
    json["suns"].push_back({{"to_light", blenderAxes(light.toLight)}, {"irradiance", triple(light.irradiance)}});
  for (const PointLight& light : scene.pointLights)
    json["points"].push_back({{"position", blenderAxes(light.position)}, {"intensity", triple(light.intensity)}});
  if (scene.environment)
    // The centre of Blender's picture is at +x, of Gonio's at +y (-z with y up).
    json["environment"] = {{"picture", files.environment},
                           {"turn", scene.environmentRotation - halfPi},
                           {"shown", scene.showEnvironment ? 1 : 0}};
  return blenderSceneProgram(io::jsonText(json, 2));
}

SceneFormat blenderFormat(std::string_view materialSuffix) {
  return {.textSuffix = "_scene.py",
          .environmentSuffix = "_environment.exr",
          .materialSuffix = materialSuffix,
          .text = blenderSceneText,
          .environment = [](const Scene& scene) { return scene.environment->image(); }};
}

}  // namespace

const SceneFormat& blenderSceneFormat() {
  static const SceneFormat format = blenderFormat("_blender.py");
  return format;
}

const SceneFormat& principledSceneFormat() {
  static const SceneFormat format = blenderFormat("_principled.py");
  return format;
}

}  // namespace gonio::exports
