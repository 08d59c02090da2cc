// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// A step of a roughness slider at 512 x 512 in each composition of an edit by layered lobes, over a table and over an
// RGL file. Baselines: the additive composition, the same edit that does not keep the albedo, and programs without flat
// inputs ("uniforms"). CPU is that of all threads.
#include <benchmark/benchmark.h>

#include "core/rendering/scene_file.h"
#include "core/rgl/rgl_file.h"
#include "tests/benchmarks/preview_fixture.h"

namespace {

using namespace gonio;
using namespace gonio::rendering;
using benchmarks::PreviewFixture;
using editing::Composition;

std::shared_ptr<const Brdf> measuredBase(bool rgl) {
  if (!rgl) return PreviewFixture::instance().table;
  const std::filesystem::path path = std::filesystem::path(GONIO_SHARED_DIR) / "data/rgl/satin_purple_rgb.bsdf";
  return std::filesystem::exists(path) ? rgl::readRgl(io::FileSource(path)).brdf : nullptr;
}

/// All three lobes change their width, the most that a step can ask for.
void step(benchmark::State& state, bool environment, Composition composition, bool rgl, bool flat, bool keepsAlbedo) {
  PreviewFixture& fixture = PreviewFixture::instance();
  fixture.resources->setUsesFlatUniforms(flat);
  const std::shared_ptr<const Brdf> base = measuredBase(rgl);
  if (!base) return state.SkipWithError("the development data is absent");
  const models::Model& model = models::layered();
  editing::DifferentialEdit edit{
      .model = &model, .fitted = models::defaultParameters(model.spec()), .composition = composition};
  edit.keepsAlbedo = keepsAlbedo;
  const auto density = std::make_shared<const TabulatedDensity>(*base);
  test::showSphere(fixture.renderer, sphereScene(environment ? studioEnvironment() : nullptr));
  double factor = 1;
  const auto next = [&] {
    factor = factor < 1.9 ? factor + 0.01 : 1.01;
    edit.edited = edit.fitted;
    for (const char* id : {"base-roughness", "flakes-roughness", "coat-roughness"})
      edit.edited.values[*model.spec().find(id)] *= factor;
    fixture.renderer.setSubject({widgets::EditedMaterial{base, {{edit}}}, density});
    fixture.renderer.restart();
    fixture.accumulate(1);
  };
  next();  // compiles the shader
  for (auto _ : state) next();
  fixture.show();
  fixture.resources->setUsesFlatUniforms(true);
}

const bool stepsAreRegistered = [] {
  for (const bool environment : {false, true})
    for (const bool rgl : {false, true})
      for (const Composition composition : {Composition::additive, Composition::logPlus, Composition::lobes})
        for (const bool keepsAlbedo : {false, true})
          for (const bool flat : {true, false}) {
            if (keepsAlbedo && composition != Composition::lobes) continue;
            const std::string name = std::string("composition/") + (environment ? "studio/" : "directional/") +
                                     (rgl ? "rgl/" : "table/") +
                                     std::string(editing::compositionIds[std::size_t(composition)]) +
                                     (keepsAlbedo ? "/albedo" : "") + (flat ? "" : "/uniforms");
            benchmark::RegisterBenchmark(name.c_str(), step, environment, composition, rgl, flat, keepsAlbedo)
                ->Unit(benchmark::kMillisecond)
                ->MeasureProcessCPUTime()
                ->UseRealTime();
          }
  return true;
}();

}  // namespace
