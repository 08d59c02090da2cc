// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>
#include <algorithm>

#include "core/baselines/neural_fit.h"
#include "core/dictionary/alternatives/patch_dictionary.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/training.h"
#include "core/formats/neural.h"
#include "core/materials/dictionary_file.h"
#include "core/study/training_files.h"
#include "python/bindings/arrays.h"
#include "python/bindings/materials.h"
#include "python/bindings/representations.h"
#include "python/bindings/task.h"

namespace gonio::python {

namespace {

using baselines::NeuralFit;
using baselines::NeuralFitOptions;

baselines::NeuralFit train(const PyMaterial& material, int steps, double learningRate, std::uint64_t seed,
                           const py::object& progress) {
  const baselines::NeuralFitOptions options{.steps = steps, .learningRate = learningRate, .seed = seed};
  return resultOf(progress, [&](const TaskControl& control) {
    return baselines::fitNeural(*meanOfOrders(material.table(control.between(0, 0.05))), options,
                                control.between(0.05, 1));
  });
}

baselines::NeuralFit fromWeights(const std::vector<float>& weights) {
  const NeuralBrdf checked(weights);
  baselines::NeuralFit fit;
  std::copy(weights.begin(), weights.end(), fit.weights.begin());
  return fit;
}

baselines::NeuralFit readFile(const std::string& path) {
  const NeuralBrdf read = formats::readNeural(std::filesystem::path(path));
  baselines::NeuralFit fit;
  std::ranges::copy(read.weights(), fit.weights.begin());
  return fit;
}

}  // namespace

void bindNeural(py::module_& module) {
  py::class_<baselines::NeuralFit>(module, "NeuralFit")
      .def_property_readonly("weights",
                             [](const baselines::NeuralFit& fit) {
                               return py::array_t<float>(py::ssize_t(fit.weights.size()), fit.weights.data());
                             })
      .def_property_readonly("losses", [](const baselines::NeuralFit& fit) { return toArray(fit.losses); })
      .def_readonly("seconds", &baselines::NeuralFit::seconds)
      .def("material",
           [](const baselines::NeuralFit& fit, const std::string& name) {
             return newMaterial(name, "neural BRDF", std::make_shared<const NeuralBrdf>(fit.weights));
           })
      .def("save",
           [](const baselines::NeuralFit& fit, const std::string& path) { formats::writeNeural(fit.weights, path); });
  module.attr("neural_bytes") = formats::neuralFileBytes;
  module.def("train_neural", train);
  module.def("neural_from_weights", fromWeights);
  module.def("read_neural", readFile);
}

namespace {

/// Relative squared errors before each round, one list per ensemble.
py::list trainDictionary(const std::vector<std::string>& sources, const std::string& out,
                         const std::vector<std::string>& excluded, int dictionaries, const std::vector<int>& sparsities,
                         int iterations, int passes, double tolerance, double subspaceLoss, bool asPublished,
                         bool normalised, const std::string& extended, std::uint64_t seed, const py::object& progress) {
  if (sparsities.empty()) throw Error("sparsities: found none, expected at least one");
  for (const auto& [name, value] : {std::pair("dictionaries", dictionaries), std::pair("iterations", iterations),
                                    std::pair("passes", passes), std::pair("sparsities", std::ranges::min(sparsities))})
    if (value < 1) throw Error(std::string(name) + ": found " + std::to_string(value) + ", expected 1 or more");
  dictionary::TrainingOptions options;
  options.dictionaries = dictionaries;
  options.sparsities = sparsities;
  options.signals.scaled = !asPublished;
  options.signals.normalised = normalised;
  options.iterations = iterations;
  options.passes = passes;
  options.tolerance = tolerance;
  options.subspaceLoss = subspaceLoss;
  options.seed = seed;
  const auto result = resultOf(progress, [&](const TaskControl& control) {
    const auto first = extended.empty() ? nullptr : materials::readDictionary(extended);
    const std::vector<std::string> files = study::trainingFiles(sources, excluded);
    const auto orders = asPublished ? study::TrainingOrders::mean : study::TrainingOrders::both;
    auto trained =
        dictionary::train(study::trainingMaterials(files, study::trainingGrid(files), orders), options, control);
    if (first) trained.ensemble = dictionary::joined(first->ensemble, trained.ensemble);
    if (trained.complete) materials::writeDictionary(trained.ensemble, out);
    return trained;
  });
  py::list errors;
  for (const std::vector<double>& ensemble : result.state.errors) errors.append(py::cast(ensemble));
  return errors;
}

PyPatchDictionaryPtr learnPatches(const std::vector<std::string>& sources, const std::vector<std::string>& excluded,
                                  const py::object& progress) {
  return resultOf(progress, [&](const TaskControl& control) {
    const std::vector<std::string> files = study::trainingFilesOrLibrary(sources, excluded);
    const auto training = study::trainingMaterials(files, study::trainingGrid(files));
    return std::make_shared<dictionary::PatchDictionary>(dictionary::learnPatchDictionary(training, {}, control));
  });
}

/// (decoded material, bytes of the code).
py::tuple encodePatches(const dictionary::PatchDictionary& patches, const PyMaterial& material,
                        std::size_t coefficients, const std::string& name, const py::object& progress) {
  const auto [code, table] = resultOf(progress, [&](const TaskControl& control) {
    const auto of =
        dictionary::encode(patches, *meanOfOrders(material.table({control.stop, {}})), coefficients, control);
    return std::pair(of, dictionary::decode(patches, of));
  });
  return py::make_tuple(newMaterial(name, "code of patches", table),
                        dictionary::packChannels(code, dictionary::CodePrecision::quantised).size());
}

py::array_t<float> patchAtoms(const dictionary::PatchDictionary& patches) {
  const Eigen::MatrixXf atoms = patches.atoms.matrix().cast<float>();
  const auto& [phi, thetaD, thetaH] = patches.patch;
  py::array_t<float> result({atoms.cols(), Eigen::Index(thetaH), Eigen::Index(thetaD), Eigen::Index(phi)});
  std::copy_n(atoms.data(), atoms.size(), result.mutable_data());
  return result;
}

}  // namespace

void bindTraining(py::module_& module) {
  module.def("train_dictionary", trainDictionary);
  py::class_<dictionary::PatchDictionary, PyPatchDictionaryPtr>(module, "PatchDictionary")
      .def_property_readonly("atoms", patchAtoms)
      .def_property_readonly("grid",
                             [](const dictionary::PatchDictionary& patches) {
                               const HalfDifferenceGrid& grid = patches.grid;
                               return py::make_tuple(grid.thetaHCount, grid.thetaDCount, grid.phiDCount);
                             })
      .def_property_readonly("training_set",
                             [](const dictionary::PatchDictionary& patches) { return toTexts(patches.learnedFrom); })
      .def_property_readonly("bytes", &dictionary::PatchDictionary::bytes)
      .def("encode", encodePatches);
  module.def("learn_patches", learnPatches);
}

}  // namespace gonio::python
