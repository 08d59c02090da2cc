// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/editing/differential_edit.h"
#include "core/rendering/path_tracer.h"
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

std::shared_ptr<const Brdf> edited() {
  const models::ModelSpec& spec = models::ggx().spec();
  editing::DifferentialEdit edit{
      .model = &models::ggx(), .fitted = models::defaultParameters(spec), .edited = models::defaultParameters(spec)};
  edit.edited.values[*spec.find("diffuse")] = Rgb(0.05, 0.3, 0.4);
  return editing::applyEdits(benchmarks::plasticTable(), std::span(&edit, 1));
}

std::shared_ptr<const Brdf> material(int kind) {
  if (kind == 0) return benchmarks::plastic();
  if (kind == 1) return benchmarks::plasticTable();
  return edited();
}

SphereScene sceneOfKind(bool directional) { return directional ? SphereScene{} : comparisonScene(); }

Image bySphereRenderer(const Brdf& brdf, const SphereScene& scene, int samples, std::uint64_t seed) {
  SphereRenderOptions options = thumbnail;
  options.samples = samples;
  options.seed = seed;
  return renderSphere(brdf, scene, options);
}

Image byPathTracer(const std::shared_ptr<const Brdf>& brdf, const SphereScene& sphere, int samples,
                   std::uint64_t seed) {
  const Scene scene = sceneOf(sphere);
  const std::vector lookedAt{std::make_shared<const TracedMaterial>(brdf)};
  const auto materials = bindMaterials(scene, lookedAt);
  Film film(thumbnail.width, thumbnail.height);
  PathTracer(scene, materials, planEffects(scene, materials), seed).accumulate(film, samples);
  return film.image();
}

template <bool traced>
void renderLoneSphere(benchmark::State& state) {
  const auto brdf = material(int(state.range(0)));
  const SphereScene scene = sceneOfKind(state.range(1));
  const auto render = [&](int samples, std::uint64_t seed) {
    return traced ? byPathTracer(brdf, scene, samples, seed) : bySphereRenderer(*brdf, scene, samples, seed);
  };
  for (auto _ : state) benchmark::DoNotOptimize(render(thumbnail.samples, 1));
}
BENCHMARK(renderLoneSphere<false>)
    ->ArgsProduct({{0, 1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(renderLoneSphere<true>)
    ->ArgsProduct({{0, 1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
