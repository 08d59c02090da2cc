// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/path_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/rendering/environment.h"

namespace gonio::rendering {

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
      const auto [radiance, density] = evalLight(light, normal, offset / distance, distance);
      return {offset / distance, distance, radiance, density};
    }
    case SceneLight::Kind::environment:
      break;
  }
  const EnvironmentMap::Sample sampled = scene_.environment->sampleAbove(rotation_.toEnvironment(normal), u.x, u.y);
  return {rotation_.fromEnvironment(sampled.direction), unbounded, sampled.radiance, sampled.pdf};
}

LightSampler::Found LightSampler::evalLight(const SceneLight& light, const Direction& normal, const Direction& toward,
                                            double distance) const {
  if (light.kind == SceneLight::Kind::environment) {
    const EnvironmentMap::Sample found =
        scene_.environment->atAbove(rotation_.toEnvironment(normal), rotation_.toEnvironment(toward));
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

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Reflections that every path takes before chance may end it, where all effects are simulated.
constexpr int certainReflections = 3;
/// A path that can add less than this multiple of the typical brightness ends by chance, see survives(). Larger values
/// trace fewer rays and add noise.
constexpr double rouletteFraction = 0.5;

/// The weight of a direction that was sampled with a density, where another strategy samples it with the other density:
/// one sample each, the exponent 2 (Veach 1997, section 9.2.4). It disturbs a good strategy less than the balance
/// heuristic does.
double powerHeuristic(double density, double other) {
  const double ratio = other / density;
  return 1 / (1 + ratio * ratio);
}

}  // namespace

std::span<const PathTracer::PathBatch::Result> PathTracer::PathBatch::trace(std::span<const Start> starts) {
  starts_ = starts;
  results_.assign(starts.size(), {});
  paths_.clear();
  for (std::size_t i = 0; i < starts.size(); ++i) enter(starts[i], i);
  for (int reflection = 1; !paths_.empty() && reflection <= tracer_.plan_.reflections; ++reflection) {
    sampleLights(reflection);
    sampleMaterials(reflection);
    evaluateQueries();
    for (const Path& path : paths_)
      if (!direct_.empty()) ++direct_[path.object].hits;
    addSampledLights();
    follow(reflection);
  }
  return results_;
}

void PathTracer::PathBatch::enter(const Start& start, std::size_t result) {
  const Ray& ray = start.ray;
  ++counters_.camera;
  std::size_t object = 0;
  double nearest = infinity;
  for (std::size_t i = 0; i < objects().size(); ++i)
    if (const double t = nearestDistance(objects()[i].shape, ray, 0, infinity); t < nearest) nearest = t, object = i;
  const bool showsSources = tracer_.plan_.simulates(Effect::emittedLight);
  Result& found = results_[result];
  if (!std::isfinite(nearest)) {
    if (tracer_.scene_.showEnvironment && tracer_.scene_.environment && showsSources)
      found = {lights_.background(ray.direction), true, Direction(0)};
    return;
  }
  found.covered = true;
  if (objects()[object].emits()) {
    const bool front = glm::dot(std::get<Rectangle>(objects()[object].shape).normal(), ray.direction) < 0;
    if (front && showsSources) found.radiance = objects()[object].radiance;
    return;
  }
  Path& path = paths_.emplace_back();
  path.result = result;
  path.seed = start.seed;
  addSurface(path, object, ray, nearest);
  found.normal = path.frame.normal;
  if (!(path.wo.z > 0)) paths_.pop_back();
}

/// Puts the path on the object that its ray meets.
void PathTracer::PathBatch::addSurface(Path& path, std::size_t object, const Ray& ray, double distance) const {
  const Shape& shape = objects()[object].shape;
  const ShapeHit hit = shapeHit(shape, ray, distance);
  const bool backFaced = glm::dot(hit.geometricNormal, ray.direction) > 0;
  // A shading normal that turns away from the eye where the surface does not would leave black rims.
  const bool turnedAway = glm::dot(hit.shadingNormal, ray.direction) >= 0;
  const Direction normal = turnedAway && !backFaced ? hit.geometricNormal : hit.shadingNormal;
  const auto* rectangle = std::get_if<Rectangle>(&shape);
  if (!tracer_.plan_.simulates(Effect::anisotropicFrames))
    path.frame = anyFrame(normal);
  else if (rectangle)
    path.frame = {glm::normalize(rectangle->halfU), glm::normalize(rectangle->halfV), normal};
  else
    path.frame = shadingFrame(normal);
  path.object = object;
  path.position = hit.position;
  path.geometricNormal = hit.geometricNormal;
  path.wo = backFaced ? Direction(0, 0, -1) : path.frame.toLocal(-ray.direction);
  if (tracer_.sendsRays_[object]) path.origin = offsetRayOrigin(shape, hit);
}

void PathTracer::PathBatch::sampleLights(int reflection) {
  const EffectPlan& plan = tracer_.plan_;
  lightQueries_.clear();
  for (BrdfQueries& queries : queries_) queries.pairs.clear();
  for (std::size_t light = 0; light < plan.lights.size(); ++light) {
    const bool isLamp = plan.lights[light].kind == SceneLight::Kind::rectangle;
    if (isLamp && !plan.simulates(Effect::areaLightSampling)) continue;
    const bool sized = hasSize(plan.lights[light]);
    if (sized && tracer_.strategy_ == Strategy::materials) continue;
    PathSamples samples(reflection, PathSamples::firstLight + std::uint32_t(light));
    for (Path& path : paths_)
      if (plan.lit[path.object][light]) sampleLight(light, path, sized ? samples.pair(path.seed) : glm::dvec2(0));
  }
}

void PathTracer::PathBatch::sampleLight(std::size_t light, Path& path, const glm::dvec2& u) {
  const SceneLight& source = tracer_.plan_.lights[light];
  const LightSample sample = lights_.sample(source, path.position, path.geometricNormal, u);
  const Direction wi = path.frame.toLocal(sample.toLight);
  if (!(wi.z > 0) || !(glm::dot(path.geometricNormal, sample.toLight) > 0)) return;
  double weight = wi.z;
  if (hasSize(source)) {
    if (!(sample.density > 0)) return;
    const RenderMaterial& material = *tracer_.materials_[path.object];
    const double other = tracer_.strategy_ == Strategy::both ? material.pdf(wi, path.wo) : 0;
    weight *= powerHeuristic(sample.density, other) / sample.density;
  }
  LightQuery& query = lightQueries_.emplace_back();
  query.path = std::size_t(&path - paths_.data());
  query.light = light;
  query.query = queriesOf(path).add(wi, path.wo);
  query.weight = sample.radiance * weight;
  query.toLight = sample.toLight;
  query.distance = sample.distance;
}

bool PathTracer::PathBatch::goesOn(const Path& path, int reflection) const {
  return reflection < tracer_.plan_.reflections && !tracer_.plan_.visible[path.object].empty();
}

void PathTracer::PathBatch::sampleMaterials(int reflection) {
  PathSamples directions(reflection, PathSamples::reflectedDirection);
  for (Path& path : paths_) {
    path.sample.pdf = 0;
    if (!tracer_.findsLights_[path.object] && !goesOn(path, reflection)) continue;
    const glm::dvec3 u = directions.triple(path.seed);
    const RenderMaterial& material = *tracer_.materials_[path.object];
    path.sample = material.sample(path.wo, {u.z, u.x, u.y});
    path.toward = path.frame.toWorld(path.sample.wi);
    if (!(glm::dot(path.geometricNormal, path.toward) > 0)) path.sample.pdf = 0;
    if (path.sample.pdf > 0) path.query = queriesOf(path).add(path.sample.wi, path.wo);
  }
}

void PathTracer::PathBatch::evaluateQueries() {
  for (std::size_t brdf = 0; brdf < queries_.size(); ++brdf) {
    BrdfQueries& queries = queries_[brdf];
    queries.values.resize(queries.pairs.size());
    if (!queries.pairs.empty()) tracer_.brdfs_[brdf]->evaluate(queries.pairs, queries.values);
  }
}

void PathTracer::PathBatch::addSampledLights() {
  for (const LightQuery& query : lightQueries_) {
    const Path& path = paths_[query.path];
    const Rgb value = queriesOf(path).values[query.query] * query.weight;
    if (value == Rgb(0) || isBlocked(query, path)) continue;
    addRadiance(path, query.query, path.throughput * value);
    observe(path, value);
  }
}

void PathTracer::PathBatch::addRadiance(const Path& path, std::size_t query, const Rgb& radiance) {
  if (recorded_ && radiance != Rgb(0))
    recorded_->add(starts_[path.result].pixel, queriesOf(path).pairs[query], radiance);
  else
    results_[path.result].radiance += radiance;
}

bool PathTracer::PathBatch::isBlocked(const LightQuery& query, const Path& path) {
  const std::vector<std::size_t>& blockers = tracer_.plan_.blockers[path.object][query.light];
  if (blockers.empty()) return false;
  ++counters_.shadow;
  const Ray ray{path.origin, query.toLight};
  // The far end lies on the lamp itself.
  return std::ranges::any_of(blockers, [&](std::size_t blocker) {
    return blocks(objects()[blocker].shape, ray, 0, query.distance * (1 - 1e-7));
  });
}

void PathTracer::PathBatch::follow(int reflection) {
  PathSamples survival(reflection, PathSamples::survival);
  std::size_t kept = 0;
  for (Path& path : paths_) {
    if (!(path.sample.pdf > 0) || !followOne(path, reflection, survival)) continue;
    if (&path != &paths_[kept]) paths_[kept] = path;
    ++kept;
  }
  paths_.resize(kept);
}

bool PathTracer::PathBatch::survives(Path& path, const Rgb& found, bool continues, PathSamples& survival) const {
  // What the path can still add: the lights that it may find, and what a visible surface reflects to it.
  const double added = maxChannel(glm::abs(path.throughput * found)) +
                       (continues ? maxChannel(glm::abs(path.throughput)) * brightness_.visible[path.object] : 0);
  const double kept = added / (rouletteFraction * brightness_.typical);
  if (kept >= 1) return true;
  if (survival.number(path.seed) >= kept) return false;
  path.throughput /= kept;
  return true;
}

bool PathTracer::PathBatch::survivesLongPath(Path& path, int reflection, PathSamples& survival) const {
  if (reflection <= certainReflections) return true;
  const double kept = std::min(0.95, maxChannel(glm::abs(path.throughput)));
  if (survival.number(path.seed) >= kept) return false;
  path.throughput /= kept;
  return true;
}

bool PathTracer::PathBatch::meet(const Ray& ray, std::span<const std::size_t> candidates, bool lamps) {
  bool met = false;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const SceneObject& object = objects()[candidates[i]];
    if (object.emits() == lamps) distances_[i] = nearestDistance(object.shape, ray, 0, infinity);
    met = met || (object.emits() == lamps && std::isfinite(distances_[i]));
  }
  return met;
}

bool PathTracer::PathBatch::followOne(Path& path, int reflection, PathSamples& survival) {
  const Rgb factor = queriesOf(path).values[path.query] * (path.sample.wi.z / path.sample.pdf);
  path.throughput *= factor;
  if (path.throughput == Rgb(0)) return false;

  const auto& candidates = tracer_.candidates_[path.object];
  const Ray ray{path.origin, path.toward};
  const bool continues = goesOn(path, reflection), finds = tracer_.findsLights_[path.object];
  distances_.assign(candidates.size(), infinity);
  meet(ray, candidates, true);
  Rgb found = finds ? foundLights(path) : Rgb(0);
  if (!candidates.empty()) {
    if (brightness_.typical > 0 && !survives(path, found, continues, survival)) return false;
    ++counters_.bounce;
    if (meet(ray, candidates, false) && finds) found = foundLights(path);
  }
  if (finds) addRadiance(path, path.query, path.throughput * found);
  observe(path, factor * found);
  if (!continues) return false;
  if (!(brightness_.typical > 0) && !survivesLongPath(path, reflection, survival)) return false;
  std::size_t next = 0;
  double nearest = infinity;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (distances_[i] < nearest) nearest = distances_[next = i];
  // Reflections of what the plan does not see add nothing; a lamp reflects nothing.
  const std::vector<std::size_t>& visible = tracer_.plan_.visible[path.object];
  if (!std::isfinite(nearest) || std::ranges::find(visible, candidates[next]) == visible.end()) return false;
  addSurface(path, candidates[next], ray, nearest);
  return path.wo.z > 0;
}

/// Radiance of the lights that the sampled direction meets, each weighted against its own samples.
Rgb PathTracer::PathBatch::foundLights(const Path& path) const {
  const EffectPlan& plan = tracer_.plan_;
  const auto& candidates = tracer_.candidates_[path.object];
  const auto distanceOf = [&](std::size_t object) {
    return distances_[std::size_t(std::ranges::lower_bound(candidates, object) - candidates.begin())];
  };
  Rgb sum(0);
  for (std::size_t i = 0; i < plan.lights.size(); ++i) {
    const SceneLight& light = plan.lights[i];
    if (!plan.lit[path.object][i] || !hasSize(light)) continue;
    const bool isLamp = light.kind == SceneLight::Kind::rectangle;
    const double distance = isLamp ? distanceOf(light.index) : infinity;
    if (isLamp && !std::isfinite(distance)) continue;
    const bool blocked = std::ranges::any_of(plan.blockers[path.object][i],
                                             [&](std::size_t blocker) { return distanceOf(blocker) < distance; });
    if (blocked) continue;
    const bool sampled = tracer_.strategy_ == Strategy::both && (!isLamp || plan.simulates(Effect::areaLightSampling));
    const auto [radiance, density] = lights_.evalLight(light, path.geometricNormal, path.toward, distance);
    // Where the density of the light's own samples is 0, this direction has the light to itself.
    sum += radiance * powerHeuristic(path.sample.pdf, sampled ? density : 0);
  }
  return sum;
}

}  // namespace gonio::rendering
