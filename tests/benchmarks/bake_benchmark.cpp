// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "tests/benchmarks/materials.h"

using namespace gonio;

namespace {

/// The plain baseline: the model's values alone, on one thread, for as many pairs as the table has cells above the
/// horizon; no grid, no table.
void bakePlainBaseline(benchmark::State& state) {
  const auto brdf = benchmarks::plastic();
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(benchmarks::plasticTable()->validCount());
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    brdf->evaluate(pairs, values);
    benchmark::DoNotOptimize(values.data());
  }
}
BENCHMARK(bakePlainBaseline)->Unit(benchmark::kMillisecond)->UseRealTime();

void bakeGgx(benchmark::State& state) {
  const auto brdf = benchmarks::plastic();
  for (auto _ : state) benchmark::DoNotOptimize(bakeTable(*brdf));
}
BENCHMARK(bakeGgx)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
