// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/effect_costs.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/metrics/image_metrics.h"

namespace gonio::rendering {

namespace {

/// A picture with the times of its repeats.
struct Timed {
  Image picture;
  std::vector<double> times;

  double seconds() const { return std::ranges::min(times); }
  double spread() const {
    std::vector<double> sorted = times;
    std::ranges::sort(sorted);
    return sorted[sorted.size() / 2] - sorted.front();
  }
};

Timed renderOnce(const PathTracer& tracer, const EffectCostOptions& options, const TaskControl& control) {
  Film film(options.width, options.height);
  const auto start = std::chrono::steady_clock::now();
  tracer.accumulate(film, options.samples, {control.stop, {}});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {film.image(), {seconds}};
}

}  // namespace

EffectCosts measureEffectCosts(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                               const EffectOverrides& overrides, const EffectCostOptions& options,
                               const TaskControl& control) {
  const auto tracerOf = [&](const EffectOverrides& forced, std::uint64_t seed) {
    return PathTracer(scene, materials, planEffects(scene, materials, forced, options.thresholds), seed);
  };
  const EffectPlan plan = planEffects(scene, materials, overrides, options.thresholds);
  // As planned, then with each effect the other way round.
  std::vector<PathTracer> tracers{tracerOf(overrides, 1)};
  for (std::size_t i = 0; i < effectCount; ++i) {
    EffectOverrides turned = overrides;
    turned[i] = !plan.decisions[i].simulated;
    tracers.push_back(tracerOf(turned, 1));
  }
  std::vector<Timed> timed(tracers.size());
  const std::size_t pictures = 1 + std::size_t(options.repeats) * tracers.size();
  std::size_t done = 0;
  const auto render = [&](const PathTracer& tracer) {
    Timed result = renderOnce(tracer, options, control);
    control.report(double(++done) / double(pictures));
    return result;
  };
  // In turn, so that what else the machine does falls on all of them.
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (std::size_t i = 0; i < tracers.size(); ++i) {
      Timed one = render(tracers[i]);
      timed[i].picture = std::move(one.picture);
      timed[i].times.push_back(one.times.front());
    }
  const Timed& planned = timed[0];
  const double noise = metrics::relativeDifference(planned.picture, render(tracerOf(overrides, 2)).picture);
  EffectCosts costs{planned.seconds(), {}};
  for (std::size_t i = 0; i < effectCount; ++i) {
    const Timed& changed = timed[i + 1];
    const double added = changed.seconds() - planned.seconds();
    costs.effects.push_back({.effect = Effect(i),
                             .seconds = plan.decisions[i].simulated ? -added : added,
                             .secondsNoise = std::hypot(changed.spread(), planned.spread()),
                             .difference = metrics::relativeDifference(planned.picture, changed.picture),
                             .noise = noise});
  }
  return costs;
}

}  // namespace gonio::rendering
