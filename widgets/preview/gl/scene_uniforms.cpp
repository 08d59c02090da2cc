// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/scene_uniforms.h"

#include <algorithm>
#include <glm/vec4.hpp>

#include "widgets/preview/gl/mesh_texture.h"

namespace gonio::widgets {

namespace {

constexpr float materialSlot = 0, diffuse = 1, emitting = 2;  // of preview/scene_shapes.glsl

glm::vec4 colourOf(const rendering::SceneObject& object) {
  if (object.emits()) return glm::vec4(object.radiance, emitting);
  if (const auto* surface = std::get_if<rendering::Diffuse>(&object.material))
    return glm::vec4(surface->reflectance, diffuse);
  return {float(std::get<rendering::MaterialSlot>(object.material).number), 0, 0, materialSlot};
}

/// The shader's numbers of the objects: spheres, meshes, rectangles, area lights.
std::vector<std::size_t> drawnOrder(const rendering::Scene& scene) {
  std::vector<std::size_t> order;
  const auto rank = [&](std::size_t i) {
    const rendering::SceneObject& object = scene.objects[i];
    if (object.emits()) return 3;
    return std::holds_alternative<rendering::Sphere>(object.shape)      ? 0
           : std::holds_alternative<rendering::MeshShape>(object.shape) ? 1
                                                                        : 2;
  };
  for (std::size_t i = 0; i < scene.objects.size(); ++i) order.push_back(i);
  std::ranges::stable_sort(order, {}, rank);
  return order;
}

}  // namespace

bool SceneUniforms::canDraw(const rendering::Scene& scene) {
  std::size_t triangles = 0;
  for (const rendering::SceneObject& object : scene.objects)
    if (const auto* mesh = std::get_if<rendering::MeshShape>(&object.shape))
      triangles += (*mesh)->mesh().triangles().size();
  return !scene.objects.empty() && scene.objects.size() <= maxObjects && scene.directionalLights.size() <= maxLights &&
         scene.pointLights.size() <= maxLights && triangles <= MeshTexture::maxTriangles;
}

SceneUniforms::SceneUniforms(const rendering::Scene& scene, const rendering::EffectPlan& plan) {
  addObjects(scene, plan);
  addLights(scene, plan);
  reflections_ = std::clamp(plan.reflections, 1, maxReflections);
  const bool emitted = plan.simulates(rendering::Effect::emittedLight);
  showLamps_ = emitted && lamps_ > 0;
  showEnvironment_ = emitted && scene.environment && scene.showEnvironment;
  blurBackground_ = showEnvironment_ && scene.blurBackground;
}

void SceneUniforms::addObjects(const rendering::Scene& scene, const rendering::EffectPlan& plan) {
  const std::vector<std::size_t> order = drawnOrder(scene);
  std::vector<int> numbers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i]] = int(i);
  bool anyBlocks = false;
  for (const std::size_t index : order) {
    const rendering::SceneObject& object = scene.objects[index];
    colours_.push_back(colourOf(object));
    diffuse_ = diffuse_ || colours_.back().w == diffuse;
    lamps_ += object.emits();
    if (const auto* sphere = std::get_if<rendering::Sphere>(&object.shape)) {
      spheres_.emplace_back(sphere->centre, sphere->radius);
    } else if (const auto* mesh = std::get_if<rendering::MeshShape>(&object.shape)) {
      meshes_.push_back(*mesh);
    } else {
      const auto& rectangle = std::get<rendering::Rectangle>(object.shape);
      centres_.emplace_back(rectangle.centre);
      sides_.emplace_back(rectangle.halfU);
      sides_.emplace_back(rectangle.halfV);
    }
    int bits = 0;
    for (const auto& ofLight : plan.blockers[index])
      for (const std::size_t blocker : ofLight) bits |= 1 << numbers[blocker];
    blockers_.push_back(bits);
    anyBlocks = anyBlocks || bits != 0;
  }
  if (!anyBlocks) blockers_.clear();
}

void SceneUniforms::addLights(const rendering::Scene& scene, const rendering::EffectPlan& plan) {
  for (const rendering::SceneLight& light : plan.lights) {
    const bool distant = light.kind == rendering::SceneLight::Kind::environment;
    if (!plan.simulates(distant ? rendering::Effect::environmentLight : rendering::Effect::directLight)) continue;
    switch (light.kind) {
      case rendering::SceneLight::Kind::environment:
        lightEnvironment_ = true;
        break;
      case rendering::SceneLight::Kind::directional:
        distantDirections_.emplace_back(scene.directionalLights[light.index].toLight);
        distantIrradiances_.emplace_back(scene.directionalLights[light.index].irradiance);
        break;
      case rendering::SceneLight::Kind::point:
        pointPositions_.emplace_back(scene.pointLights[light.index].position);
        pointIntensities_.emplace_back(scene.pointLights[light.index].intensity);
        break;
      case rendering::SceneLight::Kind::rectangle:
        lightLamps_ = true;
        drawLamps_ = plan.simulates(rendering::Effect::areaLightSampling);
        break;
    }
  }
}

QStringList SceneUniforms::definitions() const {
  const auto count = [](const char* name, std::size_t number) { return QString("%1 %2").arg(name).arg(number); };
  QStringList result{count("SPHERES", spheres_.size()),
                     count("MESHES", meshes_.size()),
                     count("RECTANGLES", centres_.size()),
                     count("DISTANT_LIGHTS", distantDirections_.size()),
                     count("POINT_LIGHTS", pointPositions_.size()),
                     count("LAMPS", std::size_t(lamps_))};
  for (const auto& [wanted, name] : {std::pair{diffuse_, "DIFFUSE_OBJECTS"},
                                     {lightEnvironment_, "LIGHT_ENVIRONMENT"},
                                     {showEnvironment_, "SHOW_ENVIRONMENT"},
                                     {showLamps_, "SHOW_LAMPS"},
                                     {lightLamps_, "LIGHT_LAMPS"},
                                     {drawLamps_, "DRAW_LAMPS"},
                                     {reflections_ > 1, "INTERREFLECTION"},
                                     {!blockers_.empty(), "SHADOWS"}})
    if (wanted) result << name;
  return result;
}

void SceneUniforms::set(QOpenGLShaderProgram& program) const {
  const auto vectors = [&](const char* name, const std::vector<glm::vec3>& values) {
    if (!values.empty()) program.setUniformValueArray(name, &values.front().x, int(values.size()), 3);
  };
  const auto wide = [&](const char* name, const std::vector<glm::vec4>& values) {
    if (!values.empty()) program.setUniformValueArray(name, &values.front().x, int(values.size()), 4);
  };
  wide("spheres", spheres_);
  std::vector<float> radii;
  for (const rendering::MeshShape& mesh : meshes_) radii.push_back(float(mesh->mesh().boundingSphere().radius));
  if (!radii.empty()) program.setUniformValueArray("meshRadii", radii.data(), int(radii.size()), 1);
  wide("objectColours", colours_);
  vectors("rectangleCentres", centres_);
  vectors("rectangleSides", sides_);
  vectors("distantDirections", distantDirections_);
  vectors("distantIrradiances", distantIrradiances_);
  vectors("pointPositions", pointPositions_);
  vectors("pointIntensities", pointIntensities_);
  if (showEnvironment_) program.setUniformValue("blurBackground", blurBackground_);
  if (reflections_ > 1) program.setUniformValue("reflections", reflections_);
  if (!blockers_.empty()) program.setUniformValueArray("blockers", blockers_.data(), int(blockers_.size()));
}

rendering::EffectPlan previewPlan(const rendering::Scene& scene,
                                  const std::shared_ptr<const rendering::RenderMaterial>& material,
                                  const rendering::EffectOverrides& overrides,
                                  const rendering::RenderMaterials& otherSlotMaterials,
                                  const rendering::EffectThresholds& thresholds) {
  return rendering::planEffects(
      scene, rendering::bindMaterials(scene, rendering::materialsInSlots(scene, material, otherSlotMaterials)),
      overrides, thresholds);
}

}  // namespace gonio::widgets
