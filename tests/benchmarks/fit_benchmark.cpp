// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include "core/fitting/fit.h"
#include "core/materials/material.h"

using namespace gonio;

namespace {

/// A full table that none of the models but SGD explains, and SGD must search for.
std::shared_ptr<const TabulatedBrdf> table() {
  static const auto baked = materials::readMaterial("library:sgd/alum-bronze").tabulated();
  return baked;
}

/// The plain baseline: one evaluation of GGX at every cell of the table and the sums of all metrics.
void fitPlainBaseline(benchmark::State& state) {
  const models::Model& ggx = models::findModel("ggx");
  const auto brdf = ggx.instantiate(models::defaultParameters(ggx.spec()));
  table();
  for (auto _ : state) benchmark::DoNotOptimize(metrics::brdfErrors(*table(), *brdf));
}
BENCHMARK(fitPlainBaseline)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Each under 3 s on 2 cores.
void fitModel(benchmark::State& state, const models::Model* model) {
  table();
  for (auto _ : state) benchmark::DoNotOptimize(fitting::fit(*table(), *model));
}

const bool fitsAreRegistered = [] {
  for (const models::Model* model : models::allModels())
    benchmark::RegisterBenchmark(("fitModel/" + std::string(model->spec().id)).c_str(), fitModel, model)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  return true;
}();

}  // namespace
