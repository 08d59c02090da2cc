// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies scale COUNT [STEP ...]: time and largest memory of what learns from COUNT materials. Steps: components
// (240 principal components), selection (20 samples by SOMP over all signals; with the components), dictionaries (the
// shared subspace, one round of one ensemble, and the last sweep); without a name the first two. The materials are
// blends of two of 24 near-measured copies, rho = a^t b^(1 - t) with the colour channels in another order, made when
// they are asked for, so that reading files does not count.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "core/acquisition/sample_selection.h"
#include "core/dictionary/training.h"
#include "core/materials/bundled_library.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/studies/study_program.h"

namespace gonio::study::scale_study {
namespace {

constexpr std::size_t bases = 24;

std::vector<std::shared_ptr<const TabulatedBrdf>> baseTables() {
  std::vector<std::shared_ptr<const TabulatedBrdf>> result;
  for (const std::string& path : materials::libraryTrainingPaths()) {
    if (path.find("merl-copy") == std::string::npos) continue;
    result.push_back(materials::readLibraryMaterial(path).table);
    if (result.size() == bases) break;
  }
  return result;
}

class Blends {
 public:
  explicit Blends(std::vector<std::shared_ptr<const TabulatedBrdf>> tables) : tables_(std::move(tables)) {}

  std::shared_ptr<const TabulatedBrdf> operator()(std::size_t material) const {
    std::mt19937 generator{unsigned(material)};
    const TabulatedBrdf &a = *tables_[generator() % tables_.size()], &b = *tables_[generator() % tables_.size()];
    const float t = std::uniform_real_distribution<float>(0, 1)(generator);
    const int turn = int(generator() % 3);
    std::vector<TabulatedBrdf::Value> values(a.values().size());
    std::vector<std::uint8_t> valid(values.size());
    parallelForBlocks(values.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        valid[i] = a.valid()[i] && b.valid()[i];
        for (int c = 0; c < 3; ++c)
          values[i][c] = std::pow(std::max(a.values()[i][c], 0.f), t) *
                         std::pow(std::max(b.values()[i][(c + turn) % 3], 0.f), 1 - t);
      }
    });
    return std::make_shared<const TabulatedBrdf>(a.grid(), values, valid);
  }

 private:
  std::vector<std::shared_ptr<const TabulatedBrdf>> tables_;
};

double peakGigabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1e6;
}

class Step {
 public:
  explicit Step(const char* name) : name_(name) {}
  ~Step() {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
    std::printf("| %s | %.0f s | %.1f GB |\n", name_, time.count(), peakGigabytes());
    std::fflush(stdout);
  }

 private:
  const char* name_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

int run(int argumentCount, char** arguments) {
  if (argumentCount < 2) throw Error("usage: gonio_studies scale COUNT [components] [selection] [dictionaries]");
  const auto count = std::size_t(std::atoi(arguments[1]));
  std::vector<std::string> steps(arguments + 2, arguments + argumentCount);
  if (steps.empty()) steps = {"components", "selection"};
  const auto asked = [&](const char* step) { return std::ranges::find(steps, step) != steps.end(); };

  const Blends blends(baseTables());
  std::printf("%zu materials; %.1f GB before\n\n| step | time | largest memory so far |\n|---|---|---|\n", count,
              peakGigabytes());
  if (asked("components") || asked("selection")) {
    dictionary::PrincipalComponents basis;
    {
      const Step step("components");
      basis = dictionary::learnPrincipalComponents(count, blends, {.maxComponents = 240});
    }
    if (asked("selection")) {
      const Step step("selection");
      acquisition::selectSamples(basis, {.samples = 20});
    }
  }
  if (asked("dictionaries")) {
    const Step step("dictionaries");
    const dictionary::TrainingMaterials materials{std::vector<std::string>(count), blends(0)->grid(), blends};
    dictionary::train(materials, {.sparsities = {32}, .iterations = 1});
  }
  return 0;
}

GONIO_STUDY(run)

}  // namespace
}  // namespace gonio::study::scale_study
