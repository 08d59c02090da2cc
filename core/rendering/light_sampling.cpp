// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/light_sampling.h"

#include <cmath>
#include <limits>

#include "core/rendering/blurred_environment.h"

namespace gonio {

namespace {
constexpr double unbounded = std::numeric_limits<double>::infinity();
}  // namespace

bool hasSize(const SceneLight& light) {
  return light.kind == SceneLight::Kind::rectangle || light.kind == SceneLight::Kind::environment;
}

LightSampler::LightSampler(const Scene& scene) : scene_(scene), rotation_(scene.environmentRotation) {
  if (scene.environment && scene.showEnvironment)
    background_ = scene.blurBackground ? blurredEnvironment(scene.environment) : scene.environment;
}

LightSample LightSampler::sample(const SceneLight& light, const Direction& position, const Direction& normal,
                                 const glm::dvec2& u) const {
  switch (light.kind) {
    case SceneLight::Kind::directional: {
      const DirectionalLight& source = scene_.directionalLights[light.index];
      return {source.toLight, unbounded, source.irradiance, 0};
    }
    case SceneLight::Kind::point: {
      const PointLight& source = scene_.pointLights[light.index];
      const Direction offset = source.position - position;
      const double squared = glm::dot(offset, offset), distance = std::sqrt(squared);
      if (!(distance > 0)) return {};
      return {offset / distance, distance, source.intensity / squared, 0};
    }
    case SceneLight::Kind::rectangle: {
      const auto& lamp = std::get<Rectangle>(scene_.objects[light.index].shape);
      const Direction offset = lamp.at(2 * u.x - 1, 2 * u.y - 1) - position;
      const double distance = glm::length(offset);
      if (!(distance > 0)) return {};
      const auto [radiance, density] = evalLight(light, offset / distance, distance);
      return {offset / distance, distance, radiance, density};
    }
    case SceneLight::Kind::environment:
      break;
  }
  const EnvironmentMap::Sample sampled = scene_.environment->sampleAbove(rotation_.toEnvironment(normal), u.x, u.y);
  return {rotation_.fromEnvironment(sampled.direction), unbounded, sampled.radiance, sampled.pdf};
}

LightSampler::Found LightSampler::evalLight(const SceneLight& light, const Direction& toward, double distance) const {
  if (light.kind == SceneLight::Kind::environment) {
    const EnvironmentMap::Sample found = scene_.environment->at(rotation_.toEnvironment(toward));
    return {found.radiance, found.pdf};
  }
  const SceneObject& lamp = scene_.objects[light.index];
  const auto& rectangle = std::get<Rectangle>(lamp.shape);
  const double cosine = -glm::dot(rectangle.normal(), toward);
  if (!(cosine > 0)) return {};
  return {lamp.radiance, distance * distance / (cosine * rectangle.area())};
}

Rgb LightSampler::background(const Direction& toward) const {
  return background_->radiance(rotation_.toEnvironment(toward));
}

}  // namespace gonio
