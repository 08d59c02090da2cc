// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include <random>

#include "core/math/decompositions.h"

namespace {

using namespace gonio;

constexpr Eigen::Index merlCells = 1'111'432;  // above the horizon

TallMatrix randomColumns(Eigen::Index columns) {
  TallMatrix result{std::vector<float>(std::size_t(merlCells * columns)), merlCells, columns};
  std::minstd_rand generator(1);
  for (float& value : result.values) value = float(generator()) / float(std::minstd_rand::max()) - 0.5f;
  return result;
}

/// So many channels of materials; items are multiplications with an addition, of which the symmetric product needs
/// rows x columns^2 / 2.
void gramOfMaterials(benchmark::State& state) {
  const TallMatrix columns = randomColumns(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(gramMatrix(columns));
  state.SetItemsProcessed(state.iterations() * merlCells * state.range(0) * state.range(0) / 2);
}
BENCHMARK(gramOfMaterials)->Arg(66)->Arg(411)->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();

/// All of it, with so many components.
void principalComponents(benchmark::State& state) {
  for (auto _ : state) {
    state.PauseTiming();
    TallMatrix columns = randomColumns(state.range(0));
    state.ResumeTiming();
    benchmark::DoNotOptimize(decomposeGramSvd(std::move(columns), int(state.range(1))));
  }
}
BENCHMARK(principalComponents)
    ->Args({66, 66})
    ->Args({411, 60})
    ->Args({411, 411})
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
