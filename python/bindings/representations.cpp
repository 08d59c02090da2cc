// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "python/bindings/representations.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "core/baselines/baselines.h"
#include "core/brdf/weighted_sum.h"
#include "core/dictionary/decode.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/pdv_operations.h"
#include "core/formats/code.h"
#include "core/formats/pdv.h"
#include "core/study/picture_search.h"

namespace gonio::python {

namespace {

using namespace factorization;

constexpr std::array<std::string_view, 2> formNames{"2d", "3d"};  // in the order of PdvForm

DataTransform transformOf(const std::string& name) {
  const auto found = dataTransformNamed(name);
  if (!found) throw Error("transform: found '" + name + "', expected one of " + dataTransformList());
  return *found;
}

std::string nameOf(DataTransform transform) { return std::string(dataTransformNames[std::size_t(transform)]); }

PyFactors factorize(const PyMaterial& material, int terms, const std::string& form, const std::string& transform,
                    const std::string& weights, const std::vector<double>& deviationNodes, bool joint, bool compact,
                    const py::object& progress) {
  const auto chosen = std::ranges::find(formNames, form);
  if (chosen == formNames.end()) throw Error("form: found '" + form + "', expected 2d or 3d");
  const auto weighting = std::ranges::find(pdvWeightNames, weights);
  if (weighting == pdvWeightNames.end())
    throw Error("weights: found '" + weights + "', expected equal or projected-solid-angle");
  const PdvOptions options{.form = PdvForm(chosen - formNames.begin()),
                           .transform = transformOf(transform),
                           .terms = terms,
                           .weights = PdvWeights(weighting - pdvWeightNames.begin()),
                           .deviationNodes = deviationNodes,
                           .joint = joint};
  PdvFactorization found = resultOf(progress, [&](const TaskControl& control) {
    return factorizePdv(*material.table(control.between(0, 0.1)), compact ? compactPdvOptions(options) : options,
                        control.between(0.1, 1));
  });
  return {std::make_shared<const PdvFactors>(std::move(found.factors)), found.residuals, found.seconds};
}

/// The nodes of the bundled library if no materials are given.
py::array_t<double> publishedNodes(const std::vector<PyMaterialPtr>& given, const std::string& energyName,
                                   const py::object& progress) {
  const DataTransform transform = transformOf(energyName);
  if (transform != DataTransform::logPlus && transform != DataTransform::none)
    throw Error("energy: found '" + energyName + "', expected log-plus or none");
  if (given.empty()) return toArray(libraryDeviationNodes(transform));
  return toArray(resultOf(progress, [&](const TaskControl& control) {
    std::vector<double> sum;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto table = given[i]->table({control.stop, {}});
      const std::vector<double> energy = publishedDeviationEnergy(*table, {control.stop, {}}, transform);
      sum.resize(energy.size());
      std::ranges::transform(sum, energy, sum.begin(), std::plus());
      control.report(double(i + 1) / double(given.size()));
    }
    return deviationNodes(sum, defaultDeviations);
  }));
}

py::dict baselineReferences() {
  py::dict references;
  for (const baselines::Baseline& baseline : baselines::allBaselines())
    references[py::str(std::string(baseline.id))] = std::string(baseline.reference);
  return references;
}

py::tuple factorizeByBaseline(const PyMaterial& material, const std::string& method, std::size_t bytes,
                              const py::object& progress) {
  const baselines::Baseline& baseline = baselines::findBaseline(method);
  if (bytes == 0) throw Error("bytes: expected 1 or more");
  double seconds = 0;
  const baselines::ComparedModel model = resultOf(progress, [&](const TaskControl& control) {
    const auto table = meanOfOrders(material.table(control.between(0, 0.1)));
    const auto start = std::chrono::steady_clock::now();
    const std::array<std::size_t, 1> budgets{bytes};
    auto models = baseline.build(*table, budgets, control.between(0.1, 1));
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(models.front());
  });
  return py::make_tuple(newMaterial(material.shown().name, method, model.brdf), model.bytes, seconds);
}

using Curve = std::vector<double> PdvTerm::*;

/// The curves of all channels and terms: (3, terms, nodes).
py::array_t<double> curves(const PdvFactors& factors, Curve curve) {
  const std::size_t terms = std::size_t(factors.terms()),
                    nodes = terms > 0 ? (factors.channels[0][0].*curve).size() : 0;
  py::array_t<double> array({py::ssize_t(3), py::ssize_t(terms), py::ssize_t(nodes)});
  double* out = array.mutable_data();
  for (const auto& channel : factors.channels)
    for (const PdvTerm& term : channel) out = std::ranges::copy(term.*curve, out).out;
  return array;
}

void setCurves(PdvFactors& factors, Curve curve, const py::object& given, const char* name) {
  if (given.is_none()) return;
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>(given);
  const py::array_t<double> old = curves(factors, curve);
  if (array.ndim() != 3 || !std::equal(array.shape(), array.shape() + 3, old.shape()))
    throw Error(std::string(name) + ": expected the shape of the existing curves, (3, terms, nodes)");
  const double* values = array.data();
  if (!std::all_of(values, values + array.size(), [](double value) { return std::isfinite(value); }))
    throw Error(std::string(name) + ": found a value that is not finite");
  for (auto& channel : factors.channels)
    for (PdvTerm& term : channel)
      for (double& value : term.*curve) value = *values++;
}

PyFactors withCurves(const PyFactors& from, const py::object& f1, const py::object& f2, const py::object& f3) {
  PdvFactors factors = *from.factors;
  setCurves(factors, &PdvTerm::f1, f1, "f1");
  setCurves(factors, &PdvTerm::f2, f2, "f2");
  setCurves(factors, &PdvTerm::f3, f3, "f3");
  if (factors == *from.factors) return from;
  return {std::make_shared<const PdvFactors>(withRoomForEdits(factors)), {}, 0};
}

/// A sparse code and its dictionary.
struct PyCode {
  dictionary::SparseCode code;
  PyDictionaryPtr dictionary;
  dictionary::CodePrecision precision = dictionary::CodePrecision::quantised;  ///< of its file
  std::size_t bytes = 0;
  double seconds = 0;
  double renderedSnr = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> warnings = {};
};

PyDictionaryPtr orBundled(const PyDictionaryPtr& dictionary) {
  return dictionary ? dictionary : materials::bundledEnsemble();
}

dictionary::CodingMethod codingMethodOf(const std::string& name) {
  const auto found = std::ranges::find(dictionary::codingMethodNames, name);
  if (found == dictionary::codingMethodNames.end())
    throw Error("method: found '" + name + "', expected iterative-hard-thresholding or basis-pursuit");
  return dictionary::CodingMethod(found - dictionary::codingMethodNames.begin());
}

PyCode encodeSparsely(const PyMaterial& material, std::size_t coefficients, const PyDictionaryPtr& given,
                      const std::vector<std::string>& transforms, double gamma, std::optional<double> relativeError,
                      std::optional<std::size_t> bytes, std::optional<double> renderedSnr, const std::string& method,
                      bool asPublished, const py::object& progress) {
  dictionary::EncodeOptions options = asPublished ? dictionary::publishedEncodeOptions() : dictionary::EncodeOptions();
  options.coefficients = coefficients;
  options.relativeError = relativeError;
  options.gamma = gamma;
  options.method = codingMethodOf(method);
  options.quantised = !asPublished || bytes;
  if (asPublished && options.method != dictionary::CodingMethod::iterativeHardThresholding)
    throw Error("method: found '" + method + "', expected none because as_published projects once");
  if (bytes) options.bytes = *bytes - std::min(*bytes, formats::codeHeaderBytes);
  options.transforms.clear();
  for (const std::string& transform : transforms) options.transforms.push_back(transformOf(transform));
  return resultOf(progress, [&](const TaskControl& control) {
    PyCode result{
        .code = {},
        .dictionary = !given && asPublished ? materials::publishedEnsemble() : orBundled(given),
        .precision = options.quantised ? dictionary::CodePrecision::quantised : dictionary::CodePrecision::single};
    const auto table = material.table(control.between(0, 0.1));
    const auto& ensemble = result.dictionary->ensemble;
    auto sampled = dictionary::onCodeGrid(table, ensemble, {control.stop, {}});
    if (asPublished) sampled = meanOfOrders(sampled);
    const dictionary::Encoder encoder(ensemble);
    dictionary::EncodeResult encoded;
    if (renderedSnr) {
      auto found =
          study::encodeForPictures(encoder, *material.brdf(), *sampled, *renderedSnr, options, control.between(0.1, 1));
      encoded = std::move(found.encoded);
      result.renderedSnr = found.renderedSnr;
    } else {
      encoded = encoder.encode(*sampled, options, control.between(0.1, 1));
    }
    // The coefficients as in the file.
    const auto file = formats::encodeCode(encoded.code, result.dictionary->id, result.precision);
    result.code = formats::readCode(io::MemorySource(file)).code;
    result.bytes = file.size();
    result.seconds = encoded.seconds;
    result.warnings = dictionary::lostPeaks(*sampled, *dictionary::decode(ensemble, result.code));
    return result;
  });
}

PyCode readCode(const std::string& path, const PyDictionaryPtr& given) {
  const formats::CodeFile file = formats::readCode(path);
  PyCode result{.code = file.code, .dictionary = given, .precision = file.precision};
  if (given)
    formats::checkDictionary(file, *given);
  else
    result.dictionary = formats::bundledDictionaryOf(file);
  result.bytes = formats::encodeCode(file.code, file.dictionaryId, file.precision).size();
  return result;
}

PyMaterialPtr decodeCode(const PyCode& code, bool asTable, const std::string& name) {
  if (asTable) return newMaterial(name, "code", dictionary::decode(code.dictionary->ensemble, code.code));
  return newMaterial(name, "code", dictionary::makeCodeBrdf(code.dictionary->ensemble, code.code));
}

/// [(dictionary, indices (n, 3) along phi_d, theta_d, theta_h, values (n,)) of each channel].
py::list coefficientsOf(const PyCode& code) {
  const auto sizes = dictionary::modeSizes(code.code.grid);
  py::list channels;
  for (const dictionary::ChannelCode& channel : code.code.channels) {
    const auto count = py::ssize_t(channel.coefficients.size());
    py::array_t<std::int64_t> indices({count, py::ssize_t(3)});
    py::array_t<float> values(count);
    std::int64_t* at = indices.mutable_data();
    for (std::size_t i = 0; i < channel.coefficients.size(); ++i) {
      const auto index = std::int64_t(channel.coefficients[i].index);
      *at++ = index % sizes[0];
      *at++ = index / sizes[0] % sizes[1];
      *at++ = index / sizes[0] / sizes[1];
      values.mutable_data()[i] = channel.coefficients[i].value;
    }
    channels.append(py::make_tuple(channel.dictionary, indices, values));
  }
  return channels;
}

/// The orthonormal matrices of a dictionary for phi_d, theta_d, theta_h; columns are atoms.
py::tuple atoms(const PyDictionaryPtr& named, std::size_t number) {
  if (number >= named->ensemble.dictionaries.size())
    throw Error("number: found " + std::to_string(number) + ", expected 0 to " +
                std::to_string(named->ensemble.dictionaries.size() - 1));
  const auto& modes = named->ensemble.dictionaries[number].modes;
  py::list result;
  for (const Eigen::MatrixXd& mode : modes) {
    const auto step = py::ssize_t(sizeof(double));
    // Eigen stores matrices column by column.
    result.append(py::array_t<double>({mode.rows(), mode.cols()}, {step, step * mode.rows()}, mode.data()));
  }
  return py::tuple(result);
}

void bindFactors(py::module_& module) {
  py::class_<PyFactors>(module, "Factors")
      .def_property_readonly("form", [](const PyFactors& f) { return formNames[std::size_t(f.factors->form)]; })
      .def_property_readonly("transform", [](const PyFactors& f) { return nameOf(f.factors->transform); })
      .def_property_readonly("terms", [](const PyFactors& f) { return f.factors->terms(); })
      .def_property_readonly("bytes", [](const PyFactors& f) { return formats::pdvFileBytes(*f.factors); })
      .def_property_readonly("residuals", [](const PyFactors& f) { return toArray(f.residuals); })
      .def_property_readonly("seconds", [](const PyFactors& f) { return f.seconds; })
      .def_property_readonly("theta_nodes", [](const PyFactors& f) { return toArray(f.factors->thetaNodes); })
      .def_property_readonly("deviation_nodes", [](const PyFactors& f) { return toArray(f.factors->deviationNodes); })
      .def_property_readonly("phi_nodes", [](const PyFactors& f) { return toArray(f.factors->phiNodes); })
      .def_property_readonly("f1", [](const PyFactors& f) { return curves(*f.factors, &PdvTerm::f1); })
      .def_property_readonly("f2", [](const PyFactors& f) { return curves(*f.factors, &PdvTerm::f2); })
      .def_property_readonly("f3", [](const PyFactors& f) { return curves(*f.factors, &PdvTerm::f3); })
      .def("with_curves", withCurves)
      .def("truncated",
           [](const PyFactors& f, int terms) {
             if (terms < 1 || terms > f.factors->terms())
               throw Error("terms: expected a number from 1 to " + std::to_string(f.factors->terms()));
             return PyFactors{std::make_shared<const PdvFactors>(f.factors->truncated(terms)), f.residuals, f.seconds};
           })
      .def("material",
           [](const PyFactors& f, const std::string& name) {
             const std::string warning = curveLimitWarning(*f.factors);
             return newMaterial(name, "PDV factors", makePdvBrdf(*f.factors), {},
                                warning.empty() ? std::vector<std::string>() : std::vector{"warning: " + warning});
           })
      .def("save", [](const PyFactors& f, const std::string& path) { formats::writePdv(*f.factors, path); });
  module.def("factorize", factorize);
  module.def("published_deviation_nodes", publishedNodes);
  module.def("factorize_baseline", factorizeByBaseline);
  module.def("baselines", baselineReferences);
  module.def("read_factors", [](const std::string& path) {
    return PyFactors{std::make_shared<const PdvFactors>(formats::readPdv(path)), {}, 0};
  });
}

}  // namespace

void bindRepresentations(py::module_& module) {
  bindFactors(module);
  py::class_<materials::NamedEnsemble, std::shared_ptr<materials::NamedEnsemble>>(module, "Dictionary")
      .def("__len__", [](const materials::NamedEnsemble& d) { return d.ensemble.dictionaries.size(); })
      .def_property_readonly("id", [](const materials::NamedEnsemble& d) { return d.id; })
      .def_property_readonly("bytes", [](const materials::NamedEnsemble& d) { return d.ensemble.bytes(); })
      .def_property_readonly("learned_from",
                             [](const materials::NamedEnsemble& d) { return toTexts(d.ensemble.learnedFrom); })
      .def_property_readonly("grid",
                             [](const materials::NamedEnsemble& d) {
                               const HalfDifferenceGrid& grid = d.ensemble.grid;
                               return py::make_tuple(grid.thetaHCount, grid.thetaDCount, grid.phiDCount);
                             })
      .def("atoms",
           [](const std::shared_ptr<materials::NamedEnsemble>& d, std::size_t number) { return atoms(d, number); });
  module.def(
      "dictionary",
      [](const std::string& path) {
        return std::const_pointer_cast<materials::NamedEnsemble>(path.empty() ? materials::bundledEnsemble()
                                                                              : materials::readDictionary(path));
      },
      py::call_guard<py::gil_scoped_release>());
  py::class_<PyCode>(module, "Code")
      .def_property_readonly("transform", [](const PyCode& c) { return nameOf(c.code.transform); })
      .def_property_readonly("scaled", [](const PyCode& c) { return c.code.scaled; })
      .def_property_readonly("count", [](const PyCode& c) { return c.code.coefficients(); })
      .def_readonly("bytes", &PyCode::bytes)
      .def_readonly("seconds", &PyCode::seconds)
      .def_readonly("rendered_snr", &PyCode::renderedSnr)
      .def_property_readonly("warnings", [](const PyCode& c) { return toTexts(c.warnings); })
      .def_property_readonly(
          "dictionary", [](const PyCode& c) { return std::const_pointer_cast<materials::NamedEnsemble>(c.dictionary); })
      .def_property_readonly("channels", coefficientsOf)
      .def("material", decodeCode, py::call_guard<py::gil_scoped_release>())
      .def("save", [](const PyCode& c, const std::string& path) {
        formats::writeCode(c.code, c.dictionary->id, path, c.precision);
      });
  using Given = std::shared_ptr<materials::NamedEnsemble>;
  module.def("encode", [](const PyMaterial& material, std::size_t coefficients, const Given& dictionary,
                          const std::vector<std::string>& transforms, double gamma, std::optional<double> relativeError,
                          std::optional<std::size_t> bytes, std::optional<double> renderedSnr,
                          const std::string& method, bool asPublished, const py::object& progress) {
    return encodeSparsely(material, coefficients, dictionary, transforms, gamma, relativeError, bytes, renderedSnr,
                          method, asPublished, progress);
  });
  module.def("read_code", [](const std::string& path, const Given& dictionary) { return readCode(path, dictionary); });
}

}  // namespace gonio::python
