// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/path_tracer.h"

#include <algorithm>
#include <cassert>
#include <mutex>

#include "core/math/parallel.h"
#include "core/rendering/path_walk.h"

namespace gonio {

PathTracer::PathTracer(Scene scene, std::vector<std::shared_ptr<const TracedMaterial>> materials, EffectPlan plan,
                       std::uint64_t seed, Strategy strategy)
    : scene_(std::move(scene)),
      materials_(std::move(materials)),
      plan_(std::move(plan)),
      seed_(seed),
      strategy_(strategy),
      camera_(cameraFrame(scene_.camera)),
      rotation_(scene_.environmentRotation),
      candidates_(scene_.objects.size()) {
  for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
    std::vector<std::size_t>& candidates = candidates_[object];
    if (plan_.reflections > 1) candidates = plan_.visible[object];
    for (std::size_t light = 0; light < plan_.lights.size(); ++light) {
      const SceneLight& source = plan_.lights[light];
      const bool isLamp = source.kind == SceneLight::Kind::rectangle;
      if (!plan_.lit[object][light] || !(isLamp || source.kind == SceneLight::Kind::environment)) continue;
      if (isLamp) candidates.push_back(source.index);
      candidates.insert(candidates.end(), plan_.blockers[object][light].begin(), plan_.blockers[object][light].end());
    }
    // Whatever stands before a visible surface hides it.
    for (std::size_t other = 0; other < scene_.objects.size() && !candidates.empty(); ++other)
      if (plan_.reflections > 1 && !plan_.visible[object].empty() &&
          (other != object || !isConvex(scene_.objects[object].shape)))
        candidates.push_back(other);
    std::ranges::sort(candidates);
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  }
}

void PathTracer::accumulate(Film& film, int samples, const TaskControl& control) const {
  assert(film.width > 0 && film.height > 0 && samples >= 0);
  const double aspect = double(film.width) / film.height;
  const std::size_t width = std::size_t(film.width), height = std::size_t(film.height);
  Film next = film;
  std::vector<RayCounters> counters(height);
  const std::uint32_t pictureSeed = hashCombine(std::uint32_t(seed_), std::uint32_t(seed_ >> 32));
  std::mutex merging;
  const auto row = [&](std::size_t y) {
    Walk walk(*this, counters[y]);
    SampleLuminances luminances;
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t index = y * width + x;
      for (int i = 0; i < samples; ++i) {
        const WalkPixel pixel{hashCombine(pictureSeed, std::uint32_t(index)), std::uint32_t(film.samples + i)};
        const glm::dvec2 jitter = pixel.pair(0, WalkPixel::filmPosition);
        const CameraRay ray = cameraRay(camera_, 2 * (double(x) + jitter.x) / film.width - 1,
                                        1 - 2 * (double(y) + jitter.y) / film.height, aspect);
        const auto [radiance, covered] = walk.follow(pixel, ray);
        next.radiance[index] += radiance;
        next.coverage[index] += covered;
        luminances.add(luminance(radiance));
      }
    }
    const std::lock_guard lock(merging);
    next.luminances += luminances;
  };
  parallelForBlocks(
      height, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) row(y);
      },
      control);
  next.samples += samples;
  for (const RayCounters& one : counters) next.counters += one;
  film = std::move(next);
}

}  // namespace gonio
