// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/encode_patches.h"

#include <chrono>

#include "app/goniotool/factor_quality.h"
#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "core/brdf/weighted_sum.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/alternatives/patch_dictionary.h"
#include "core/metrics/brdf_metrics.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

int encodePatches(const PatchArguments& options, const Tool& tool) {
  if (!options.out.empty()) materials::checkWritableSuffix(options.out);
  const auto material = openMaterial(options.material, tool.control("reading"));
  auto start = Clock::now();
  const std::vector<std::string> files = study::trainingFilesOrLibrary(options.train, options.excluded);
  const auto training = study::trainingMaterials(files, study::trainingGrid(files));
  const auto patches = dictionary::learnPatchDictionary(
      training, {}, tool.control("learning from " + std::to_string(training.names.size()) + " materials"));
  tool.throwIfStopped();
  const double trainingSeconds = secondsSince(start);
  const auto table = onGrid(material.tabulated(tool.control("tabulating")), patches.grid, tool.control("sampling"));
  start = Clock::now();
  const dictionary::SparseCode code =
      dictionary::encode(patches, *table, options.coefficients, tool.control("encoding"));
  const double seconds = secondsSince(start);
  const auto decoded = dictionary::decode(patches, code);
  const auto [errors, snr] = brdfQuality(*material.brdf, *decoded);
  const std::size_t bytes = dictionary::packChannels(code, dictionary::CodePrecision::quantised).size();
  Json json{{"method", "k-svd"},
            {"materials", training.names.size()},
            {"atoms", patches.atoms.count()},
            {"trainingSeconds", trainingSeconds},
            {"coefficients", code.coefficients()},
            {"bytes", bytes},
            {"errors", errorsJson(errors)},
            {"brdfSnr", decibelsJson(snr)},
            {"seconds", seconds}};
  const std::string tableText = addTableQuality(json, *material.brdf, *table);
  std::string writtenText;
  if (!options.out.empty()) {
    const WrittenMaterial written = writeMaterial(material.name, decoded, options.out, tool);
    json["written"] = written.json();
    json["out"] = options.out;
    writtenText = written.text;
  }
  print(tool, json,
        std::to_string(patches.atoms.count()) + " atoms from " + std::to_string(training.names.size()) +
            " materials, learned in " + number(trainingSeconds) + " s\n" + std::to_string(code.coefficients()) +
            " coefficients per channel, " + std::to_string(bytes) + " bytes, BRDF SNR " + number(snr) + " dB, " +
            number(seconds) + " s\n" + errorsText(errors) + tableText + writtenText);
  return 0;
}

}  // namespace gonio::tool
