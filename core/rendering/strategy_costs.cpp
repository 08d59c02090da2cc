// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/strategy_costs.h"

#include <chrono>
#include <cmath>

namespace gonio::rendering {

namespace {

double relativeError(const Film& film, const Film& reference) {
  double difference = 0, total = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const Rgb truth = reference.radiance[i] / double(reference.samples);
    const Rgb error = film.radiance[i] / double(film.samples) - truth;
    difference += glm::dot(error, error);
    total += glm::dot(truth, truth);
  }
  return total > 0 ? std::sqrt(difference / total) : 0;
}

}  // namespace

const char* strategyId(PathTracer::Strategy strategy) {
  constexpr const char* ids[] = {"both", "lights", "materials"};
  return ids[std::size_t(strategy)];
}

std::vector<StrategyCost> measureStrategyCosts(const Scene& scene,
                                               const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                               const EffectPlan& plan, const StrategyCostOptions& options,
                                               const TaskControl& control) {
  using Strategy = PathTracer::Strategy;
  constexpr double referenceFraction = 0.8;
  Film reference(options.width, options.height);
  PathTracer(scene, materials, plan, 2)
      .accumulate(reference, options.referenceSamples, control.between(0, referenceFraction));
  std::vector<StrategyCost> costs;
  for (const Strategy strategy : {Strategy::both, Strategy::lights, Strategy::materials}) {
    const PathTracer tracer(scene, materials, plan, 1, strategy);
    Film film(options.width, options.height);
    const auto start = std::chrono::steady_clock::now();
    tracer.accumulate(film, options.samples, {control.stop, {}});
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    StrategyCost cost{strategy, elapsed.count(), relativeError(film, reference)};
    const StrategyCost& both = costs.empty() ? cost : costs.front();
    cost.equalTimeError = cost.error * std::sqrt(cost.seconds / both.seconds);
    cost.equalErrorTime = both.error > 0 ? cost.seconds * std::pow(cost.error / both.error, 2) : cost.seconds;
    costs.push_back(cost);
    control.report(referenceFraction + (1 - referenceFraction) * double(costs.size()) / 3);
  }
  return costs;
}

}  // namespace gonio::rendering
