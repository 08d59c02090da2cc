// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/rendering/sphere_renderer.h"
#include "tests/benchmarks/materials.h"

using namespace gonio;

namespace {

const SphereRenderOptions thumbnail = [] {
  SphereRenderOptions options;
  options.width = options.height = 128;
  options.samples = 64;
  return options;
}();

void renderSphereModel(benchmark::State& state) {
  const auto brdf = benchmarks::plastic();
  for (auto _ : state) benchmark::DoNotOptimize(renderSphere(*brdf, comparisonScene(), thumbnail));
}
BENCHMARK(renderSphereModel)->Unit(benchmark::kMillisecond)->UseRealTime();

void renderSphereTable(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(renderSphere(*table, comparisonScene(), thumbnail));
}
BENCHMARK(renderSphereTable)->Unit(benchmark::kMillisecond)->UseRealTime();

void renderSphereDirectional(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(renderSphere(*table, SphereScene{}, thumbnail));
}
BENCHMARK(renderSphereDirectional)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
