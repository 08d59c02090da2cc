// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// gonio_studies export_targets MATERIAL ...: the rendered SNR that each target reaches which approximates a material,
// its median over the materials, and the seconds of an export.
#include <chrono>
#include <string>

#include "core/export/export_target.h"
#include "core/materials/material.h"
#include "core/study/study_record.h"
#include "tests/studies/study_program.h"

namespace gonio::study::export_targets_study {
namespace {

int study(int argumentCount, char** arguments) {
  constexpr const char* targets[] = {"blender", "principled",       "gltf",   "materialx",
                                     "openpbr", "standard-surface", "values", "glsl"};
  std::vector<std::vector<double>> ratios(std::size(targets)), seconds(std::size(targets));
  for (const char* target : targets) std::printf("| %s ", target);
  std::printf("| material\n");
  for (int i = 1; i < argumentCount; ++i) {
    const materials::EditedMaterial source = materials::unedited(materials::readMaterial(std::string(arguments[i])));
    for (std::size_t k = 0; k < std::size(targets); ++k) {
      const auto start = std::chrono::steady_clock::now();
      const auto made = exports::makeExport(*exports::findExportTarget(targets[k]), source);
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      ratios[k].push_back(made.snr);
      seconds[k].push_back(taken.count());
      std::printf("| %.1f ", made.snr);
      std::fflush(stdout);
    }
    std::printf("| %s\n", arguments[i]);
  }
  for (std::size_t k = 0; k < std::size(targets); ++k)
    std::printf("%-17s median %.1f dB, %.1f s\n", targets[k], quantile(ratios[k], 0.5), quantile(seconds[k], 0.5));
  return 0;
}

}  // namespace

GONIO_STUDY(study)

}  // namespace gonio::study::export_targets_study
