// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/editing/edit.h"
#include "tests/benchmarks/materials.h"

using namespace gonio;

namespace {

/// An edit of the roughness of one model.
editing::DifferentialEdit roughened(const models::Model& model) {
  editing::DifferentialEdit edit{&model, models::defaultParameters(model.spec()), {}};
  edit.edited = edit.fitted;
  for (std::size_t i = 0; i < edit.edited.values.size(); ++i)
    if (!model.spec().parameters[i].linear && model.spec().parameters[i].choices.empty()) {
      edit.edited.values[i] *= 1.5;
      break;
    }
  return edit;
}

/// The plain baseline: the two evaluations of the model at all valid cells, on one thread; nothing is added or stored.
void editPlainBaseline(benchmark::State& state) {
  const editing::DifferentialEdit edit = roughened(models::findModel("ggx"));
  const auto from = edit.model->instantiate(edit.fitted), to = edit.model->instantiate(edit.edited);
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(benchmarks::plasticTable()->validCount());
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    from->evaluate(pairs, values);
    to->evaluate(pairs, values);
    benchmark::DoNotOptimize(values.data());
  }
}
BENCHMARK(editPlainBaseline)->Unit(benchmark::kMillisecond)->UseRealTime();

/// 1.458 million cells in RGB: under 1 s on 2 cores for GGX.
void editBake(benchmark::State& state, const char* model) {
  const auto base = benchmarks::plasticTable();
  const editing::Edit edit{roughened(models::findModel(model))};
  for (auto _ : state) benchmark::DoNotOptimize(editing::bakeEdits(base, std::span(&edit, 1)));
}
BENCHMARK_CAPTURE(editBake, ggx, "ggx")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(editBake, sgd, "sgd")->Unit(benchmark::kMillisecond)->UseRealTime();

/// Look-ups through the edit, as the renderer makes them.
void editLookup(benchmark::State& state) {
  const editing::Edit edit{roughened(models::findModel("ggx"))};
  const auto edited = editing::applyEdits(benchmarks::plasticTable(), std::span(&edit, 1));
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(1 << 16);
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    edited->evaluate(pairs, values);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}
BENCHMARK(editLookup)->Unit(benchmark::kMillisecond);

}  // namespace
