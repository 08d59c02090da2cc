// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "core/rendering/render_material.h"
#include "core/rendering/scene_light.h"

namespace gonio::rendering {

/// Effects of light transport, in the order of display.
enum class Effect {
  emittedLight,       ///< light that reaches the camera directly from its source
  directLight,        ///< light of distant, point and area lights after one reflection
  environmentLight,   ///< light of the environment after one reflection
  castShadows,        ///< shadows of one object on another
  selfShadowing,      ///< shadows of an object on itself
  interreflection,    ///< light after two or more reflections
  anisotropicFrames,  ///< tangent directions on surfaces, for anisotropic materials
  areaLightSampling,  ///< sampling of points on area lights
};
inline constexpr std::size_t effectCount = 8;
/// The id in files and on the command line, e.g. "emitted-light".
const char* effectId(Effect effect);
/// @throws Error that lists the ids.
Effect effectOfId(const std::string& id);

struct EffectDecision {
  bool calledFor = false;  ///< whether the analysis found that the effect can change a pixel
  bool simulated = false;  ///< result after the user's override
  std::string reason;      ///< of the analysis, for display

  bool operator==(const EffectDecision&) const = default;
};

/// The user's overrides: on, off, or empty (the analysis decides).
using EffectOverrides = std::array<std::optional<bool>, effectCount>;

/// The effects that can change a pixel of a scene.
struct EffectPlan {
  std::array<EffectDecision, effectCount> decisions;
  std::vector<SceneLight> lights;  ///< lightsOf() of the scene
  /// [object][light]: whether the light is simulated and may reach the object.
  std::vector<std::vector<bool>> lit;
  /// [object][light]: the objects that may occlude the light, including the object itself if it is not convex.
  std::vector<std::vector<std::vector<std::size_t>>> blockers;
  /// [object]: the reflecting objects that may be visible from its points.
  std::vector<std::vector<std::size_t>> visible;
  /// Number of reflections on the longest simulated light path: 0 none, 1 direct light only.
  int reflections = 0;
  /// Upper bound of the contribution of all longer paths to a pixel, as a fraction of the brightest first reflection;
  /// infinite if there is no bound.
  double remainder = 0;
  /// Whether paths that can add little may end by chance (PathTracer); false if interreflection is forced on, so that
  /// the picture can verify others.
  bool endsPathsEarly = true;

  const EffectDecision& operator[](Effect effect) const { return decisions[std::size_t(effect)]; }
  bool simulates(Effect effect) const { return decisions[std::size_t(effect)].simulated; }
  bool operator==(const EffectPlan&) const = default;
};

struct EffectThresholds {
  /// Paths end when all longer ones can add less than this fraction of the brightest first reflection. Default: half a
  /// step of an 8-bit display.
  double remainder = 1.0 / 512;
  int maxReflections = 64;
};

/// Analyses shapes, lights and materials for effects that can change a pixel. The analysis is conservative: apart from
/// the remainder, it only omits effects without influence. Computes some support points of each shape for each pair of
/// objects and each light, microseconds for the bundled scenes. @param materials of bindMaterials().
EffectPlan planEffects(const Scene& scene, std::span<const std::shared_ptr<const RenderMaterial>> materials,
                       const EffectOverrides& overrides = {}, const EffectThresholds& thresholds = {});

/// Updates the plan of a scene for another camera. Only the decision on Effect::emittedLight depends on the camera.
/// Tests only the shapes of area lights.
void updateForCamera(EffectPlan& plan, const Scene& scene, const EffectOverrides& overrides = {});

/// Attributes of a picture file: samples, scene, effects, reflections, material, seed.
std::map<std::string, std::string> pictureAttributes(const Scene& scene, const EffectPlan& plan,
                                                     const std::string& material, int samples, std::uint64_t seed);

/// Overrides that force all effects on, regardless of the analysis.
EffectOverrides everyEffect();

}  // namespace gonio::rendering
