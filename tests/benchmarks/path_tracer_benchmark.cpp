// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/rendering/path_tracer.h"
#include "core/rendering/scene_file.h"
#include "tests/benchmarks/materials.h"

using namespace gonio;
using namespace gonio::rendering;

namespace {

constexpr int size = 64, samples = 8;

PathTracer tracerOf(const Scene& scene, const EffectOverrides& overrides) {
  static const auto plastic = std::make_shared<const RenderMaterial>(benchmarks::plastic());
  const std::vector<std::shared_ptr<const RenderMaterial>> slotMaterials(2, plastic);
  const auto materials = bindMaterials(scene, slotMaterials);
  return PathTracer(scene, materials, planEffects(scene, materials, overrides));
}

double seconds(const PathTracer& tracer) {
  Film film(size, size);
  const auto start = std::chrono::steady_clock::now();
  tracer.accumulate(film, samples);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A bundled scene as planned; beside it, in turn in the same run, with everything on: `everything` is that time over
/// the plan's.
void traceScene(benchmark::State& state, const std::string& name) {
  const Scene scene = openScene(name);
  const PathTracer planned = tracerOf(scene, {}), everything = tracerOf(scene, everyEffect());
  double plannedSeconds = 0, everythingSeconds = 0;
  for (auto _ : state) {
    const double one = seconds(planned);
    state.SetIterationTime(one);
    plannedSeconds += one;
    everythingSeconds += seconds(everything);
  }
  state.counters["samples"] = benchmark::Counter(double(state.iterations()) * size * size * samples / plannedSeconds);
  state.counters["everything"] = everythingSeconds / plannedSeconds;
}

const bool scenesAreRegistered = [] {
  for (const std::string& name : bundledSceneNames())
    benchmark::RegisterBenchmark(("traceScene/" + name).c_str(), traceScene, name)
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime();
  return true;
}();

}  // namespace
