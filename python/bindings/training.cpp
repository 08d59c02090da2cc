// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include <algorithm>

#include "core/dictionary/training.h"
#include "core/documents/training_files.h"
#include "core/materials/dictionary_file.h"
#include "python/bindings/materials.h"
#include "python/bindings/representations.h"
#include "python/bindings/task.h"

namespace gonio::python {

namespace {

/// Relative squared errors before each round, one list per ensemble.
py::list trainDictionary(const std::vector<std::string>& sources, const std::string& out,
                         const std::vector<std::string>& excluded, int dictionaries, const std::vector<int>& sparsities,
                         int iterations, int passes, double tolerance, double subspaceLoss, bool asPublished,
                         std::uint64_t seed, const py::object& progress) {
  if (sparsities.empty()) throw Error("sparsities: found none, expected at least one");
  for (const auto& [name, value] : {std::pair("dictionaries", dictionaries), std::pair("iterations", iterations),
                                    std::pair("passes", passes), std::pair("sparsities", std::ranges::min(sparsities))})
    if (value < 1) throw Error(std::string(name) + ": found " + std::to_string(value) + ", expected 1 or more");
  dictionary::TrainingOptions options;
  options.dictionaries = dictionaries;
  options.sparsities = sparsities;
  options.signals.scaled = !asPublished;
  options.iterations = iterations;
  options.passes = passes;
  options.tolerance = tolerance;
  options.subspaceLoss = subspaceLoss;
  options.seed = seed;
  const auto result = resultOf(progress, [&](const TaskControl& control) {
    const std::vector<std::string> files = editing::trainingFiles(sources, excluded);
    auto trained = dictionary::train(editing::trainingMaterials(files, editing::trainingGrid(files)), options, control);
    if (trained.complete) materials::writeDictionary(trained.ensemble, out);
    return trained;
  });
  py::list errors;
  for (const std::vector<double>& ensemble : result.state.errors) errors.append(py::cast(ensemble));
  return errors;
}

}  // namespace

void bindTraining(py::module_& module) { module.def("train_dictionary", trainDictionary); }

}  // namespace gonio::python
