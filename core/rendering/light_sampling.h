// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/scene_light.h"

namespace gonio {

/// A direction from a point toward a light. Without cosine.
struct LightSample {
  Direction toLight{0};  ///< world, unit
  double distance = 0;   ///< infinite for distant light; 0 where nothing can be sampled
  Rgb radiance{0};       ///< of a light without size: irradiance perpendicular to the direction
  double density = 0;    ///< 1/sr; 0 for a light without size
};

/// Whether a light fills a solid angle, so that directions sampled from a material can find it.
bool hasSize(const SceneLight& light);

/// Samples the lights of a scene. A view: the scene must live as long.
class LightSampler {
 public:
  explicit LightSampler(const Scene& scene);

  /// Nothing (radiance 0) where the sample is below the horizon of the surface, by its geometric normal.
  /// @param u two numbers in [0, 1); unused by lights without size.
  LightSample sample(const SceneLight& light, const Direction& position, const Direction& normal,
                     const glm::dvec2& u) const;
  /// Of a light with size along a direction (world) that meets it at a distance: radiance and density of sample(),
  /// both 0 behind a lamp.
  struct Found {
    Rgb radiance{0};
    double density = 0;
  };
  Found evalLight(const SceneLight& light, const Direction& toward, double distance) const;
  /// What is seen of the environment along a direction of the world; the scene must show it.
  Rgb background(const Direction& toward) const;

 private:
  const Scene& scene_;
  EnvironmentRotation rotation_;
  std::shared_ptr<const EnvironmentMap> background_;  ///< null: not shown
};

}  // namespace gonio
