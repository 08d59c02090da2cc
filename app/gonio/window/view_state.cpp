// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/view_state.h"

#include <algorithm>
#include <cmath>

#include "core/rendering/scene_file.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

/// The finite number under a key, in a range, else `fallback`.
double number(const nlohmann::json& json, const char* key, double fallback, double min, double max) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_number()) return fallback;
  const double value = json[key].get<double>();
  return std::isfinite(value) ? std::clamp(value, min, max) : fallback;
}

Direction lightOf(const Scene& scene) {
  return scene.directionalLights.empty() ? DirectionalLight{}.toLight : scene.directionalLights.front().toLight;
}

}  // namespace

nlohmann::json viewToJson(const widgets::PreviewWidget& preview) {
  const Scene& scene = preview.content().scene();
  const Direction toLight = lightOf(scene);
  return {{"scene", scene.source},
          {"yaw", scene.camera.yaw},
          {"pitch", scene.camera.pitch},
          {"distance", scene.camera.distance},
          {"fieldOfView", scene.camera.fieldOfView},
          {"targetX", scene.camera.target.x},
          {"targetY", scene.camera.target.y},
          {"targetZ", scene.camera.target.z},
          {"lightX", toLight.x},
          {"lightY", toLight.y},
          {"lightZ", toLight.z},
          {"environment", scene.environment ? scene.environment->name() : std::string()},
          {"environmentRotation", scene.environmentRotation},
          {"showEnvironment", scene.showEnvironment},
          {"blurBackground", scene.blurBackground},
          {"exposure", preview.display().exposure},
          {"toneMap", std::string(toneMapName(preview.display().toneMap))}};
}

void restoreView(widgets::PreviewWidget& preview, const nlohmann::json& view) {
  constexpr double steepest = 1.5, farthest = 1000;
  Scene scene = preview.content().scene();
  scene.camera.yaw = number(view, "yaw", scene.camera.yaw, -100, 100);
  scene.camera.pitch = number(view, "pitch", scene.camera.pitch, -steepest, steepest);
  scene.camera.distance = number(view, "distance", scene.camera.distance, 1.05, farthest);
  scene.camera.fieldOfView = number(view, "fieldOfView", scene.camera.fieldOfView, 0, 2.5);
  OrbitCamera& camera = scene.camera;
  camera.target = {number(view, "targetX", camera.target.x, -farthest, farthest),
                   number(view, "targetY", camera.target.y, -farthest, farthest),
                   number(view, "targetZ", camera.target.z, -farthest, farthest)};
  scene.environmentRotation = number(view, "environmentRotation", scene.environmentRotation, -100, 100);
  const Direction before = lightOf(scene);
  const Direction toLight(number(view, "lightX", before.x, -1, 1), number(view, "lightY", before.y, -1, 1),
                          number(view, "lightZ", before.z, -1, 1));
  if (glm::length(toLight) > 1e-3 && !scene.directionalLights.empty())
    scene.directionalLights.front().toLight = glm::normalize(toLight);
  preview.content().setScene(scene);
  if (view.is_object() && view.contains("showEnvironment") && view["showEnvironment"].is_boolean())
    preview.content().setBackground(view["showEnvironment"].get<bool>(),
                                    view.contains("blurBackground") && view["blurBackground"] == true);
  widgets::DisplaySettings display = preview.display();
  display.exposure = number(view, "exposure", display.exposure, -20, 20);
  if (view.is_object() && view.contains("toneMap"))
    for (const ToneMap toneMap : {ToneMap::clamp, ToneMap::filmic})
      if (view["toneMap"] == std::string(toneMapName(toneMap))) display.toneMap = toneMap;
  preview.setDisplay(display);
}

QString sceneNameOf(const nlohmann::json& view) {
  const bool hasScene = view.is_object() && view.contains("scene") && view["scene"].is_string();
  const std::string scene = hasScene ? view["scene"].get<std::string>() : "";
  return QString::fromStdString(scene.empty() ? bundledSceneNames().front() : scene);
}

std::optional<QString> environmentOf(const nlohmann::json& view) {
  if (!view.is_object() || !view.contains("environment") || !view["environment"].is_string()) return std::nullopt;
  return QString::fromStdString(view["environment"].get<std::string>());
}

}  // namespace gonio::app
