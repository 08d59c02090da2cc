// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/reconstruct_in_dictionaries.h"

#include <chrono>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "core/acquisition/dictionary_reconstruction.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"
#include "core/materials/dictionary_file.h"
#include "core/study/training_files.h"

namespace gonio::tool {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int reconstructWithDictionaries(const DictionaryReconstructionRequest& request, const Tool& tool) {
  if (request.train.empty()) throw UsageError("reconstruct: --method dictionaries needs a training set (--train)");
  const acquisition::SamplingPlan plan = acquisition::readPlan(request.plan);
  const acquisition::MeasuredValues values = acquisition::readValues(request.values, plan);
  const auto dictionary =
      request.dictionary.empty() ? materials::bundledEnsemble() : materials::readDictionary(request.dictionary);
  const auto materials =
      study::trainingMaterials(study::trainingFiles(request.train, request.excluded), dictionary->ensemble.grid);
  auto start = std::chrono::steady_clock::now();
  const auto prior = acquisition::learnDictionaryPrior(
      dictionary->ensemble, materials, {},
      tool.control("learning from " + std::to_string(materials.names.size()) + " materials"));
  const double trainingSeconds = secondsSince(start);
  start = std::chrono::steady_clock::now();
  const auto found = acquisition::reconstructInDictionaries(dictionary->ensemble, prior, plan, values, {},
                                                            tool.control("reconstructing"));
  const double seconds = secondsSince(start);
  const WrittenMaterial written = writeMaterial("reconstruction", found.table, request.out, tool);
  const Json json{{"method", dictionariesMethod},
                  {"samples", plan.samples.size()},
                  {"dictionary", found.dictionary},
                  {"noise", found.noise},
                  {"logEvidence", found.logEvidence},
                  {"leaveOneOutError", decibelsJson(found.leaveOneOutError)},
                  {"seconds", seconds},
                  {"trainingSeconds", trainingSeconds},
                  {"written", written.json()},
                  {"out", request.out}};
  print(tool, json,
        request.out + ": from " + std::to_string(plan.samples.size()) + " samples, dictionary " +
            std::to_string(found.dictionary + 1) + " of " + std::to_string(dictionary->ensemble.dictionaries.size()) +
            ", " + number(seconds) + " s after " + number(trainingSeconds) + " s of learning\n" + written.text);
  return 0;
}

}  // namespace gonio::tool
