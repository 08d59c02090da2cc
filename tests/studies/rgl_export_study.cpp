// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies rgl_export [THETA_COUNT SIZE] [MATERIAL ...]: the rendered SNR of RGL files that are made of the
// library's near-measured copies, and the size that reaches 40 dB; where none does, the same of files that keep both
// sides of the plane of incidence.
#include <chrono>
#include <cstdlib>
#include <string>

#include "core/export/rgl_parameterisation.h"
#include "core/materials/material.h"
#include "core/study/evaluation_time.h"
#include "tests/studies/study_program.h"

namespace gonio::study::rgl_export_study {
namespace {

int study(int argumentCount, char** arguments) {
  exports::RglOptions options;
  int next = 1;
  if (argumentCount > 2 && std::isdigit(arguments[1][0])) {
    options.fixed = {std::size_t(std::atoi(arguments[1])), std::size_t(std::atoi(arguments[2]))};
    next = 3;
  }
  std::vector<std::string> names(arguments + next, arguments + argumentCount);
  if (names.empty())
    for (const materials::LibraryEntry& entry : materials::bundledLibrary())
      if (entry.id.starts_with("merl-copy/")) names.push_back("library:" + entry.id);
  std::vector<double> ratios;
  for (const std::string& name : names) {
    const materials::Material material = materials::readMaterial(name);
    const auto start = std::chrono::steady_clock::now();
    const auto file = exports::parameterise(*material.brdf, options);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%-44s %6.1f dB %3zu x %zu^2 %5.1f s", name.c_str(), file.snr, file.size.thetaCount, file.size.size,
                seconds.count());
    if (file.snr < options.snr) {
      exports::RglOptions bothSides = options;
      bothSides.bothSides = true;
      const auto other = exports::parameterise(*material.brdf, bothSides);
      std::printf(", both sides %.1f dB %3zu x %zu^2", other.snr, other.size.thetaCount, other.size.size);
    }
    std::printf("\n");
    std::fflush(stdout);
    ratios.push_back(file.snr);
  }
  std::printf("%zu materials: least %.1f, median %.1f dB\n", ratios.size(), quantile(ratios, 0), quantile(ratios, 0.5));
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::rgl_export_study
