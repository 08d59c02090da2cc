// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <pybind11/stl.h>

#include "core/baselines/neural_fit.h"
#include "core/formats/neural.h"
#include "python/bindings/arrays.h"
#include "python/bindings/materials.h"
#include "python/bindings/task.h"

namespace gonio::python {

namespace {

using neural::NeuralFit;
using neural::NeuralFitOptions;

NeuralFit train(const PyMaterial& material, int steps, double learningRate, std::uint64_t seed,
                const py::object& progress) {
  const NeuralFitOptions options{.steps = steps, .learningRate = learningRate, .seed = seed};
  return resultOf(progress, [&](const TaskControl& control) {
    return neural::fitNeural(*material.table(control.between(0, 0.05)), options, control.between(0.05, 1));
  });
}

NeuralFit fromWeights(const std::vector<float>& weights) {
  const NeuralBrdf checked(weights);
  NeuralFit fit;
  std::copy(weights.begin(), weights.end(), fit.weights.begin());
  return fit;
}

NeuralFit readFile(const std::string& path) {
  const NeuralBrdf read = formats::readNeural(std::filesystem::path(path));
  NeuralFit fit;
  std::ranges::copy(read.weights(), fit.weights.begin());
  return fit;
}

}  // namespace

void bindNeural(py::module_& module) {
  py::class_<NeuralFit>(module, "NeuralFit")
      .def_property_readonly(
          "weights",
          [](const NeuralFit& fit) { return py::array_t<float>(py::ssize_t(fit.weights.size()), fit.weights.data()); })
      .def_property_readonly("losses", [](const NeuralFit& fit) { return toArray(fit.losses); })
      .def_readonly("seconds", &NeuralFit::seconds)
      .def("material",
           [](const NeuralFit& fit, const std::string& name) {
             return newMaterial(name, "neural BRDF", std::make_shared<const NeuralBrdf>(fit.weights));
           })
      .def("save", [](const NeuralFit& fit, const std::string& path) { formats::writeNeural(fit.weights, path); });
  module.attr("neural_bytes") = formats::neuralFileBytes;
  module.def("train_neural", train);
  module.def("neural_from_weights", fromWeights);
  module.def("read_neural", readFile);
}

}  // namespace gonio::python
