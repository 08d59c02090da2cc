// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "core/materials/material.h"
#include "tests/benchmarks/materials.h"

using namespace gonio;

namespace {

void lookups(benchmark::State& state, const std::vector<DirectionPair>& pairs, TableLookup mode) {
  const auto table = benchmarks::plasticTable();
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    table->evaluate(pairs, values, mode);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}

/// The plain baseline: rotations by angles, as the reference code that came with MERL does, and a cell without
/// interpolation.
Rgb plainNearest(const TabulatedBrdf& table, const DirectionPair& pair) {
  const Direction half = glm::normalize(pair.wi + pair.wo);
  const double thetaH = std::acos(std::min(1.0, half.z)), phiH = std::atan2(half.y, half.x);
  const double c = std::cos(-phiH), s = std::sin(-phiH);
  const Direction turned{c * pair.wi.x - s * pair.wi.y, s * pair.wi.x + c * pair.wi.y, pair.wi.z};
  const double ch = std::cos(-thetaH), sh = std::sin(-thetaH);
  const Direction difference{ch * turned.x + sh * turned.z, turned.y, -sh * turned.x + ch * turned.z};
  const double thetaD = std::acos(std::min(1.0, difference.z));
  const double phiD = foldPhiD(std::atan2(difference.y, difference.x));
  const auto cell = [](double x, int count) { return std::clamp(int(x * count), 0, count - 1); };
  return Rgb(table.values()[table.grid().index(cell(std::sqrt(thetaH / halfPi), 90), cell(thetaD / halfPi, 90),
                                               cell(phiD / pi, 180))]);
}

void lookupPlainBaseline(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(1 << 16);
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = plainNearest(*table, pairs[i]);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}
BENCHMARK(lookupPlainBaseline)->Unit(benchmark::kMillisecond);

void lookupNearestRandom(benchmark::State& state) {
  lookups(state, benchmarks::randomPairs(1 << 16), TableLookup::cell);
}
BENCHMARK(lookupNearestRandom)->Unit(benchmark::kMillisecond);

void lookupTrilinearRandom(benchmark::State& state) {
  lookups(state, benchmarks::randomPairs(1 << 16), TableLookup::trilinear);
}
BENCHMARK(lookupTrilinearRandom)->Unit(benchmark::kMillisecond);

void lookupTrilinearSphere(benchmark::State& state) {
  lookups(state, benchmarks::spherePairs(256), TableLookup::trilinear);
}
BENCHMARK(lookupTrilinearSphere)->Unit(benchmark::kMillisecond);

/// A measured RGL file, on one core: pairs in a batch, and as the baseline one after the other.
void evaluateRgl(benchmark::State& state, bool isBatch) {
  const auto brdf = materials::readMaterial("library:rgl/satin_purple").brdf;
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(1 << 14);
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    if (isBatch)
      brdf->evaluate(pairs, values);
    else
      for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = brdf->evaluate(pairs[i].wi, pairs[i].wo);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}
BENCHMARK_CAPTURE(evaluateRgl, batch, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluateRgl, singlePairs, false)->Unit(benchmark::kMillisecond);

}  // namespace
