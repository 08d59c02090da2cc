// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "core/materials/dictionary_file.h"
#include "tests/benchmarks/materials.h"

/// Sparse codes over the bundled dictionary. Floors to compare with: projectTable for encodeMaterial (which needs about
/// 30 of them) and invertTable for decodeCode.
namespace {

using namespace gonio;
using namespace gonio::dictionary;

const Ensemble& bundled() { return materials::bundledEnsemble()->ensemble; }

SparseCode plasticCode(std::size_t coefficients) {
  static const SparseCode code = Encoder(bundled()).encode(*benchmarks::plasticTable(), {.coefficients = 1024}).code;
  return code.truncated(coefficients);
}

/// RGB, both transforms, 32 dictionaries, 262 coefficients.
void encodeMaterial(benchmark::State& state) {
  const auto table = benchmarks::plasticTable();
  const Encoder encoder(bundled());
  for (auto _ : state) benchmark::DoNotOptimize(encoder.encode(*table));
}
BENCHMARK(encodeMaterial)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// One channel over one dictionary, all coefficients: three dense matrix products.
void projectTable(benchmark::State& state) {
  const Dictionary& dictionary = bundled().dictionaries.front();
  const ModeMatrices<float> matrices{dictionary.modes[0].cast<float>(), dictionary.modes[1].cast<float>(),
                                     dictionary.modes[2].cast<float>()};
  const Eigen::ArrayXf signal = Eigen::ArrayXf::Random(Eigen::Index(bundled().grid.size()));
  Workspace<float> workspace;
  for (auto _ : state)
    benchmark::DoNotOptimize(transposedModeProducts(signal.data(), modeSizes(bundled().grid), matrices, workspace));
}
BENCHMARK(projectTable)->Unit(benchmark::kMillisecond);

/// A code to a table in RGB.
void decodeCode(benchmark::State& state) {
  const SparseCode code = plasticCode(std::size_t(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(decode(bundled(), code));
}
BENCHMARK(decodeCode)->Arg(262)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// The inverse transform of three channels of a table, on one core.
void invertTable(benchmark::State& state) {
  const auto geometry = GridGeometry::of(bundled().grid);
  Eigen::ArrayXf signal = Eigen::ArrayXf::Random(Eigen::Index(bundled().grid.size())).abs();
  for (auto _ : state)
    for (int channel = 0; channel < 3; ++channel) {
      Eigen::ArrayXf values = signal;
      invertTransform(values, DataTransform::logPlus, geometry->weights);
      benchmark::DoNotOptimize(values.data());
    }
}
BENCHMARK(invertTable)->Unit(benchmark::kMillisecond);

/// Time of an item: of one pair, in RGB, on one core, straight from the code.
void evaluateCode(benchmark::State& state) {
  const auto brdf = makeCodeBrdf(bundled(), plasticCode(std::size_t(state.range(0))));
  const std::vector<DirectionPair> pairs = benchmarks::randomPairs(1 << 12);
  std::vector<Rgb> values(pairs.size());
  for (auto _ : state) {
    brdf->evaluate(pairs, values);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(int64_t(state.iterations()) * int64_t(pairs.size()));
}
BENCHMARK(evaluateCode)->Arg(64)->Arg(262)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
