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

namespace gonio {

/// What light can do in a scene; in this order plans are listed.
enum class Effect {
  emittedLight,       ///< light that reaches the eye from its source (PL1)
  directLight,        ///< light of lamps after one reflection (PL2)
  environmentLight,   ///< light of the environment after one reflection
  castShadows,        ///< one object in the light of another
  selfShadowing,      ///< an object in its own light
  interreflection,    ///< light after two reflections and more
  anisotropicFrames,  ///< the directions along a surface count
  areaLightSampling,  ///< rays are sent to places on lamps that have a size
};
inline constexpr std::size_t effectCount = 8;
/// "emitted-light", as files and the command line name it.
const char* effectId(Effect effect);
/// @throws Error that lists the ids.
Effect effectOfId(const std::string& id);

struct EffectDecision {
  bool calledFor = false;  ///< by the analysis
  bool simulated = false;  ///< so, or as the user forces it
  std::string reason;      ///< of the analysis, for people

  bool operator==(const EffectDecision&) const = default;
};

/// What the user forces: on, off, or nothing (the analysis decides).
using EffectOverrides = std::array<std::optional<bool>, effectCount>;

/// Which effects can change a pixel of a scene. A plain value.
struct EffectPlan {
  std::array<EffectDecision, effectCount> decisions;
  std::vector<SceneLight> lights;  ///< lightsOf() the scene
  /// [object][light]: whether the light is simulated and the object may face it.
  std::vector<std::vector<bool>> lit;
  /// [object][light]: the objects that may stand between, the object itself among them where it is not convex.
  std::vector<std::vector<std::vector<std::size_t>>> blockers;
  /// [object]: the reflecting objects that its points may see.
  std::vector<std::vector<std::size_t>> visible;
  /// On the longest light path that is followed: 0 none, 1 direct light alone.
  int reflections = 0;
  /// What all longer paths can add to a pixel, as a fraction of the brightest first reflection; infinite where nothing
  /// bounds it.
  double remainder = 0;

  const EffectDecision& operator[](Effect effect) const { return decisions[std::size_t(effect)]; }
  bool simulates(Effect effect) const { return decisions[std::size_t(effect)].simulated; }
  bool operator==(const EffectPlan&) const = default;
};

struct EffectThresholds {
  /// Paths are followed until all longer ones can add less than this fraction of the brightest first reflection: half a
  /// step of an 8-bit display by default.
  double remainder = 1.0 / 512;
  int maxReflections = 64;
};

/// Decides by the shapes, the lights and the materials what can change a pixel. The analysis never leaves out what
/// matters but for the remainder; where it cannot decide, the effect is simulated. Some support points of each shape
/// for each pair of objects and light: microseconds for the bundled scenes.
/// @param materials of bindMaterials().
EffectPlan planEffects(const Scene& scene, std::span<const std::shared_ptr<const RenderMaterial>> materials,
                       const EffectOverrides& overrides = {}, const EffectThresholds& thresholds = {});

/// Makes the plan of a scene that of the scene seen by another camera: which sources face it can change, nothing else.
/// No shape is looked at but the lamps.
void updateForCamera(EffectPlan& plan, const Scene& scene, const EffectOverrides& overrides = {});

/// What a picture file says of how it was made: samples, scene, effects, reflections, material, seed.
std::map<std::string, std::string> pictureAttributes(const Scene& scene, const EffectPlan& plan,
                                                     const std::string& material, int samples, std::uint64_t seed);

/// Every effect forced on: no analysis is trusted.
EffectOverrides everyEffect();

}  // namespace gonio
