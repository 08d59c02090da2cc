// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/scene_light.h"

namespace gonio {

/// A sampled direction from a point toward a light. Values do not include the cosine.
struct LightSample {
  Direction toLight{0};  ///< world, unit
  double distance = 0;   ///< infinite for distant light; 0 if the sample failed
  Rgb radiance{0};       ///< for a light without size: irradiance perpendicular to the direction
  double density = 0;    ///< 1/sr; 0 for a light without size
};

/// Whether a light subtends a solid angle, so that directions sampled from a material can hit it.
bool hasSize(const SceneLight& light);

/// Samples the lights of a scene, which must outlive this object.
class LightSampler {
 public:
  explicit LightSampler(const Scene& scene);

  /// Samples a light. The radiance is 0 if the sample is below the horizon of the surface, by its geometric normal.
  /// @param u two numbers in [0, 1); not used for lights without size.
  LightSample sample(const SceneLight& light, const Direction& position, const Direction& normal,
                     const glm::dvec2& u) const;
  /// Radiance of a light in a direction that hits it, and density of that direction.
  struct Found {
    Rgb radiance{0};
    double density = 0;  ///< of sample(), 1/sr
  };
  /// Radiance of a light with size, and density of sample(), for a direction (world) that hits it at a distance; both
  /// are 0 on the back of an area light.
  Found evalLight(const SceneLight& light, const Direction& toward, double distance) const;
  /// Radiance of the visible environment in a world direction. Precondition: the scene shows it.
  Rgb background(const Direction& toward) const;

 private:
  const Scene& scene_;
  EnvironmentRotation rotation_;
  std::shared_ptr<const EnvironmentMap> background_;  ///< null if the scene does not show it
};

}  // namespace gonio
