// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/sphere_renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/math/parallel.h"
#include "core/math/sampling.h"

namespace gonio {

namespace {

/// One sampling problem each: their points are scrambled independently.
enum Dimension : std::uint32_t {
  filmPosition,
  environmentDirection,
  specularDirection,
  diffuseDirection,
  dimensionCount
};

/// The pairs of one pixel with what multiplies their BRDF values: evaluated in one call.
struct PixelWork {
  std::vector<DirectionPair> pairs;
  std::vector<Rgb> weights, values;

  void add(const Direction& wi, const Direction& wo, const Rgb& weight) {
    pairs.push_back({wi, wo});
    weights.push_back(weight);
  }
};

class Renderer {
 public:
  Renderer(const Brdf& brdf, const SphereScene& scene, const SphereRenderOptions& options)
      : brdf_(brdf),
        scene_(scene),
        options_(options),
        frame_(cameraFrame(scene.camera)),
        rotation_(scene.environmentRotation) {
    if (scene.environment) setLobe(options.lobe ? *options.lobe : estimateSamplingLobe(brdf));
  }

  void renderPixel(int x, int y, PixelWork& work, Image& image) const;

 private:
  void setLobe(const SamplingLobe& lobe);
  DirectionSample sampleLobe(const Direction& wo, std::uint32_t sample, const std::uint32_t* seeds) const;
  void shade(const ShadingFrame& surface, const Direction& wo, std::uint32_t sample, const std::uint32_t* seeds,
             PixelWork& work) const;

  const Brdf& brdf_;
  const SphereScene& scene_;
  const SphereRenderOptions& options_;
  CameraFrame frame_;
  EnvironmentRotation rotation_;
  SamplingLobe lobe_;
  std::uint32_t specularCount_ = 0;  ///< of a pixel's samples, the first ones go to the lobe's specular part
};

/// Each part of the lobe gets a fixed number of the samples and a point set of its own: the choice adds no noise.
void Renderer::setLobe(const SamplingLobe& lobe) {
  const int samples = options_.samples;
  const int wanted = static_cast<int>(std::lround(lobe.specularShare * samples));
  // A part that exists gets a sample where there are two: no direction is left to the other strategy alone.
  const int count = lobe.specularShare > 0 && samples > 1 ? std::clamp(wanted, 1, samples - 1) : wanted;
  specularCount_ = std::uint32_t(count);
  lobe_ = lobe;
  lobe_.specularShare = double(count) / samples;
}

DirectionSample Renderer::sampleLobe(const Direction& wo, std::uint32_t sample, const std::uint32_t* seeds) const {
  if (sample < specularCount_) {
    const glm::dvec2 u = scrambledSobol(sample, seeds[specularDirection]);
    return lobe_.sample(wo, {0, u.x, u.y});
  }
  const glm::dvec2 u = scrambledSobol(sample - specularCount_, seeds[diffuseDirection]);
  return lobe_.sample(wo, {lobe_.specularShare, u.x, u.y});
}

void Renderer::renderPixel(int x, int y, PixelWork& work, Image& image) const {
  std::uint32_t seeds[dimensionCount];
  const auto pixel = std::uint32_t(image.index(x, y));
  const std::uint32_t pixelSeed =
      hashCombine(hashCombine(std::uint32_t(options_.seed), std::uint32_t(options_.seed >> 32)), pixel);
  for (std::uint32_t d = 0; d < dimensionCount; ++d) seeds[d] = hashCombine(pixelSeed, d);

  work.pairs.clear();
  work.weights.clear();
  Rgb sum(0);
  int covered = 0;
  const double aspect = double(image.width) / image.height;
  for (std::uint32_t sample = 0; sample < std::uint32_t(options_.samples); ++sample) {
    const glm::dvec2 jitter = scrambledSobol(sample, seeds[filmPosition]);
    const CameraRay ray =
        cameraRay(frame_, 2 * (x + jitter.x) / image.width - 1, 1 - 2 * (y + jitter.y) / image.height, aspect);
    if (const auto normal = sphereHit(ray)) {
      const ShadingFrame surface = shadingFrame(*normal);
      shade(surface, surface.toLocal(-ray.direction), sample, seeds, work);
      ++covered;
    } else if (scene_.showEnvironment && scene_.environment) {
      sum += scene_.environment->radiance(rotation_.toEnvironment(ray.direction));
      ++covered;
    }
  }
  work.values.resize(work.pairs.size());
  brdf_.evaluate(work.pairs, work.values);
  for (std::size_t i = 0; i < work.values.size(); ++i) sum += work.weights[i] * work.values[i];
  image.at(x, y) = glm::vec3(sum / double(options_.samples));
  image.alpha[pixel] = float(covered) / float(options_.samples);
}

void Renderer::shade(const ShadingFrame& surface, const Direction& wo, std::uint32_t sample, const std::uint32_t* seeds,
                     PixelWork& work) const {
  if (!scene_.environment) {
    const Direction wi = surface.toLocal(scene_.light.toLight);
    if (wi.z > 0) work.add(wi, wo, scene_.light.irradiance * wi.z);
    return;
  }
  // With the balance heuristic and one sample of each kind, both kinds weigh radiance cos / (sum of both densities).
  const glm::dvec2 e = scrambledSobol(sample, seeds[environmentDirection]);
  const EnvironmentMap::Sample fromLight = scene_.environment->sample(e.x, e.y);
  const Direction wiLight = surface.toLocal(rotation_.fromEnvironment(fromLight.direction));
  if (wiLight.z > 0) work.add(wiLight, wo, fromLight.radiance * (wiLight.z / (fromLight.pdf + lobe_.pdf(wiLight, wo))));

  const DirectionSample fromLobe = sampleLobe(wo, sample, seeds);
  if (!(fromLobe.pdf > 0)) return;
  const EnvironmentMap::Sample seen = scene_.environment->at(rotation_.toEnvironment(surface.toWorld(fromLobe.wi)));
  work.add(fromLobe.wi, wo, seen.radiance * (fromLobe.wi.z / (seen.pdf + fromLobe.pdf)));
}

}  // namespace

Image renderSphere(const Brdf& brdf, const SphereScene& scene, const SphereRenderOptions& options,
                   const TaskControl& control) {
  assert(options.width > 0 && options.height > 0 && options.samples > 0);
  Image image(options.width, options.height);
  image.alpha.resize(image.pixels.size());
  const Renderer renderer(brdf, scene, options);
  parallelForBlocks(
      std::size_t(options.height), 1,
      [&](std::size_t begin, std::size_t end) {
        PixelWork work;
        for (int y = int(begin); y < int(end); ++y)
          for (int x = 0; x < options.width; ++x) renderer.renderPixel(x, y, work, image);
      },
      control);
  return image;
}

SphereScene comparisonScene() {
  SphereScene scene;
  scene.environment = studioEnvironment();
  return scene;
}

}  // namespace gonio
