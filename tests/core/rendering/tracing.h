// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <functional>

#include "core/rendering/path_batch.h"
#include "core/rendering/path_tracer.h"
#include "tests/support/random_scenes.h"

/// Small pictures by the path tracer, and whether two estimates of a picture agree within their own noise.
namespace gonio::test {

using Material = std::shared_ptr<const rendering::RenderMaterial>;

inline Material traced(std::shared_ptr<const Brdf> brdf) {
  return std::make_shared<const rendering::RenderMaterial>(std::move(brdf));
}

struct TraceOptions {
  int size = 24, samples = 16;
  std::uint64_t seed = 1;
  rendering::EffectOverrides overrides{};
  rendering::PathTracer::Strategy strategy = rendering::PathTracer::Strategy::both;
};

inline rendering::PathTracer tracerOf(const rendering::Scene& scene, const Material& material,
                                      const TraceOptions& options = {}) {
  const std::vector<Material> slotMaterials(std::size_t(std::max(1, rendering::materialSlotCount(scene))), material);
  const auto bound = rendering::bindMaterials(scene, slotMaterials);
  return rendering::PathTracer(scene, bound, rendering::planEffects(scene, bound, options.overrides), options.seed,
                               options.strategy);
}

inline rendering::Film trace(const rendering::Scene& scene, const Material& material,
                             const TraceOptions& options = {}) {
  rendering::Film film(options.size, options.size);
  tracerOf(scene, material, options).accumulate(film, options.samples);
  return film;
}

/// Through a lens so long that the picture is one point of the scene.
inline Rgb traceOnePoint(rendering::Scene scene, const Material& material, TraceOptions options = {}) {
  scene.camera.fieldOfView = 1e-6;
  Rgb mean(0);
  for (const Rgb& sum : trace(scene, material, options).radiance) mean += sum / double(options.samples);
  return mean / double(options.size * options.size);
}

/// What a camera at `eye` sees at `target`.
inline rendering::OrbitCamera lookFrom(const Direction& eye, const Direction& target) {
  rendering::OrbitCamera camera;
  const Direction way = eye - target;
  camera.distance = glm::length(way);
  camera.yaw = std::atan2(way.x, way.z);
  camera.pitch = std::asin(way.y / camera.distance);
  camera.target = target;
  return camera;
}

/// Radiance of the unit sphere toward the camera along one ray: all of the environment's directions, no random number.
inline Rgb quadrature(const Brdf& brdf, const rendering::Scene& scene, const Ray& ray, int width) {
  const auto hit = rendering::nearestHit(rendering::Sphere{}, ray);
  if (!hit) return Rgb(0);
  const rendering::ShadingFrame frame = rendering::shadingFrame(hit->shadingNormal);
  const Direction wo = frame.toLocal(-ray.direction);
  const rendering::EnvironmentRotation rotation(scene.environmentRotation);
  const int height = width / 2;
  Rgb sum(0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Direction w = rendering::EnvironmentMap::directionAt((x + 0.5) / width, (y + 0.5) / height);
      const Direction wi = frame.toLocal(rotation.fromEnvironment(w));
      if (wi.z <= 0) continue;
      const double solidAngle = 2 * pi / width * pi / height * std::sin(pi * (y + 0.5) / height);
      sum += brdf.evaluate(wi, wo) * scene.environment->radiance(w) * (wi.z * solidAngle);
    }
  return sum;
}

/// Means over 4 x 4 tiles of a picture, of several independent estimates, with the squared standard error.
struct Tiles {
  std::vector<Rgb> mean = std::vector<Rgb>(16, Rgb(0)), error2 = mean;
};
inline Tiles tilesOf(int estimates, const std::function<Image(std::uint64_t seed)>& render, std::uint64_t firstSeed) {
  Tiles sum;
  for (int n = 0; n < estimates; ++n) {
    const Image image = render(firstSeed + std::uint64_t(n));
    std::vector<Rgb> tiles(16, Rgb(0));
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        tiles[std::size_t(4 * (4 * y / image.height) + 4 * x / image.width)] +=
            Rgb(image.at(x, y)) * (16.0 / double(image.pixels.size()));
    for (std::size_t i = 0; i < 16; ++i) sum.mean[i] += tiles[i], sum.error2[i] += tiles[i] * tiles[i];
  }
  for (std::size_t i = 0; i < 16; ++i) {
    sum.mean[i] /= estimates;
    sum.error2[i] =
        glm::max(Rgb(0), sum.error2[i] / double(estimates) - sum.mean[i] * sum.mean[i]) / double(estimates - 1);
  }
  return sum;
}

/// Empty where all tiles agree within six standard errors and `slack`; else the tile that is worst.
inline QString disagreement(const Tiles& a, const Tiles& b, double slack = 0) {
  double worst = 1;
  QString text;
  for (std::size_t i = 0; i < 16; ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = std::abs(a.mean[i][channel] - b.mean[i][channel]);
      const double bound = 6 * std::sqrt(a.error2[i][channel] + b.error2[i][channel]) + slack + 1e-7;
      if (!(difference / bound > worst) && std::isfinite(difference)) continue;
      worst = difference / bound;
      text = QString("tile %1: %2 and %3, bound %4").arg(i).arg(a.mean[i][channel]).arg(b.mean[i][channel]).arg(bound);
    }
  return text;
}

/// Tiles of six pictures of a scene, of seeds from `firstSeed` on.
inline Tiles tracedTiles(const rendering::Scene& scene, const Material& material, TraceOptions options,
                         std::uint64_t firstSeed) {
  return tilesOf(
      6,
      [&](std::uint64_t seed) {
        options.seed = seed;
        return trace(scene, material, options).image();
      },
      firstSeed);
}

}  // namespace gonio::test
