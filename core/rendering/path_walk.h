// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/math/sampling.h"
#include "core/rendering/path_tracer.h"

namespace gonio {

/// The point sets of one sample of a pixel: independent for each reflection and purpose.
struct WalkPixel {
  enum Purpose : std::uint32_t { filmPosition, reflectedDirection, reflectedLobe, survival, firstLight };
  static constexpr std::uint32_t purposesOfReflection = 1024;

  std::uint32_t seed, sample;

  glm::dvec2 pair(int reflection, std::uint32_t purpose) const {
    return scrambledSobol(sample, hashCombine(seed, std::uint32_t(reflection) * purposesOfReflection + purpose));
  }
  double number(int reflection, std::uint32_t purpose) const {
    return scrambledVanDerCorput(sample, hashCombine(seed, std::uint32_t(reflection) * purposesOfReflection + purpose));
  }
};

/// Paths from the eye, one after the other.
class PathTracer::Walk {
 public:
  Walk(const PathTracer& tracer, RayCounters& counters) : tracer_(tracer), counters_(counters) {}

  /// Radiance along the camera's ray; whether it met anything that is drawn.
  std::pair<Rgb, bool> follow(const WalkPixel& pixel, const CameraRay& ray);

 private:
  struct Surface {
    std::size_t object;
    ShapeHit hit;
    ShadingFrame frame;
    Direction wo;      ///< local
    Direction origin;  ///< of rays that leave
  };
  /// A place on a lamp or in the environment as a surface sees it.
  struct LightDraw {
    Direction toLight;    ///< world
    double distance = 0;  ///< infinite for distant light
    Rgb radiance{0};      ///< of a light without size: irradiance perpendicular to it
    double density = 0;   ///< 1/sr; 0 for a light without size
  };

  const std::vector<SceneObject>& objects() const { return tracer_.scene_.objects; }
  Surface surfaceAt(std::size_t object, const Ray& ray) const;
  LightDraw drawLight(const SceneLight& light, const Surface& surface, const glm::dvec2& u) const;
  std::pair<Rgb, double> meeting(const SceneLight& light, const Direction& toward, double distance) const;
  bool isBlocked(const std::vector<std::size_t>& blockers, const Ray& ray, double distance);
  Rgb sampledLights(const Surface& surface, int reflection);
  Rgb foundLights(const Surface& surface, const Ray& ray, double density) const;
  /// Adds what the drawn direction finds; the next surface, where there is one that the plan follows.
  std::optional<Surface> reflect(const Surface& surface, int reflection);

  const PathTracer& tracer_;
  RayCounters& counters_;
  WalkPixel pixel_{};
  Rgb radiance_{0}, throughput_{1};
  /// Of the candidates of the surface's object, along the direction that was drawn last.
  std::vector<double> distances_;
};

}  // namespace gonio
