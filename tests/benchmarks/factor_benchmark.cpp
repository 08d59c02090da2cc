// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/factorization/pdv_factors.h"
#include "tests/benchmarks/materials.h"

namespace {

using namespace gonio;
using namespace gonio::factorization;

const PdvFactors& plasticFactors() {
  static const PdvFactors factors = factorizePdv(*benchmarks::plasticTable()).factors;
  return factors;
}

/// RGB, so many terms.
void factorise(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  for (auto _ : state) benchmark::DoNotOptimize(factorizePdv(*table, {.terms = int(state.range(0))}));
}
BENCHMARK(factorise)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// Time of an item: of one pair, on one core.
void evaluateFactors(benchmark::State& state) {
  const auto brdf = makePdvBrdf(plasticFactors().truncated(int(state.range(0))));
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(1 << 14);
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    brdf->evaluate(pairs, values);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}
BENCHMARK(evaluateFactors)->Arg(1)->Arg(2)->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);

void drawFromFactors(benchmark::State& state) {
  const auto brdf = makePdvBrdf(plasticFactors());
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(1 << 14);
  for (auto _ : state)
    for (const DirectionPair& pair : pairs)
      benchmark::DoNotOptimize(brdf->sample(pair.wo, {0.3, pair.wi.z, 0.5 + 0.49 * pair.wi.x}));
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}
BENCHMARK(drawFromFactors)->Unit(benchmark::kMillisecond);

}  // namespace
