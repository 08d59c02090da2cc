// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>
#include <QStringList>

#include "core/rendering/effect_plan.h"

namespace gonio::widgets {

/// A scene for preview/scene.frag: spheres, meshes, rectangles, and area lights last.
class SceneUniforms {
 public:
  /// Maximum number of reflections in the shader, limited by compile and frame time.
  static constexpr int maxReflections = 8;
  static constexpr std::size_t maxObjects = 24, maxLights = 8;

  /// Whether the shader can draw the scene; larger ones are traced on the CPU.
  static bool canDraw(const rendering::Scene& scene);

  SceneUniforms() = default;
  SceneUniforms(const rendering::Scene& scene, const rendering::EffectPlan& plan);

  /// The definitions of the shader variant.
  QStringList definitions() const;
  void set(QOpenGLShaderProgram& program) const;
  /// Whether the shader reads the environment.
  bool usesEnvironment() const { return lightEnvironment_ || showEnvironment_; }
  /// Whether the shader samples reflected directions.
  bool samplesDirections() const { return lightEnvironment_ || lightLamps_ || reflections_ > 1; }
  int reflections() const { return reflections_; }
  const std::vector<rendering::MeshShape>& meshes() const { return meshes_; }
  bool operator==(const SceneUniforms&) const = default;

 private:
  void addObjects(const rendering::Scene& scene, const rendering::EffectPlan& plan);
  void addLights(const rendering::Scene& scene, const rendering::EffectPlan& plan);

  std::vector<glm::vec4> spheres_, colours_;
  std::vector<rendering::MeshShape> meshes_;
  std::vector<glm::vec3> centres_, sides_;
  std::vector<int> blockers_;  ///< bit masks of objects; empty: no shadows are simulated
  std::vector<glm::vec3> distantDirections_, distantIrradiances_, pointPositions_, pointIntensities_;
  int lamps_ = 0, reflections_ = 1;
  bool diffuse_ = false, showLamps_ = false, lightLamps_ = false, drawLamps_ = false, lightEnvironment_ = false,
       showEnvironment_ = false, blurBackground_ = false;
};

/// Plans the effects of a scene with `material` in its first slot and `otherSlotMaterials` in the others
/// (materialsInSlots()).
rendering::EffectPlan previewPlan(const rendering::Scene& scene,
                                  const std::shared_ptr<const rendering::RenderMaterial>& material,
                                  const rendering::EffectOverrides& overrides = {},
                                  const rendering::RenderMaterials& otherSlotMaterials = {},
                                  const rendering::EffectThresholds& thresholds = {});

}  // namespace gonio::widgets
