// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/editing/edit.h"
#include "core/rendering/render_picture.h"
#include "tests/benchmarks/materials.h"

using namespace gonio;
using namespace gonio::rendering;

namespace {

enum class Kind { model, table, edited };

std::shared_ptr<const Brdf> materialOf(Kind kind) {
  if (kind == Kind::model) return benchmarks::plastic();
  if (kind == Kind::table) return benchmarks::plasticTable();
  const models::ModelSpec& spec = models::ggx().spec();
  editing::DifferentialEdit edit{
      .model = &models::ggx(), .fitted = models::defaultParameters(spec), .edited = models::defaultParameters(spec)};
  edit.edited.values[*spec.find("diffuse")] = Rgb(0.05, 0.3, 0.4);
  return editing::applyEdits(benchmarks::plasticTable(), editing::EditList{{edit}});
}

/// The lone sphere of previews, thumbnails and rendered SNRs.
void renderSphere(benchmark::State& state, Kind kind, bool inStudio) {
  const auto brdf = materialOf(kind);
  const Scene scene = sphereScene(inStudio ? studioEnvironment() : nullptr);
  const RenderOptions options{.width = 128, .height = 128, .samples = 64, .density = {}};
  for (auto _ : state) benchmark::DoNotOptimize(renderPicture(*brdf, scene, options));
}
void inStudio(benchmark::State& state, Kind kind) { renderSphere(state, kind, true); }
void inDistantLight(benchmark::State& state, Kind kind) { renderSphere(state, kind, false); }

/// A picture of a ranking: traced, and from the paths that a comparison has recorded.
void comparisonPlainBaseline(benchmark::State& state) {
  const RenderedComparison comparison(*benchmarks::plasticTable(), smallComparisonPicture());
  const auto brdf = benchmarks::plastic();
  for (auto _ : state) benchmark::DoNotOptimize(comparison.trace(*brdf));
}
void comparisonRecorded(benchmark::State& state) {
  const RenderedComparison comparison(*benchmarks::plasticTable(), smallComparisonPicture());
  const auto brdf = benchmarks::plastic();
  for (auto _ : state) benchmark::DoNotOptimize(comparison.render(*brdf));
}
BENCHMARK(comparisonPlainBaseline)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(comparisonRecorded)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

BENCHMARK_CAPTURE(inStudio, model, Kind::model)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(inStudio, table, Kind::table)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(inStudio, edited, Kind::edited)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(inDistantLight, model, Kind::model)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(inDistantLight, table, Kind::table)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
