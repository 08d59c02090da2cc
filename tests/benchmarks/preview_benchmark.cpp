// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// The preview's frame: a slider step (new uniforms, first frame) at 512 x 512, against the same frame without an edit.
// CPU is that of all threads: what software OpenGL costs whatever else the machine does.
#include <benchmark/benchmark.h>

#include "core/brdf/incidence_table_brdf.h"
#include "core/brdf/utia_brdf.h"
#include "core/dictionary/decode.h"
#include "core/factorization/pdv_operations.h"
#include "core/materials/bundled_library.h"
#include "core/materials/dictionary_file.h"
#include "core/models/model.h"
#include "core/rendering/scene_file.h"
#include "core/rgl/rgl_file.h"
#include "tests/benchmarks/preview_fixture.h"
#include "tests/support/code_files.h"
#include "widgets/interpolation/prepared_blend.h"
#include "widgets/preview/gl/noise_filter.h"
#include "widgets/preview/gl/textures.h"

namespace {

using namespace gonio;
using namespace gonio::rendering;
using benchmarks::PreviewFixture;

void runFrames(benchmark::State& state, bool environment, bool edited) {
  PreviewFixture& fixture = PreviewFixture::instance();
  test::showSphere(fixture.renderer, sphereScene(environment ? studioEnvironment() : nullptr));
  fixture.show();
  const auto roughness = *fixture.edit.model->spec().find("roughness");
  double value = 0.1;
  for (auto _ : state) {
    if (edited) {
      value = value < 0.9 ? value + 0.01 : 0.1;
      fixture.edit.edited = fixture.edit.fitted;
      fixture.edit.edited.values[roughness] = Rgb(value);
      fixture.show({{fixture.edit}});
    }
    fixture.renderer.restart();
    fixture.accumulate(int(state.range(0)));
  }
}

void directionalFrame(benchmark::State& state) { runFrames(state, false, false); }
void directionalSliderStep(benchmark::State& state) { runFrames(state, false, true); }
void environmentFrame(benchmark::State& state) { runFrames(state, true, false); }
void environmentSliderStep(benchmark::State& state) { runFrames(state, true, true); }

/// A material in its native form, or as a table: the baseline.
void runFormFrames(benchmark::State& state, bool environment, std::shared_ptr<const Brdf> brdf, bool asTable) {
  PreviewFixture& fixture = PreviewFixture::instance();
  if (asTable) brdf = bakeTable(*brdf);
  test::showSphere(fixture.renderer, sphereScene(environment ? studioEnvironment() : nullptr));
  fixture.renderer.setSubject(widgets::measuredSubject(brdf, std::make_shared<const TabulatedDensity>(*brdf)));
  fixture.accumulate(1);
  for (auto _ : state) {
    fixture.renderer.restart();
    fixture.accumulate(1);
  }
  fixture.show();
}

void runRglFrames(benchmark::State& state, bool environment, bool asTable) {
  const std::filesystem::path path = std::filesystem::path(GONIO_SHARED_DIR) / "data/rgl/satin_purple_rgb.bsdf";
  if (!std::filesystem::exists(path)) return state.SkipWithError("the development data is absent");
  runFormFrames(state, environment, rgl::readRgl(io::FileSource(path)).brdf, asTable);
}
void directionalRglTable(benchmark::State& state) { runRglFrames(state, false, true); }
void directionalRgl(benchmark::State& state) { runRglFrames(state, false, false); }
void environmentRglTable(benchmark::State& state) { runRglFrames(state, true, true); }
void environmentRgl(benchmark::State& state) { runRglFrames(state, true, false); }

/// The drag of a factor curve: new curves, their texels, the first frame.
void runFactorDrag(benchmark::State& state, bool environment) {
  PreviewFixture& fixture = PreviewFixture::instance();
  const auto factors = factorization::factorizePdv(
                           *fixture.table, {.form = factorization::PdvForm::twoFactors, .terms = int(state.range(0))})
                           .factors;
  test::showSphere(fixture.renderer, sphereScene(environment ? studioEnvironment() : nullptr));
  fixture.show();
  editing::FactorEdit edit{.original = std::make_shared<const factorization::PdvFactors>(factors), .edited = {}};
  double factor = 1;
  for (auto _ : state) {
    factor = factor < 4 ? factor * 1.1 : 1.1;
    edit.edited = std::make_shared<const factorization::PdvFactors>(factorization::widenF2(factors, factor));
    fixture.show({{edit}});
    fixture.renderer.restart();
    fixture.accumulate(1);
  }
  fixture.show();
}
void directionalFactorDrag(benchmark::State& state) { runFactorDrag(state, false); }
void environmentFactorDrag(benchmark::State& state) { runFactorDrag(state, true); }

/// The drag of a point between materials: new weights, the first frame. Arguments: the number of materials, and in
/// spaces that lose detail whether it is preserved.
void runBlendDrag(benchmark::State& state, bool environment, interpolation::InterpolationSpace space) {
  PreviewFixture& fixture = PreviewFixture::instance();
  const models::Model& model = *fixture.edit.model;
  static const auto materials = [&model] {
    std::vector<interpolation::InterpolationMaterial> ends;
    for (const double roughness : {0.1, 0.2, 0.4, 0.7}) {
      models::ParameterValues values = models::defaultParameters(model.spec());
      values.values[*model.spec().find("roughness")] = Rgb(roughness);
      ends.push_back({bakeTable(*model.instantiate(values))});
    }
    return ends;
  }();
  const auto count = std::size_t(state.range(0));
  const bool preserveDetail = interpolation::losesDetail(space) && state.range(1) != 0;
  const auto blend = widgets::prepareBlend(space, {materials.begin(), materials.begin() + std::ptrdiff_t(count)},
                                           documents::blendOptions(nullptr, preserveDetail));
  test::showSphere(fixture.renderer, sphereScene(environment ? studioEnvironment() : nullptr));
  const auto density = fixture.renderer.subject().density;
  std::vector<double> weights(count);
  // Textures and shaders are there when the hand begins.
  const auto first = std::vector<double>(count, 1.0 / double(count));
  fixture.renderer.setSubject(widgets::blendSubject(*blend, first));
  fixture.accumulate(1);
  double t = 0.1;
  for (auto _ : state) {
    t = t < 0.9 ? t + 0.013 : 0.1;
    weights.assign(count, t / double(count - 1));
    weights[0] = 1 - t;
    widgets::PreviewSubject subject = widgets::blendSubject(*blend, weights);
    subject.density = density;
    fixture.renderer.setSubject(subject);
    fixture.accumulate(1);
  }
  fixture.renderer.setSubject(widgets::measuredSubject(materials[0].table, density));
}
void directionalLinearBlend(benchmark::State& state) {
  runBlendDrag(state, false, interpolation::InterpolationSpace::linear);
}
void environmentLinearBlend(benchmark::State& state) {
  runBlendDrag(state, true, interpolation::InterpolationSpace::linear);
}
void environmentDifferentialBlend(benchmark::State& state) {
  runBlendDrag(state, true, interpolation::InterpolationSpace::differential);
}
void environmentParameterBlend(benchmark::State& state) {
  runBlendDrag(state, true, interpolation::InterpolationSpace::parameters);
}
void environmentFactorBlend(benchmark::State& state) {
  runBlendDrag(state, true, interpolation::InterpolationSpace::factors);
}
void environmentDictionaryBlend(benchmark::State& state) {
  runBlendDrag(state, true, interpolation::InterpolationSpace::dictionary);
}

/// A code into the texture that the preview samples: on the card, or on the CPU and uploaded. Both of the same code
/// with so many coefficients per channel; until the card is done.
struct CodeFixture : QOpenGLFunctions_4_1_Core {
  std::shared_ptr<const materials::NamedEnsemble> bundled = materials::bundledEnsemble(materials::bundledIds().back());
  dictionary::SparseCode code;
  GLuint texture = 0;

  explicit CodeFixture(std::size_t coefficients) {
    PreviewFixture::instance();
    initializeOpenGLFunctions();
    code = test::readCodeFile("cc_ibiza_sunset").truncated(coefficients);
    dictionary::GridGeometry::of(code.grid);
  }
  ~CodeFixture() { glDeleteTextures(1, &texture); }
};

void decodeOnTheCard(benchmark::State& state) {
  CodeFixture fixture{std::size_t(state.range(0))};
  widgets::ProgramCache programs;
  widgets::CodeDecoder decoder;
  const auto run = [&] {
    decoder.decode(fixture, programs, widgets::codeTexels(fixture.bundled->ensemble, fixture.code), fixture.texture);
    fixture.glFinish();
  };
  run();  // shaders and the cosines of the grid are there when the first code comes
  for (auto _ : state) run();
  decoder.release(fixture);
  programs.release(fixture);
}
void decodeAndUpload(benchmark::State& state) {
  CodeFixture fixture{std::size_t(state.range(0))};
  for (auto _ : state) {
    const auto table = dictionary::decode(fixture.bundled->ensemble, fixture.code);
    widgets::uploadTable(fixture, fixture.texture, table->grid(), table->values(), table->valid());
    fixture.glFinish();
  }
}
void uploadDecoded(benchmark::State& state) {
  CodeFixture fixture{std::size_t(state.range(0))};
  const auto table = dictionary::decode(fixture.bundled->ensemble, fixture.code);
  for (auto _ : state) {
    widgets::uploadTable(fixture, fixture.texture, table->grid(), table->values(), table->valid());
    fixture.glFinish();
  }
}
void prepareTexels(benchmark::State& state) {
  CodeFixture fixture{std::size_t(state.range(0))};
  for (auto _ : state) benchmark::DoNotOptimize(widgets::codeTexels(fixture.bundled->ensemble, fixture.code));
}

void codeCounts(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(262)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}
BENCHMARK(decodeOnTheCard)->Apply(codeCounts);
BENCHMARK(decodeAndUpload)->Apply(codeCounts);
BENCHMARK(uploadDecoded)->Arg(262)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(prepareTexels)->Apply(codeCounts);

BENCHMARK(directionalLinearBlend)
    ->DenseRange(2, 4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(environmentLinearBlend)
    ->DenseRange(2, 4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(environmentDifferentialBlend)
    ->DenseRange(2, 4)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
void detailSwitch(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({2, 0})->Args({2, 1})->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}
BENCHMARK(environmentParameterBlend)->Apply(detailSwitch);
BENCHMARK(environmentFactorBlend)->Apply(detailSwitch);
BENCHMARK(environmentDictionaryBlend)->Apply(detailSwitch);
BENCHMARK(directionalFactorDrag)
    ->Arg(1)
    ->Arg(3)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(environmentFactorDrag)
    ->Arg(1)
    ->Arg(3)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(directionalFrame)->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(directionalSliderStep)->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(environmentFrame)->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(directionalRglTable)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(directionalRgl)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(environmentRglTable)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(environmentRgl)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(environmentSliderStep)
    ->Arg(1)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

std::shared_ptr<const Brdf> utiaMaterial() {
  std::vector<glm::vec3> values(UtiaBrdf::directionCount * UtiaBrdf::directionCount);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = glm::vec3(0.1f + 0.01f * float(i % 7));
  return std::make_shared<const UtiaBrdf>(std::move(values));
}
/// As Zemax writes it: 10 angles of incidence, each 37 azimuths by 91 polar angles about the mirror direction.
std::shared_ptr<const Brdf> incidenceTable() {
  IncidenceTable table;
  for (int i = 0; i < 10; ++i) table.incident.push_back(radians(8 * i));
  for (int i = 0; i < 37; ++i) table.azimuths.push_back(radians(5 * i));
  for (int i = 0; i < 91; ++i) table.polars.push_back(radians(2 * i));
  for (int i = 0; i < 10 * 37 * 91; ++i) table.values.emplace_back(0.1f + 0.01f * float(i % 7));
  return std::make_shared<const IncidenceTableBrdf>(std::move(table));
}
std::shared_ptr<const Brdf> publishedFit() { return materials::sgdMaterial(materials::sgdFits().front()).brdf; }
std::shared_ptr<const Brdf> tenFactors() {
  return factorization::makePdvBrdf(factorization::factorizePdv(*PreviewFixture::instance().table).factors);
}

/// Every form of a base beside the table of it: form/NAME/directional, form/NAME/directional/table.
const bool formsAreRegistered = [] {
  const std::pair<const char*, std::shared_ptr<const Brdf> (*)()> forms[] = {{"utia", utiaMaterial},
                                                                             {"incidence-table", incidenceTable},
                                                                             {"published-fit", publishedFit},
                                                                             {"factors", tenFactors}};
  for (const auto& [name, make] : forms)
    for (const bool environment : {false, true})
      for (const bool asTable : {false, true})
        benchmark::RegisterBenchmark(
            (std::string("form/") + name + (environment ? "/studio" : "/directional") + (asTable ? "/table" : ""))
                .c_str(),
            [make = make, environment, asTable](benchmark::State& state) {
              runFormFrames(state, environment, make(), asTable);
            })
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime()
            ->UseRealTime();
  return true;
}();

/// One sample a pixel of a bundled scene, with what its plan has; "sphere" is the baseline.
void sceneFrame(benchmark::State& state, const std::string& name) {
  PreviewFixture& fixture = PreviewFixture::instance();
  const Scene scene = openScene(name, 3);
  fixture.show();
  fixture.renderer.setScene(scene, widgets::previewPlan(scene, diffuseMaterial(Rgb(0.5))));
  fixture.accumulate(1);  // compiles the shader and uploads the environment
  for (auto _ : state) {
    fixture.renderer.restart();
    fixture.accumulate(1);
  }
}

/// Beside scene/sphere, a sample of the same picture.
void noiseFilter(benchmark::State& state) {
  PreviewFixture& fixture = PreviewFixture::instance();
  const Scene scene = openScene("sphere");
  fixture.show();
  fixture.renderer.setScene(scene, widgets::previewPlan(scene, diffuseMaterial(Rgb(0.5))));
  fixture.accumulate(14);
  QOpenGLFunctions_4_1_Core gl;
  gl.initializeOpenGLFunctions();
  widgets::PreviewResources resources;
  resources.initialize();
  widgets::NoiseFilter filter;
  filter.apply(gl, resources, fixture.renderer);  // compiles its shaders
  for (auto _ : state) {
    filter.apply(gl, resources, fixture.renderer);
    gl.glFinish();
  }
  filter.release();
  resources.release();
}
BENCHMARK(noiseFilter)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

const bool scenesAreRegistered = [] {
  for (const std::string& name : bundledSceneNames())
    if (widgets::SceneUniforms::canDraw(openScene(name, 3)))
      benchmark::RegisterBenchmark(("scene/" + name).c_str(), sceneFrame, name)
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
  return true;
}();

}  // namespace
