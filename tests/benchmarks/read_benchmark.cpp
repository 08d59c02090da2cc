// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>

#include <filesystem>

#include "core/materials/material.h"
#include "tests/benchmarks/materials.h"
#include "tests/support/table_file.h"

using namespace gonio;

namespace {

/// A MERL file of 35 MB in the system's temporary folder, warm in its cache; removed at the end.
const std::filesystem::path& merlFile() {
  struct File {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "gonio_benchmark.binary";
    File() { test::writeTable(*benchmarks::plasticTable(), path); }
    ~File() {
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
    }
  };
  static const File file;
  return file.path;
}

/// The plain baseline: the file's bytes into memory.
void readPlainBaseline(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(io::FileSource(merlFile()).readAll());
}
BENCHMARK(readPlainBaseline)->Unit(benchmark::kMillisecond)->UseRealTime();

/// With conversion, validation and SHA-256. To stay within 3 times the baseline.
void readMerl(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(materials::readMaterial(merlFile()));
}
BENCHMARK(readMerl)->Unit(benchmark::kMillisecond)->UseRealTime();

void writeMerl(benchmark::State& state) {
  for (auto _ : state) test::writeTable(*benchmarks::plasticTable(), merlFile());
}
BENCHMARK(writeMerl)->Unit(benchmark::kMillisecond)->UseRealTime();

void bakeLibraryMaterial(benchmark::State& state) {
  const materials::Material material = materials::readMaterial("library:sgd/chrome");
  for (auto _ : state) benchmark::DoNotOptimize(material.tabulated());
}
BENCHMARK(bakeLibraryMaterial)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
