// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/path_tracer.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <mutex>

#include "core/math/parallel.h"
#include "core/rendering/path_batch.h"

namespace gonio::rendering {

PathTracer::PathTracer(Scene scene, std::vector<std::shared_ptr<const RenderMaterial>> materials, EffectPlan plan,
                       std::uint64_t seed, Strategy strategy)
    : scene_(std::move(scene)),
      materials_(std::move(materials)),
      plan_(std::move(plan)),
      seed_(seed),
      strategy_(strategy),
      camera_(cameraFrame(scene_.camera)) {
  for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
    const Brdf* brdf = materials_[object] ? &materials_[object]->brdf() : nullptr;
    const auto known = std::ranges::find(brdfs_, brdf);
    brdfOf_.push_back(std::size_t(known - brdfs_.begin()));
    if (known == brdfs_.end()) brdfs_.push_back(brdf);
    candidates_.push_back(candidatesOf(object));
    bool finds = false, sends = !candidates_.back().empty();
    for (std::size_t light = 0; light < plan_.lights.size(); ++light) {
      finds = finds || (plan_.lit[object][light] && hasSize(plan_.lights[light]));
      sends = sends || !plan_.blockers[object][light].empty();
    }
    sendsRays_.push_back(sends);
    findsLights_.push_back(finds && strategy_ != Strategy::lights);
  }
}

std::vector<std::size_t> PathTracer::candidatesOf(std::size_t object) const {
  std::vector<std::size_t> candidates;
  if (plan_.reflections > 1) candidates = plan_.visible[object];
  for (std::size_t light = 0; light < plan_.lights.size(); ++light) {
    const SceneLight& source = plan_.lights[light];
    if (!plan_.lit[object][light] || !hasSize(source)) continue;
    if (source.kind == SceneLight::Kind::rectangle) candidates.push_back(source.index);
    candidates.insert(candidates.end(), plan_.blockers[object][light].begin(), plan_.blockers[object][light].end());
  }
  // Whatever stands before a visible surface hides it.
  for (std::size_t other = 0; other < scene_.objects.size() && !candidates.empty(); ++other)
    if (plan_.reflections > 1 && !plan_.visible[object].empty() &&
        (other != object || !isConvex(scene_.objects[object].shape)))
      candidates.push_back(other);
  std::ranges::sort(candidates);
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

const PathTracer::Brightness& PathTracer::brightness() const {
  std::call_once(pilot_->once, [this] {
    const bool tracesRays = std::ranges::any_of(candidates_, [](const auto& objects) { return !objects.empty(); });
    if (plan_.endsPathsEarly && tracesRays) pilot_->brightness = pilotBrightness();
  });
  return pilot_->brightness;
}

PathTracer::Brightness PathTracer::pilotBrightness() const {
  constexpr int side = 32, leastHits = 16;
  RayCounters counters;
  const Brightness unweighed;
  std::vector<PathBatch::DirectLight> direct(scene_.objects.size());
  PathBatch batch(*this, counters, nullptr, unweighed, direct);
  const glm::dvec2 extent = viewExtent(camera_, 1);
  std::vector<PathBatch::Start> starts;
  double sum = 0, total = 0;
  int count = 0;
  for (int pixel = 0; pixel < side * side; ++pixel) {
    PathBatch::Start& start = starts.emplace_back();
    start.pixel = std::size_t(pixel);
    start.seed = {hashCombine(0x9b2d4e1fu, std::uint32_t(pixel)), 0};
    const glm::dvec2 place = (glm::dvec2(pixel % side, pixel / side) + 0.5) / double(side) * 2.0 - 1.0;
    start.ray = cameraRay(camera_, extent * place);
    if (starts.size() < PathBatch::capacity) continue;
    for (const PathBatch::Result& result : batch.trace(starts)) {
      if (result.normal == Direction(0)) continue;
      sum += std::sqrt(std::max(0.0, maxChannel(result.radiance)));
      total += maxChannel(result.radiance);
      ++count;
    }
    starts.clear();
  }
  if (count == 0) return {};
  // The square of the mean root: single bright paths have little influence on it.
  Brightness result{(sum / count) * (sum / count), {}};
  // What else surfaces reflect raises the direct light as it does in the picture.
  PathBatch::DirectLight all;
  for (const auto& [light, hits] : direct) all = {all.sum + light, all.hits + hits};
  const double rise = all.sum > 0 ? std::max(1.0, total / count / (all.sum / all.hits)) : 1;
  for (const auto& visible : plan_.visible) {
    double& brightest = result.visible.emplace_back(0);
    for (const std::size_t other : visible) {
      const auto& [light, hits] = direct[other];
      brightest = std::max(brightest, hits < leastHits ? std::numeric_limits<double>::infinity() : rise * light / hits);
    }
  }
  return result;
}

void PathTracer::traceRow(Film& film, int y, int samples, PathBatch& batch, SampleLuminances& luminances) const {
  const std::uint32_t pictureSeed = hashCombine(std::uint32_t(seed_), std::uint32_t(seed_ >> 32));
  const glm::dvec2 extent = viewExtent(camera_, double(film.width) / film.height);
  const glm::dvec2 pixelSize(2.0 / film.width, -2.0 / film.height);
  const std::size_t first = std::size_t(y) * std::size_t(film.width);
  PathSamples points(1, PathSamples::reflectedDirection);
  std::vector<PathBatch::Start> starts;
  const auto traceStarts = [&] {
    const auto results = batch.trace(starts);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      film.radiance[starts[i].pixel] += results[i].radiance;
      film.coverage[starts[i].pixel] += results[i].covered;
      const double brightness = luminance(results[i].radiance);
      if (!film.features.empty())
        film.features[starts[i].pixel] += glm::vec4(results[i].normal, brightness * brightness);
      luminances.add(brightness);
    }
    starts.clear();
  };
  for (int x = 0; x < film.width; ++x) {
    const std::size_t pixel = first + std::size_t(x);
    const std::uint32_t pixelSeed = hashCombine(pictureSeed, std::uint32_t(pixel));
    for (int i = 0; i < samples; ++i) {
      PathBatch::Start& start = starts.emplace_back();
      start.pixel = pixel;
      start.seed = {pixelSeed, std::uint32_t(film.samples + i)};
      const glm::dvec2 position = glm::dvec2(x, y) + points.filmPosition(start.seed);
      const glm::dvec2 place = film.window.centre + film.window.halfSize * (glm::dvec2(-1, 1) + pixelSize * position);
      start.ray = cameraRay(camera_, extent * place);
      if (starts.size() == PathBatch::capacity) traceStarts();
    }
  }
  traceStarts();
}

void PathTracer::trace(Film& film, int samples, std::span<RecordedPaths::Row> recorded,
                       const TaskControl& control) const {
  assert(film.width > 0 && film.height > 0 && samples >= 0);
  const std::size_t height = std::size_t(film.height);
  std::vector<RayCounters> counters(height);
  const Brightness unweighed;
  const Brightness& weighed = recorded.empty() ? brightness() : unweighed;
  std::mutex merging;
  parallelForBlocks(
      height, 1,
      [&](std::size_t y, std::size_t) {
        SampleLuminances luminances;
        PathBatch batch(*this, counters[y], recorded.empty() ? nullptr : &recorded[y], weighed);
        traceRow(film, int(y), samples, batch, luminances);
        const std::lock_guard lock(merging);
        film.luminances += luminances;
      },
      control);
  film.samples += samples;
  for (const RayCounters& one : counters) film.counters += one;
}

void PathTracer::accumulate(Film& film, int samples, const TaskControl& control) const {
  Film next = film;
  trace(next, samples, {}, control);
  film = std::move(next);
}

RecordedPaths PathTracer::record(Film film, int samples, const TaskControl& control) const {
  assert(plan_.reflections <= 1);
  auto rows = std::vector<RecordedPaths::Row>(std::size_t(film.height));
  trace(film, samples, rows, control);
  return {std::move(rows), film.image(), samples};
}

}  // namespace gonio::rendering
