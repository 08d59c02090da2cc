// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
//
// gonio_studies uncertainty PLAN.csv MATERIAL...: whether the uncertainty of reconstructions is true. Materials that
// the basis beside the plan has not learned from are measured by the plan, without noise and with 10 %, and
// reconstructed. For each way the means over the materials: the error of the mapped values (root mean square over all
// cells), that of samples left out, the error over its deviation (root mean square; 1 would be true), and the fraction
// of the cells whose error is less than the deviation (0.68 of Gaussian errors).
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/acquisition/reconstruction.h"
#include "core/acquisition/sampling_plan.h"
#include "core/brdf/data_transform.h"
#include "core/materials/basis_file.h"
#include "core/materials/material.h"
#include "core/support/error.h"
#include "tests/studies/study_program.h"

namespace gonio::study::uncertainty_study {
using namespace gonio::acquisition;

namespace {

constexpr int all = 0, asSamples = -1;  // instead of a number of components

struct Way {
  const char* name;
  std::optional<double> ridge;
  int components;
  double noise;
  bool hasKnownNoise;
};
const Way ways[] = {{"ridge 40, as many components as samples", publishedRidge, asSamples, 0, false},
                    {"ridge auto, as many components as samples", std::nullopt, asSamples, 0, false},
                    {"ridge 40, all components", publishedRidge, all, 0, false},
                    {"ridge auto, all components", std::nullopt, all, 0, false},
                    {"ridge 40, all components, noise 10 %", publishedRidge, all, 0.1, false},
                    {"ridge 40, all components, noise 10 % stated", publishedRidge, all, 0.1, true},
                    {"ridge auto, all components, noise 10 %", std::nullopt, all, 0.1, false},
                    {"ridge auto, all components, noise 10 % stated", std::nullopt, all, 0.1, true}};

struct Figures {
  double error = 0, leftOut = 0, overDeviation = 0, within = 0;
};

Figures figuresOf(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan, const TabulatedBrdf& truth,
                  const Way& way) {
  MeasuredValues values = measure(truth, plan, {.relative = way.noise});
  if (!way.hasKnownNoise) values.noise.clear();
  const int components = way.components == asSamples ? int(plan.samples.size()) : way.components;
  const Reconstruction found = reconstruct(basis, plan, values, {.ridge = way.ridge, .components = components});
  const dictionary::MappedCells& m = basis.mapping;
  Figures sums;
  for (std::size_t i = 0; i < m.cells.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const auto mapped = [&](const TabulatedBrdf& table) {
        return logRelative(table.values()[m.cells[i]][channel], m.weights[i], m.reference[i]);
      };
      const double error = mapped(truth) - mapped(*found.table), deviation = found.standardDeviation[i];
      sums.error += error * error;
      sums.overDeviation += error * error / (deviation * deviation);
      sums.within += std::abs(error) < deviation;
    }
  const double count = 3 * double(m.cells.size());
  return {std::sqrt(sums.error / count), found.leaveOneOutError, std::sqrt(sums.overDeviation / count),
          sums.within / count};
}

int run(int count, char** arguments) {
  if (count < 3) throw Error("gonio_studies uncertainty PLAN.csv MATERIAL...");
  const SamplingPlan plan = acquisition::readPlan(arguments[1]);
  const auto basis = materials::readBasis(std::filesystem::path(arguments[1]).replace_extension(".basis"));
  std::vector<std::shared_ptr<const TabulatedBrdf>> tables;
  for (int i = 2; i < count; ++i) tables.push_back(meanOfOrders(materials::readMaterial(arguments[i]).tabulated()));
  std::printf(
      "| way | error | of samples left out | error / deviation | within one deviation |\n|---|---|---|---|---|\n");
  for (const Way& way : ways) {
    Figures means;
    for (const auto& table : tables) {
      const Figures one = figuresOf(basis->components, plan, *table, way);
      means.error += one.error / double(tables.size());
      means.leftOut += one.leftOut / double(tables.size());
      means.overDeviation += one.overDeviation / double(tables.size());
      means.within += one.within / double(tables.size());
    }
    std::printf("| %s | %.3f | %.3f | %.2f | %.2f |\n", way.name, means.error, means.leftOut, means.overDeviation,
                means.within);
    std::fflush(stdout);
  }
  return 0;
}

int study(int count, char** arguments) { return run(count, arguments); }

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::uncertainty_study
