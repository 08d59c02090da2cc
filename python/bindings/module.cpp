// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/parallel.h"
#include "python/bindings/materials.h"

namespace gonio::python {

namespace {

/// Limits the number of threads of all parallel loops in the process; 0: one per core.
void setThreads(int count) {
  static std::optional<ThreadLimit> limit;
  if (count < 0) throw Error("threads: expected 1 or more, or 0 for all cores");
  limit.reset();
  if (count > 0) limit.emplace(count);
}

/// Makes gonio.Error of Error.
void translateErrors(py::module_& module) {
  static const py::exception<Error> type(module, "Error", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      PyErr_SetObject(type.ptr(), toText(error.what()).ptr());
    }
  });
}

}  // namespace

}  // namespace gonio::python

PYBIND11_MODULE(_core, module) {
  using namespace gonio::python;
  translateErrors(module);
  module.attr("version") = GONIO_VERSION;
  module.def("set_threads", setThreads);
  module.def("threads", gonio::threadCount);
  bindMaterials(module);
  bindModels(module);
  bindEdits(module);
  bindRepresentations(module);
  bindNeural(module);
  bindTraining(module);
  bindAcquisition(module);
  bindFactorMeasurement(module);
  bindPhotographs(module);
  bindPictures(module);
}
