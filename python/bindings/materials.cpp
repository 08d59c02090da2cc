// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "python/bindings/materials.h"

#include <pybind11/stl.h>

#include <chrono>

#include "core/brdf/tabulated_brdf.h"
#include "core/coordinates/coordinate_systems.h"
#include "core/coordinates/grid_directions.h"
#include "core/documents/edit_document.h"
#include "core/materials/bundled_library.h"
#include "core/materials/encode.h"
#include "core/math/parallel.h"
#include "core/metrics/plausibility.h"
#include "core/sampling/directional_albedo.h"

namespace gonio::python {

std::shared_ptr<const rendering::RenderMaterial> PyMaterial::rendered() const {
  std::call_once(made_, [this] { rendered_ = std::make_shared<const rendering::RenderMaterial>(brdf()); });
  return rendered_;
}

PyMaterialPtr newMaterial(const std::string& name, const std::string& kind, std::shared_ptr<const Brdf> brdf,
                          const std::string& description, const std::vector<std::string>& notes) {
  materials::Material material;
  material.name = name;
  material.source.format = kind;
  material.source.description = description;
  material.source.notes = notes;
  material.brdf = std::move(brdf);
  return std::make_shared<PyMaterial>(material);
}

PyMaterialPtr newMaterial(const std::string& name, const std::string& kind, std::shared_ptr<const TabulatedBrdf> table,
                          const std::string& description) {
  materials::Material material;
  material.name = name;
  material.source.format = kind;
  material.source.description = description;
  material.source.grid = {table->grid().thetaHCount, table->grid().thetaDCount, table->grid().phiDCount};
  material.brdf = material.table = std::move(table);
  return std::make_shared<PyMaterial>(material);
}

namespace {

PyMaterialPtr open(const std::string& path, const py::object& progress) {
  return std::make_shared<PyMaterial>(
      resultOf(progress, [&](const TaskControl& control) { return documents::openWithEdits(path, control); }));
}

py::array_t<double> evaluate(const PyMaterial& material, const Vectors& wi, const Vectors& wo) {
  py::array_t<double> values = arrayLike(wi, 3);
  const auto out = reinterpret_cast<Rgb*>(values.mutable_data());
  forPairs(wi, wo, [&](std::size_t begin, std::span<const glm::dvec3> light, std::span<const glm::dvec3> viewer) {
    checkUnit(light, begin, "wi");
    checkUnit(viewer, begin, "wo");
    std::array<DirectionPair, pairBlock> pairs;
    for (std::size_t i = 0; i < light.size(); ++i) pairs[i] = {light[i], viewer[i]};
    material.brdf()->evaluate(std::span(pairs).first(light.size()), {out + begin, light.size()});
  });
  return values;
}

std::shared_ptr<const rendering::RenderMaterial> renderedOf(const PyMaterial& material) {
  const py::gil_scoped_release released;
  return material.rendered();
}

py::tuple sample(const PyMaterial& material, const Vectors& wo, const Vectors& u) {
  py::array_t<double> directions = arrayLike(wo, 3), densities = arrayLike(wo, 0);
  const auto wi = reinterpret_cast<Direction*>(directions.mutable_data());
  double* const pdf = densities.mutable_data();
  const auto rendered = renderedOf(material);
  forPairs(wo, u, [&](std::size_t begin, std::span<const glm::dvec3> viewer, std::span<const glm::dvec3> numbers) {
    checkUnit(viewer, begin, "wo");
    for (std::size_t i = 0; i < viewer.size(); ++i) {
      if (!(glm::all(glm::greaterThanEqual(numbers[i], glm::dvec3(0))) &&
            glm::all(glm::lessThan(numbers[i], glm::dvec3(1)))))
        throw Error("u: found a number outside [0, 1) in row " + std::to_string(begin + i));
      const DirectionSample drawn = viewer[i].z > 0 ? rendered->sample(viewer[i], numbers[i]) : DirectionSample();
      wi[begin + i] = drawn.wi;
      pdf[begin + i] = drawn.pdf;
    }
  });
  return py::make_tuple(directions, densities);
}

py::array_t<double> pdf(const PyMaterial& material, const Vectors& wi, const Vectors& wo) {
  py::array_t<double> densities = arrayLike(wi, 0);
  double* const out = densities.mutable_data();
  const auto rendered = renderedOf(material);
  forPairs(wi, wo, [&](std::size_t begin, std::span<const glm::dvec3> light, std::span<const glm::dvec3> viewer) {
    checkUnit(light, begin, "wi");
    checkUnit(viewer, begin, "wo");
    for (std::size_t i = 0; i < light.size(); ++i)
      out[begin + i] = isBelowHorizon(light[i]) || !(viewer[i].z > 0) ? 0 : rendered->pdf(light[i], viewer[i]);
  });
  return densities;
}

/// Time of the same evaluation in C++ alone, s, with the pairs already in contiguous memory: the baseline for the time
/// in Python.
double batchSeconds(const PyMaterial& material, const Vectors& wi, const Vectors& wo) {
  std::vector<DirectionPair> pairs(std::size_t(wi.size() / 3));
  forPairs(wi, wo, [&](std::size_t begin, std::span<const glm::dvec3> light, std::span<const glm::dvec3> viewer) {
    for (std::size_t i = 0; i < light.size(); ++i) pairs[begin + i] = {light[i], viewer[i]};
  });
  const py::gil_scoped_release released;
  const auto start = std::chrono::steady_clock::now();
  std::vector<Rgb> values(pairs.size());
  parallelForBlocks(pairs.size(), 4096, [&](std::size_t begin, std::size_t end) {
    material.brdf()->evaluate(std::span(pairs).subspan(begin, end - begin),
                              std::span(values).subspan(begin, end - begin));
  });
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// None if the material is not a table.
py::object tableView(const PyMaterial& material) {
  const auto& table = material.shown().table;
  if (!table) return py::none();
  const HalfDifferenceGrid& grid = table->grid();
  const std::vector<py::ssize_t> shape{grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  std::vector<py::ssize_t> values = shape;
  values.push_back(3);
  return py::make_tuple(view(reinterpret_cast<const float*>(table->values().data()), values, table),
                        view(table->valid().data(), shape, table, py::dtype::of<bool>()));
}

PyMaterialPtr tabulated(const PyMaterial& material, const py::object& progress) {
  const auto table = resultOf(progress, [&](const TaskControl& control) { return material.table(control); });
  // The result differs from the file, so the path and the hash are removed.
  materials::Material copy = material.shown();
  copy.source.path.clear();
  copy.source.sha256.clear();
  copy.source.format = "table";
  copy.brdf = copy.table = table;
  copy.source.grid = {table->grid().thetaHCount, table->grid().thetaDCount, table->grid().phiDCount};
  return std::make_shared<PyMaterial>(copy);
}

HalfDifferenceGrid gridOf(const std::array<int, 3>& shape, bool reciprocal) {
  for (const int count : shape)
    if (count < 1 || count > 4096)
      throw Error("found a grid with " + std::to_string(count) + " nodes along an axis, expected 1 to 4096");
  return {.thetaHCount = shape[0], .thetaDCount = shape[1], .phiDCount = shape[2], .reciprocal = reciprocal};
}

py::tuple gridDirections(const std::array<int, 3>& shape, bool reciprocal) {
  const HalfDifferenceGrid grid = gridOf(shape, reciprocal);
  const GridDirections directions(grid);
  const std::vector<py::ssize_t> cells{shape[0], shape[1], shape[2]};
  const std::vector<py::ssize_t> rows{shape[0], shape[1], shape[2], 3};
  py::array_t<double> wi(rows), wo(rows), measures(cells);
  py::array_t<bool> valid(cells);
  const auto light = reinterpret_cast<Direction*>(wi.mutable_data()),
             viewer = reinterpret_cast<Direction*>(wo.mutable_data());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const GridDirections::Node node = directions.at(i);
    light[i] = node.pair.wi;
    viewer[i] = node.pair.wo;
    valid.mutable_data()[i] = node.aboveHorizon;
    measures.mutable_data()[i] = grid.cellMeasure(i);
  }
  return py::make_tuple(wi, wo, valid, measures);
}

PyMaterialPtr fromTable(const py::array_t<float, py::array::c_style | py::array::forcecast>& values,
                        const py::object& valid, bool reciprocal, const std::string& name) {
  if (values.ndim() != 4 || values.shape(3) != 3)
    throw Error("values: expected an array of shape (theta_h, theta_d, phi_d, 3)");
  const HalfDifferenceGrid grid =
      gridOf({int(values.shape(0)), int(values.shape(1)), int(values.shape(2))}, reciprocal);
  std::vector<std::uint8_t> mask(grid.size());
  if (valid.is_none()) {
    for (std::size_t i = 0; i < grid.size(); ++i) mask[i] = grid.nodeAboveHorizon(i);
  } else {
    const auto given = py::array_t<bool, py::array::c_style | py::array::forcecast>(valid);
    if (given.ndim() != 3 || std::size_t(given.size()) != grid.size())
      throw Error(
          "valid: expected an array of shape (theta_h, theta_d, phi_d), the first three dimensions of the values");
    std::copy_n(given.data(), grid.size(), mask.begin());
  }
  const auto first = reinterpret_cast<const TabulatedBrdf::Value*>(values.data());
  return newMaterial(name, "table",
                     std::make_shared<const TabulatedBrdf>(grid, std::vector(first, first + grid.size()), mask));
}

/// A dict of the losses, one sentence each, and of the accuracies in dB.
py::dict save(const PyMaterial& material, const std::string& path, const py::object& progress) {
  materials::Encoded made;
  if (documents::isDocumentName(path)) {
    const materials::MaterialSource& source = material.base().source;
    if (source.sha256.empty() || source.path.empty())
      throw Error(path + ": a document stores the path of the edited file, but " + material.shown().name +
                  " has no file; save it as a table (.binary)");
    documents::EditDocument document;
    document.sourcePath = source.path.string();
    document.sourceSha256 = source.sha256;
    document.edits = material.edits();
    document.incident = material.edited().incident;
    documents::writeDocument(document, path);
  } else {
    materials::checkWritableSuffix(path, documents::documentSuffix);
    made = resultOf(progress, [&](const TaskControl& control) {
      return materials::writeMaterial(material.edited(), path, {}, control);
    });
  }
  py::dict result;
  result["losses"] = made.losses;
  result["snr"] = made.snr;
  result["brdf_snr"] = made.brdfSnr;
  return result;
}

py::dict statistics(const PyMaterial& material, const py::object& progress) {
  const auto found =
      resultOf(progress, [&](const TaskControl& control) { return tableStatistics(*material.table(control)); });
  py::list channels;
  for (const ChannelRange& range : found.channels) channels.append(py::make_tuple(range.min, range.max));
  py::dict result;
  result["channels"] = channels;
  result["invalid_fraction"] = found.invalidFraction;
  result["dynamic_range"] = found.dynamicRange;
  return result;
}

py::array_t<double> albedo(const PyMaterial& material, const std::vector<double>& angles) {
  const auto values = resultOf(py::none(), [&](const TaskControl& control) {
    std::vector<Rgb> result;
    const auto brdf = material.brdf();
    const DirectionalAlbedo albedoAt(*brdf);
    for (const double angle : angles) {
      control.throwIfStopped();
      result.push_back(albedoAt(angle));
    }
    return result;
  });
  return toArray(values);
}

py::list check(const PyMaterial& material, const py::object& progress) {
  const auto checks = resultOf(
      progress, [&](const TaskControl& control) { return metrics::checkPlausibility(*material.brdf(), control); });
  py::list list;
  for (const metrics::PlausibilityCheck& one : checks) {
    py::dict row;
    row["name"] = one.name;
    row["passed"] = one.passed;
    row["worst"] = one.worst;
    row["limit"] = one.limit;
    row["fraction"] = one.fraction;
    row["where"] = one.where;
    list.append(row);
  }
  return list;
}

/// The coordinates of each pair: shape (..., columns of the system).
py::array_t<double> toCoordinates(const std::string& name, const Vectors& wi, const Vectors& wo) {
  const CoordinateSystem& system = coordinateSystemNamed(name);
  const std::size_t columns = system.columns.size();
  py::array_t<double> result = arrayLike(wi, py::ssize_t(columns));
  double* const values = result.mutable_data();
  forPairs(wi, wo, [&](std::size_t begin, std::span<const glm::dvec3> lights, std::span<const glm::dvec3> viewers) {
    checkUnit(lights, begin, "wi");
    checkUnit(viewers, begin, "wo");
    for (std::size_t i = 0; i < lights.size(); ++i)
      std::ranges::copy(system.to({lights[i], viewers[i]}), values + (begin + i) * columns);
  });
  return result;
}

/// wi and wo, each (rows, 3), and whether a pair above the horizon has the coordinates. @param values (rows, columns).
py::tuple fromCoordinates(const std::string& name, const py::array_t<double, py::array::c_style>& values) {
  const CoordinateSystem& system = coordinateSystemNamed(name);
  const auto columns = py::ssize_t(system.columns.size());
  if (values.ndim() != 2 || values.shape(1) != columns)
    throw Error("values: expected " + std::to_string(columns) + " numbers in each row for " + name);
  const py::ssize_t rows = values.shape(0);
  std::vector<Rgb> wi, wo;
  py::array_t<bool> valid(rows);
  for (py::ssize_t row = 0; row < rows; ++row) {
    const auto pair = system.from({values.data(row, 0), std::size_t(columns)});
    valid.mutable_at(row) = pair.has_value();
    wi.push_back(pair ? pair->wi : Direction(0, 0, 1));
    wo.push_back(pair ? pair->wo : Direction(0, 0, 1));
  }
  return py::make_tuple(toArray(wi), toArray(wo), valid);
}

py::dict coordinateColumns() {
  py::dict result;
  for (const CoordinateSystem& system : coordinateSystems()) {
    py::list names;
    for (const CoordinateColumn& column : system.columns) names.append(column.name);
    result[py::str(std::string(system.id))] = py::tuple(names);
  }
  return result;
}

py::list library() {
  py::list list;
  for (const materials::LibraryEntry& entry : materials::bundledLibrary())
    list.append(py::make_tuple(std::string(materials::libraryScheme) + entry.id, entry.name, entry.description,
                               std::string(materials::libraryOriginName(entry.origin)), entry.kind));
  return list;
}

}  // namespace

void bindMaterials(py::module_& module) {
  py::class_<PyMaterial, PyMaterialPtr>(module, "Material")
      .def_property_readonly("name", [](const PyMaterial& m) { return toText(m.shown().name); })
      .def_property_readonly("format", [](const PyMaterial& m) { return m.shown().source.format; })
      .def_property_readonly("path", [](const PyMaterial& m) { return toPath(m.shown().source.path); })
      .def_property_readonly("sha256", [](const PyMaterial& m) { return m.shown().source.sha256; })
      .def_property_readonly("description", [](const PyMaterial& m) { return toText(m.shown().source.description); })
      .def_property_readonly("notes", [](const PyMaterial& m) { return toTexts(m.shown().source.notes); })
      .def_property_readonly("grid", [](const PyMaterial& m) { return py::tuple(py::cast(m.shown().source.grid)); })
      .def_property_readonly("is_isotropic", [](const PyMaterial& m) { return m.brdf()->isIsotropic(); })
      .def_property_readonly("is_reciprocal", [](const PyMaterial& m) { return m.brdf()->isReciprocal(); })
      .def_property_readonly("is_table", [](const PyMaterial& m) { return m.shown().table != nullptr; })
      .def_property_readonly("edit_count", [](const PyMaterial& m) { return m.edits().size(); })
      .def("evaluate", evaluate)
      .def("sample", sample)
      .def("pdf", pdf)
      .def("batch_seconds", batchSeconds)
      .def("table", tableView)
      .def("tabulated", tabulated)
      .def("save", save)
      .def("statistics", statistics)
      .def("albedo", albedo)
      .def("check", check);
  module.def("open", open);
  module.def("from_table", fromTable);
  module.def("grid_directions", gridDirections);
  module.def("to_coordinates", toCoordinates);
  module.def("from_coordinates", fromCoordinates);
  module.def("coordinates", coordinateColumns);
  module.def("library", library);
}

}  // namespace gonio::python
