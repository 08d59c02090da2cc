// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <mutex>

#include "core/documents/open_material.h"
#include "core/rendering/render_material.h"
#include "python/bindings/arrays.h"

namespace gonio::python {

/// A material in Python. Immutable.
class PyMaterial {
 public:
  explicit PyMaterial(materials::EditedMaterial edited) : edited_(std::move(edited)) {}
  explicit PyMaterial(const materials::Material& material) : edited_(materials::unedited(material)) {}

  const materials::Material& shown() const { return edited_.shown; }
  const materials::Material& base() const { return edited_.base; }
  const materials::EditedMaterial& edited() const { return edited_; }
  const editing::EditList& edits() const { return edited_.edits; }
  const std::shared_ptr<const Brdf>& brdf() const { return edited_.shown.brdf; }
  std::shared_ptr<const TabulatedBrdf> table(const TaskControl& control) const {
    return edited_.shown.tabulated(control);
  }
  /// The material with a density for importance sampling, which is computed at the first call.
  std::shared_ptr<const rendering::RenderMaterial> rendered() const;

 private:
  materials::EditedMaterial edited_;
  mutable std::once_flag made_;
  mutable std::shared_ptr<const rendering::RenderMaterial> rendered_;
};
using PyMaterialPtr = std::shared_ptr<PyMaterial>;

/// A material without a file. @param kind MaterialSource::format, which is the file format of other materials.
PyMaterialPtr newMaterial(const std::string& name, const std::string& kind, std::shared_ptr<const Brdf> brdf,
                          const std::string& description = {}, const std::vector<std::string>& notes = {});
/// The same for a table.
PyMaterialPtr newMaterial(const std::string& name, const std::string& kind, std::shared_ptr<const TabulatedBrdf> table,
                          const std::string& description = {});

/// A dict {metric: error}. @param errors in the order of metrics::allBrdfMetrics().
py::dict errorsOf(const std::vector<double>& errors);

// Each adds the functions of one area to the module.
void bindMaterials(py::module_& module);
void bindModels(py::module_& module);
void bindEdits(py::module_& module);
void bindRepresentations(py::module_& module);
void bindNeural(py::module_& module);
void bindTraining(py::module_& module);
void bindAcquisition(py::module_& module);
void bindFactorMeasurement(py::module_& module);
void bindPhotographs(py::module_& module);
void bindPictures(py::module_& module);

}  // namespace gonio::python
