// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/materials/material.h"
#include "core/metrics/brdf_metrics.h"
#include "core/metrics/plausibility.h"
#include "core/sampling/directional_albedo.h"
#include "core/sampling/fitted_densities.h"
#include "tests/benchmarks/materials.h"

using namespace gonio;

namespace {

void brdfErrorsOfModel(benchmark::State& state) {
  const auto brdf = benchmarks::plastic();
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(metrics::brdfErrors(*table, *brdf));
}
BENCHMARK(brdfErrorsOfModel)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A measured file in its native form, in both orders of the directions.
void brdfErrorsOfRgl(benchmark::State& state) {
  const auto model = benchmarks::plastic();
  const auto measured = materials::readMaterial("library:rgl/satin_purple").brdf;
  for (auto _ : state) benchmark::DoNotOptimize(metrics::brdfErrors(*measured, *model));
}
BENCHMARK(brdfErrorsOfRgl)->Unit(benchmark::kMillisecond)->UseRealTime();

void brdfErrorsOfTable(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(metrics::brdfErrors(*table, *table));
}
BENCHMARK(brdfErrorsOfTable)->Unit(benchmark::kMillisecond)->UseRealTime();

void plausibilityOfTable(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(metrics::checkPlausibility(*table));
}
BENCHMARK(plausibilityOfTable)->Unit(benchmark::kMillisecond)->UseRealTime();

void albedoOfTable(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(directionalAlbedo(*table, 0.5));
}
BENCHMARK(albedoOfTable)->Unit(benchmark::kMillisecond)->UseRealTime();

void samplingDensityOfTable(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(estimateSamplingDensity(*table));
}
BENCHMARK(samplingDensityOfTable)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
