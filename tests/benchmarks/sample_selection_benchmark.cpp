// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "core/acquisition/sample_selection.h"
#include "core/materials/material.h"
#include "tests/benchmarks/materials.h"
#include "tests/core/acquisition/selection_test_support.h"

/// Choosing the directions of a measurement over principal components of 137 materials, 1.1 million cells. The
/// materials are the .binary files below the folder that the environment names in GONIO_BENCHMARK_MATERIALS, else
/// analytic ones of random parameters.
namespace {

using namespace gonio;
using namespace gonio::acquisition;
using Clock = std::chrono::steady_clock;

constexpr std::size_t syntheticMaterials = 137;
constexpr int maxComponents = 60;

std::vector<std::filesystem::path> trainingFiles() {
  std::vector<std::filesystem::path> files;
  const char* folder = std::getenv("GONIO_BENCHMARK_MATERIALS");
  if (!folder) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".binary") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::shared_ptr<const TabulatedBrdf> syntheticMaterial(std::size_t index) {
  std::mt19937_64 random(index);
  std::uniform_real_distribution<double> uniform(0, 1);
  const models::Model* const families[] = {&models::ggx(), &models::ward(), &models::abc(), &models::cookTorrance()};
  const models::Model& model = *families[index % std::size(families)];
  models::ParameterValues parameters = models::defaultParameters(model.spec());
  for (std::size_t i = 0; i < parameters.values.size(); ++i) {
    const models::ParameterSpec& spec = model.spec().parameters[i];
    if (!spec.choices.empty()) continue;
    Rgb fractions(uniform(random));
    if (spec.perChannel) fractions = {uniform(random), uniform(random), uniform(random)};
    parameters.values[i] = spec.softMin + (spec.softMax - spec.softMin) * fractions;
  }
  return bakeTable(*model.instantiate(parameters));
}

/// The basis, the seconds that its materials took to be read, and those for all.
struct Training {
  dictionary::PrincipalComponents basis;
  std::size_t materials;
  double readSeconds = 0, seconds = 0;

  explicit Training(int components) {
    const auto files = trainingFiles();
    materials = files.empty() ? syntheticMaterials : files.size();
    const auto start = Clock::now();
    basis = dictionary::learnPrincipalComponents(
        materials,
        [&](std::size_t i) {
          const auto begin = Clock::now();
          auto table = files.empty() ? syntheticMaterial(i) : materials::readMaterial(files[i]).table;
          readSeconds += std::chrono::duration<double>(Clock::now() - begin).count();
          return table;
        },
        {.maxComponents = components});
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
};

const dictionary::PrincipalComponents& trainedBasis() {
  static const Training training(maxComponents);
  return training.basis;
}

/// Reading or computing the materials is reported separately; the peak is that of the process so far.
void learnFromMaterials(benchmark::State& state) {
  for (auto _ : state) {
    const Training training(int(state.range(0)));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["materials"] = double(training.materials);
    state.counters["components"] = training.basis.count();
    state.counters["readSeconds"] = training.readSeconds;
    state.counters["otherSeconds"] = training.seconds - training.readSeconds;
    state.counters["peakGB"] = double(usage.ru_maxrss) * 1024 / 1e9;
  }
}
BENCHMARK(learnFromMaterials)->Arg(60)->Arg(411)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

/// So that the two ways can be seen to choose the same.
double checksum(const std::vector<std::uint32_t>& cells) {
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) sum += double(i + 1) * cells[i];
  return sum;
}

void select(benchmark::State& state, SelectionMethod method) {
  const dictionary::PrincipalComponents& basis = trainedBasis();
  SampleSelection selection;
  for (auto _ : state) selection = selectSamples(basis, {.method = method, .samples = int(state.range(0))});
  state.counters["cells"] = double(selection.cells.size());
  state.counters["checksum"] = checksum(selection.cells);
  state.counters["condition"] = selection.conditionNumber;
}

/// Algorithm 4 as it is written: all scores in double by a matrix product a block of atoms, on one thread.
std::vector<std::uint32_t> plainSelection(const dictionary::PrincipalComponents& basis, Eigen::Index count,
                                          Eigen::Index signals) {
  constexpr Eigen::Index block = 1024;
  const std::vector<std::uint32_t> cells = acquisition::test_support::measurableCells(basis, {});
  Eigen::MatrixXd atoms(count, Eigen::Index(cells.size()));
  for (Eigen::Index i = 0, row = 0; i < atoms.cols(); ++i, ++row) {
    while (basis.mapping.cells[std::size_t(row)] != cells[std::size_t(i)]) ++row;
    atoms.col(i) = basis.svd.u.view().row(row).head(count).transpose().cast<double>().cwiseQuotient(
        basis.svd.singularValues.head(count));
    atoms.col(i).normalize();
  }
  const Eigen::MatrixXd s = basis.svd.v.topLeftCorner(signals, count).transpose();
  Eigen::MatrixXd residual = s, support(count, 0), products;
  std::vector<std::uint32_t> chosen;
  while (Eigen::Index(chosen.size()) < count) {
    Eigen::Index best = 0;
    double most = -1;
    for (Eigen::Index begin = 0; begin < atoms.cols(); begin += block) {
      products.noalias() = residual.transpose() * atoms.middleCols(begin, std::min(block, atoms.cols() - begin));
      for (Eigen::Index i = 0; i < products.cols(); ++i) {
        const double score = products.col(i).lpNorm<1>();
        if (score <= most) continue;
        most = score;
        best = begin + i;
      }
    }
    support.conservativeResize(Eigen::NoChange, support.cols() + 1);
    support.rightCols<1>() = atoms.col(best);
    residual = s - support * support.householderQr().solve(s);
    chosen.push_back(cells[std::size_t(best)]);
  }
  return chosen;
}

void selectPlainly(benchmark::State& state, SelectionMethod method) {
  const dictionary::PrincipalComponents& basis = trainedBasis();
  const auto count = Eigen::Index(state.range(0));
  std::vector<std::uint32_t> cells;
  for (auto _ : state)
    cells = plainSelection(basis, count, method == SelectionMethod::simultaneousPursuit ? basis.svd.v.rows() : count);
  state.counters["cells"] = double(cells.size());
  state.counters["checksum"] = checksum(cells);
}

void sampleCounts(benchmark::internal::Benchmark* benchmark) {
  for (const int count : {5, 10, 20, 30, 40, 50, 60}) benchmark->Arg(count);
  benchmark->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK_CAPTURE(select, allSignals, SelectionMethod::simultaneousPursuit)->Apply(sampleCounts);
BENCHMARK_CAPTURE(select, firstColumns, SelectionMethod::simultaneousPursuitFirstColumns)->Apply(sampleCounts);
BENCHMARK_CAPTURE(select, conditionNumber, SelectionMethod::conditionNumber)->Apply(sampleCounts)->Iterations(1);
BENCHMARK_CAPTURE(selectPlainly, allSignals, SelectionMethod::simultaneousPursuit)->Apply(sampleCounts)->Iterations(1);
BENCHMARK_CAPTURE(selectPlainly, firstColumns, SelectionMethod::simultaneousPursuitFirstColumns)
    ->Apply(sampleCounts)
    ->Iterations(1);

}  // namespace
