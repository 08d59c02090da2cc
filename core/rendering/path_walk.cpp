// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/path_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Reflections that every walk takes before chance may end it.
constexpr int certainReflections = 3;

/// Any frame about a normal (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
ShadingFrame anyFrame(const Direction& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// The share of a direction that was drawn with a density, where another strategy finds it with the other density: one
/// sample each, the exponent 2 (Veach 1997, section 9.2.4). It leaves a good strategy alone better than the balance
/// heuristic does.
double powerHeuristic(double density, double other) {
  const double ratio = other / density;
  return 1 / (1 + ratio * ratio);
}

}  // namespace

PathTracer::Walk::Surface PathTracer::Walk::surfaceAt(std::size_t object, const Ray& ray) const {
  const SceneObject& thing = objects()[object];
  Surface surface{object, shapeHit(thing.shape, ray, 0, infinity), {}, {}, {}};
  const bool backFaced = glm::dot(surface.hit.geometricNormal, ray.direction) > 0;
  // A shading normal that turns away from the eye where the surface does not would leave black rims.
  const bool turnedAway = glm::dot(surface.hit.shadingNormal, ray.direction) >= 0;
  const Direction normal = turnedAway && !backFaced ? surface.hit.geometricNormal : surface.hit.shadingNormal;
  const auto* rectangle = std::get_if<Rectangle>(&thing.shape);
  if (!tracer_.plan_.simulates(Effect::anisotropicFrames))
    surface.frame = anyFrame(normal);
  else if (rectangle)
    surface.frame = {glm::normalize(rectangle->halfU), glm::normalize(rectangle->halfV), normal};
  else
    surface.frame = shadingFrame(normal);
  surface.wo = backFaced ? Direction(0, 0, -1) : surface.frame.toLocal(-ray.direction);
  surface.origin = leavingPoint(thing.shape, surface.hit);
  return surface;
}

PathTracer::Walk::LightDraw PathTracer::Walk::drawLight(const SceneLight& light, const Surface& surface,
                                                        const glm::dvec2& u) const {
  const Scene& scene = tracer_.scene_;
  switch (light.kind) {
    case SceneLight::Kind::directional: {
      const DirectionalLight& source = scene.directionalLights[light.index];
      return {source.toLight, infinity, source.irradiance, 0};
    }
    case SceneLight::Kind::point: {
      const PointLight& source = scene.pointLights[light.index];
      const Direction way = source.position - surface.hit.position;
      const double squared = glm::dot(way, way), distance = std::sqrt(squared);
      if (!(distance > 0)) return {};
      return {way / distance, distance, source.intensity / squared, 0};
    }
    case SceneLight::Kind::rectangle: {
      const auto& lamp = std::get<Rectangle>(scene.objects[light.index].shape);
      const Direction way = lamp.at(2 * u.x - 1, 2 * u.y - 1) - surface.hit.position;
      const double distance = glm::length(way);
      if (!(distance > 0)) return {};
      const auto [radiance, density] = meeting(light, way / distance, distance);
      return {way / distance, distance, radiance, density};
    }
    case SceneLight::Kind::environment:
      break;
  }
  const EnvironmentMap::Sample drawn = scene.environment->sample(u.x, u.y);
  return {tracer_.rotation_.fromEnvironment(drawn.direction), infinity, drawn.radiance, drawn.pdf};
}

/// What a direction meets of a light of some size: its radiance, and the density of drawLight() there, 1/sr; both 0
/// behind a lamp.
std::pair<Rgb, double> PathTracer::Walk::meeting(const SceneLight& light, const Direction& toward,
                                                 double distance) const {
  if (light.kind == SceneLight::Kind::environment) {
    const EnvironmentMap::Sample seen = tracer_.scene_.environment->at(tracer_.rotation_.toEnvironment(toward));
    return {seen.radiance, seen.pdf};
  }
  const SceneObject& lamp = objects()[light.index];
  const auto& rectangle = std::get<Rectangle>(lamp.shape);
  const double cosine = -glm::dot(rectangle.normal(), toward);
  if (!(cosine > 0)) return {Rgb(0), 0};
  return {lamp.radiance, distance * distance / (cosine * rectangle.area())};
}

bool PathTracer::Walk::isBlocked(const std::vector<std::size_t>& blockers, const Ray& ray, double distance) {
  if (blockers.empty()) return false;
  ++counters_.shadow;
  // The far end lies on the lamp itself.
  return std::ranges::any_of(
      blockers, [&](std::size_t blocker) { return blocks(objects()[blocker].shape, ray, 0, distance * (1 - 1e-7)); });
}

Rgb PathTracer::Walk::sampledLights(const Surface& surface, int reflection) {
  const EffectPlan& plan = tracer_.plan_;
  const TracedMaterial& material = *tracer_.materials_[surface.object];
  Rgb sum(0);
  for (std::size_t i = 0; i < plan.lights.size(); ++i) {
    if (!plan.lit[surface.object][i]) continue;
    const SceneLight& light = plan.lights[i];
    const bool isLamp = light.kind == SceneLight::Kind::rectangle;
    if (isLamp && !plan.simulates(Effect::areaLightSampling)) continue;
    const bool hasSize = isLamp || light.kind == SceneLight::Kind::environment;
    if (hasSize && tracer_.strategy_ == Strategy::materials) continue;
    const LightDraw draw = drawLight(light, surface, pixel_.pair(reflection, WalkPixel::firstLight + std::uint32_t(i)));
    const Direction wi = surface.frame.toLocal(draw.toLight);
    if (!(wi.z > 0) || !(glm::dot(surface.hit.geometricNormal, draw.toLight) > 0)) continue;
    if (hasSize && !(draw.density > 0)) continue;
    double weight = wi.z;
    if (hasSize) {
      const double other = tracer_.strategy_ == Strategy::both ? material.pdf(wi, surface.wo) : 0;
      weight *= powerHeuristic(draw.density, other) / draw.density;
    }
    const Rgb value = material.brdf().evaluate(wi, surface.wo) * draw.radiance * weight;
    if (maxChannel(value) > 0 &&
        !isBlocked(plan.blockers[surface.object][i], {surface.origin, draw.toLight}, draw.distance))
      sum += value;
  }
  return sum;
}

/// Radiance of the lights that a drawn direction meets, each by its share against drawLight().
Rgb PathTracer::Walk::foundLights(const Surface& surface, const Ray& ray, double density) const {
  const EffectPlan& plan = tracer_.plan_;
  const auto& candidates = tracer_.candidates_[surface.object];
  const auto distanceOf = [&](std::size_t object) {
    return distances_[std::size_t(std::ranges::lower_bound(candidates, object) - candidates.begin())];
  };
  Rgb sum(0);
  for (std::size_t i = 0; i < plan.lights.size(); ++i) {
    if (!plan.lit[surface.object][i]) continue;
    const SceneLight& light = plan.lights[i];
    const bool isLamp = light.kind == SceneLight::Kind::rectangle;
    if (!isLamp && light.kind != SceneLight::Kind::environment) continue;
    const double distance = isLamp ? distanceOf(light.index) : infinity;
    if (isLamp && !std::isfinite(distance)) continue;
    const bool drawn = tracer_.strategy_ == Strategy::both && (!isLamp || plan.simulates(Effect::areaLightSampling));
    const bool blocked = std::ranges::any_of(plan.blockers[surface.object][i],
                                             [&](std::size_t blocker) { return distanceOf(blocker) < distance; });
    if (blocked) continue;
    const auto [radiance, other] = meeting(light, ray.direction, distance);
    // Where the lights' own density is too small for its table, this direction has the light to itself.
    sum += radiance * powerHeuristic(density, drawn ? other : 0);
  }
  return sum;
}

std::optional<PathTracer::Walk::Surface> PathTracer::Walk::reflect(const Surface& surface, int reflection) {
  const EffectPlan& plan = tracer_.plan_;
  const TracedMaterial& material = *tracer_.materials_[surface.object];
  const bool goesOn = reflection < plan.reflections && !plan.visible[surface.object].empty();
  bool finds = false;
  for (std::size_t i = 0; i < plan.lights.size(); ++i)
    finds = finds || (plan.lit[surface.object][i] && (plan.lights[i].kind == SceneLight::Kind::rectangle ||
                                                      plan.lights[i].kind == SceneLight::Kind::environment));
  finds = finds && tracer_.strategy_ != Strategy::lights;
  if (!goesOn && !finds) return std::nullopt;

  const glm::dvec2 u = pixel_.pair(reflection, WalkPixel::reflectedDirection);
  const DirectionSample drawn =
      material.sample(surface.wo, {pixel_.number(reflection, WalkPixel::reflectedLobe), u.x, u.y});
  if (!(drawn.pdf > 0)) return std::nullopt;
  const Ray ray{surface.origin, surface.frame.toWorld(drawn.wi)};
  if (!(glm::dot(surface.hit.geometricNormal, ray.direction) > 0)) return std::nullopt;
  throughput_ *= material.brdf().evaluate(drawn.wi, surface.wo) * (drawn.wi.z / drawn.pdf);
  if (!(maxChannel(throughput_) > 0)) return std::nullopt;

  const auto& candidates = tracer_.candidates_[surface.object];
  if (!candidates.empty()) ++counters_.bounce;
  distances_.resize(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    distances_[i] = nearestDistance(objects()[candidates[i]].shape, ray, 0, infinity);
  if (finds) radiance_ += throughput_ * foundLights(surface, ray, drawn.pdf);
  if (!goesOn) return std::nullopt;

  if (reflection > certainReflections) {
    const double kept = std::min(0.95, maxChannel(throughput_));
    if (pixel_.number(reflection, WalkPixel::survival) >= kept) return std::nullopt;
    throughput_ /= kept;
  }
  std::size_t next = 0;
  double nearest = infinity;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (distances_[i] < nearest) nearest = distances_[next = i];
  // Reflections of what the plan does not see add nothing; a lamp reflects nothing.
  if (!std::isfinite(nearest) ||
      std::ranges::find(plan.visible[surface.object], candidates[next]) == plan.visible[surface.object].end())
    return std::nullopt;
  return surfaceAt(candidates[next], ray);
}

std::pair<Rgb, bool> PathTracer::Walk::follow(const WalkPixel& pixel, const CameraRay& cameraRay) {
  pixel_ = pixel;
  radiance_ = Rgb(0);
  throughput_ = Rgb(1);
  const Ray ray{cameraRay.origin, cameraRay.direction};
  const bool showsSources = tracer_.plan_.simulates(Effect::emittedLight);
  ++counters_.camera;
  std::size_t object = 0;
  double nearest = infinity;
  for (std::size_t i = 0; i < objects().size(); ++i)
    if (const double t = nearestDistance(objects()[i].shape, ray, 0, infinity); t < nearest) nearest = t, object = i;
  if (!std::isfinite(nearest)) {
    const bool drawn = tracer_.scene_.showEnvironment && tracer_.scene_.environment && showsSources;
    if (!drawn) return {Rgb(0), false};
    return {tracer_.scene_.environment->radiance(tracer_.rotation_.toEnvironment(ray.direction)), true};
  }
  if (objects()[object].emits()) {
    const bool front = glm::dot(std::get<Rectangle>(objects()[object].shape).normal(), ray.direction) < 0;
    return {front && showsSources ? objects()[object].radiance : Rgb(0), true};
  }
  std::optional<Surface> surface = surfaceAt(object, ray);
  for (int reflection = 1; surface && surface->wo.z > 0 && reflection <= tracer_.plan_.reflections; ++reflection) {
    radiance_ += throughput_ * sampledLights(*surface, reflection);
    surface = reflect(*surface, reflection);
  }
  return {radiance_, true};
}

}  // namespace gonio
