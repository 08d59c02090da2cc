// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/effect_costs.h"

#include <chrono>
#include <cmath>
#include <limits>

namespace gonio {

namespace {

struct Timed {
  Image picture;
  double seconds = std::numeric_limits<double>::infinity();
};

double relativeDifference(const Image& a, const Image& b) {
  double difference = 0, total = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb x(a.pixels[i]), d = x - Rgb(b.pixels[i]);
    difference += glm::dot(d, d);
    total += glm::dot(x, x);
  }
  return total > 0 ? std::sqrt(difference / total) : 0;
}

}  // namespace

EffectCosts measureEffectCosts(const Scene& scene, const std::vector<std::shared_ptr<const TracedMaterial>>& materials,
                               const EffectOverrides& overrides, const EffectCostOptions& options,
                               const TaskControl& control) {
  const auto render = [&](const EffectOverrides& forced, std::uint64_t seed, int repeats, const TaskControl& part) {
    const PathTracer tracer(scene, materials, planEffects(scene, materials, forced, options.thresholds), seed);
    Timed result;
    for (int i = 0; i < repeats; ++i) {
      Film film(options.width, options.height);
      const auto start = std::chrono::steady_clock::now();
      tracer.accumulate(film, options.samples, {part.stop, {}});
      result.seconds =
          std::min(result.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      result.picture = film.image();
    }
    part.report(1);
    return result;
  };
  const auto share = [](std::size_t done) { return double(done) / (effectCount + 2); };
  const Timed planned = render(overrides, 1, options.repeats, control.between(0, share(1)));
  const Timed other = render(overrides, 2, 1, control.between(share(1), share(2)));
  const EffectPlan plan = planEffects(scene, materials, overrides, options.thresholds);
  EffectCosts costs{planned.seconds, {}};
  for (std::size_t i = 0; i < effectCount; ++i) {
    EffectOverrides turned = overrides;
    const bool simulated = plan.decisions[i].simulated;
    turned[i] = !simulated;
    const Timed changed = render(turned, 1, options.repeats, control.between(share(i + 2), share(i + 3)));
    costs.effects.push_back(
        {Effect(i), simulated ? planned.seconds - changed.seconds : changed.seconds - planned.seconds,
         relativeDifference(planned.picture, changed.picture), relativeDifference(planned.picture, other.picture)});
  }
  return costs;
}

}  // namespace gonio
