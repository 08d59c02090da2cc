// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_library.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/brdf/neural_brdf.h"
#include "core/io/csv_text.h"
#include "core/io/sha256.h"
#include "core/io/tensor_file.h"
#include "core/models/model.h"
#include "core/models/parameters_json.h"
#include "core/support/error.h"

extern "C" {
// The measured files one behind the other, with the borders between them, and NeuralBrdf::weightCount numbers per
// near-measured copy (bundled_files.S).
extern const std::byte* const gonioMeasuredFiles[];
extern const float gonioNearMeasured[];
}

namespace gonio::materials {

/// The list: CSV with the columns source, name, kind, rendered_snr (which may be empty).
std::string_view libraryListText();

namespace {

struct LibraryRow {
  std::string source, name;
  std::string kind;                   ///< "metal", "paint", ...
  std::optional<double> renderedSnr;  ///< against the measured file in comparisonScene(), dB; empty if unknown
};

/// All rows, parsed once.
const std::vector<LibraryRow>& libraryRows() {
  static const std::vector<LibraryRow> rows = [] {
    const io::CsvText csv = io::readCsvText(libraryListText());
    const std::size_t source = csv.requiredColumn("source"), name = csv.requiredColumn("name"),
                      kind = csv.requiredColumn("kind"), snr = csv.requiredColumn("rendered_snr");
    std::vector<LibraryRow> result;
    for (const io::CsvText::Row& row : csv.rows) {
      LibraryRow& read = result.emplace_back(LibraryRow{row.fields[source], row.fields[name], row.fields[kind], {}});
      if (!row.fields[snr].empty()) read.renderedSnr = csv.number(row, snr);
    }
    return result;
  }();
  return rows;
}

/// LibraryRow::kind of a material; empty if it is not listed.
std::string libraryKind(std::string_view source, std::string_view name) {
  const auto& rows = libraryRows();
  const auto found =
      std::ranges::find_if(rows, [&](const LibraryRow& row) { return row.source == source && row.name == name; });
  return found == rows.end() ? std::string() : found->kind;
}

std::string databaseOf(const std::string& source) {
  std::string name = source.substr(0, source.find('-'));
  std::ranges::transform(name, name.begin(), [](char c) { return char(c - 'a' + 'A'); });
  return name;
}

/// Columns of the table that are called otherwise than the parameter.
std::string columnOf(std::string_view parameterId, int channel) {
  const std::string name = parameterId == "diffuse"    ? "rhod"
                           : parameterId == "specular" ? "rhos"
                                                       : std::string(parameterId);
  return name + std::array{"_r", "_g", "_b"}[std::size_t(channel)];
}

}  // namespace

std::string MeasuredMaterial::description() const {
  return "measurement from the RGL database: " + io::TensorFile(io::MemorySource(file)).text("description");
}

std::string MeasuredMaterial::sha256() const { return io::sha256Hex(io::MemorySource(file)); }

const std::vector<MeasuredMaterial>& measuredMaterials() {
  static const std::vector<MeasuredMaterial> materials = [] {
    std::vector<MeasuredMaterial> result;
    for (const LibraryRow& row : libraryRows()) {
      if (row.source != rglSource) continue;
      const std::size_t i = result.size();
      result.push_back({row.name, {gonioMeasuredFiles[i], gonioMeasuredFiles[i + 1]}});
    }
    return result;
  }();
  return materials;
}

Material measuredMaterial(const MeasuredMaterial& measured) {
  Material material = readMaterial(io::MemorySource(measured.file));
  material.name = measured.name;
  material.source.description = measured.description();
  return material;
}

std::string NearMeasuredMaterial::description() const {
  std::string text = "near-measured copy of " + databaseOf(source) + " " + name +
                     ": neural fit of the measurement, Sztrajman et al. 2021";
  if (!renderedSnr) return text;
  char number[64];
  std::snprintf(number, sizeof number, "; rendered SNR against the measurement %.1f dB", *renderedSnr);
  return text + number;
}

std::string NearMeasuredMaterial::sha256() const { return io::sha256Hex(io::MemorySource(std::as_bytes(weights))); }

const std::vector<NearMeasuredMaterial>& nearMeasuredMaterials() {
  static const std::vector<NearMeasuredMaterial> materials = [] {
    std::vector<NearMeasuredMaterial> result;
    for (const LibraryRow& row : libraryRows()) {
      if (row.source != merlCopySource && row.source != rglCopySource && row.source != dtuCopySource) continue;
      const float* weights = gonioNearMeasured + result.size() * NeuralBrdf::weightCount;
      result.push_back({row.source, row.name, row.renderedSnr, {weights, NeuralBrdf::weightCount}});
    }
    return result;
  }();
  return materials;
}

bool isOriginalBundled(const NearMeasuredMaterial& copy) {
  return copy.source == rglCopySource &&
         std::ranges::any_of(measuredMaterials(), [&](const MeasuredMaterial& one) { return one.name == copy.name; });
}

Material nearMeasuredMaterial(const NearMeasuredMaterial& copy, const TaskControl& control) {
  Material material;
  material.name = copy.name;
  material.table = bakeTable(NeuralBrdf(copy.weights), {}, control);
  material.brdf = material.table;
  material.source.format = nearMeasuredFormat;
  material.source.sha256 = copy.sha256();
  material.source.description = copy.description();
  const HalfDifferenceGrid& grid = material.table->grid();
  material.source.grid = {grid.thetaHCount, grid.thetaDCount, grid.phiDCount};
  return material;
}

std::string SgdFit::description() const { return "SGD fit of MERL " + name + ", Bagher et al. 2012"; }

std::string SgdFit::sha256() const {
  return io::sha256Hex(std::string_view(models::parametersToJson(models::findModel("sgd").spec(), parameters).dump()));
}

std::vector<SgdFit> parseSgdTable(std::string_view text) {
  const models::ModelSpec& spec = models::findModel("sgd").spec();
  const io::CsvText csv = io::readCsvText(text);
  const std::size_t name = csv.requiredColumn("material");
  std::vector<SgdFit> fits;
  for (const io::CsvText::Row& row : csv.rows) {
    SgdFit& fit = fits.emplace_back(SgdFit{row.fields[name], {}});
    for (const models::ParameterSpec& parameter : spec.parameters) {
      Rgb& value = fit.parameters.values.emplace_back(0);
      for (int channel = 0; channel < 3; ++channel)
        value[channel] = csv.number(row, csv.requiredColumn(columnOf(parameter.id, channel)));
    }
  }
  return fits;
}

const std::vector<SgdFit>& sgdFits() {
  static const std::vector<SgdFit> fits = parseSgdTable(sgdTableCsv());
  return fits;
}

Material sgdMaterial(const SgdFit& fit) {
  Material material;
  material.name = fit.name;
  material.brdf = std::make_shared<const models::ModelBrdf>(models::findModel("sgd"), fit.parameters);
  material.source.format = sgdFormat;
  material.source.sha256 = fit.sha256();
  material.source.description = fit.description();
  return material;
}

namespace {

std::string idOf(std::string_view source, std::string_view name) {
  return std::string(source).append("/").append(name);
}
std::string idOf(const MeasuredMaterial& measured) { return idOf(rglSource, measured.name); }
std::string idOf(const NearMeasuredMaterial& copy) { return idOf(copy.source, copy.name); }
std::string idOf(const SgdFit& fit) { return idOf(sgdSource, fit.name); }

LibraryOrigin originOf(const MeasuredMaterial&) { return LibraryOrigin::measured; }
LibraryOrigin originOf(const NearMeasuredMaterial&) { return LibraryOrigin::nearMeasured; }
LibraryOrigin originOf(const SgdFit&) { return LibraryOrigin::publishedFit; }

/// Calls `visit` with each list of bundled materials.
template <class Visit>
void visitLists(const Visit& visit) {
  visit(measuredMaterials());
  visit(nearMeasuredMaterials());
  visit(sgdFits());
}

/// Calls `visit` with the bundled material of a path, if there is one.
template <class Visit>
void visitNamed(const std::string& path, const Visit& visit) {
  if (!path.starts_with(libraryScheme)) return;
  const std::string_view id = std::string_view(path).substr(libraryScheme.size());
  visitLists([&](const auto& list) {
    for (const auto& entry : list)
      if (idOf(entry) == id) visit(entry);
  });
}

Material materialOf(const MeasuredMaterial& measured, const TaskControl&) { return measuredMaterial(measured); }
Material materialOf(const NearMeasuredMaterial& copy, const TaskControl& control) {
  return nearMeasuredMaterial(copy, control);
}
Material materialOf(const SgdFit& fit, const TaskControl&) { return sgdMaterial(fit); }

}  // namespace

std::string_view libraryOriginName(LibraryOrigin origin) {
  constexpr std::string_view names[] = {"measured", "near-measured copy", "published fit"};
  return names[std::size_t(origin)];
}

const std::vector<LibraryEntry>& bundledLibrary() {
  static const std::vector<LibraryEntry> entries = [] {
    std::vector<LibraryEntry> result;
    visitLists([&](const auto& list) {
      for (const auto& entry : list) {
        const std::string id = idOf(entry);
        result.push_back({id, entry.name, entry.description(), originOf(entry),
                          libraryKind(std::string_view(id).substr(0, id.find('/')), entry.name)});
      }
    });
    return result;
  }();
  return entries;
}

std::string librarySha256(const std::string& path) {
  std::string found;
  visitNamed(path, [&](const auto& entry) { found = entry.sha256(); });
  return found;
}

std::vector<std::string> libraryTrainingPaths() {
  std::vector<std::string> paths;
  const auto add = [&paths](const auto& entry) { paths.push_back(std::string(libraryScheme) + idOf(entry)); };
  for (const MeasuredMaterial& measured : measuredMaterials()) add(measured);
  for (const NearMeasuredMaterial& copy : nearMeasuredMaterials())
    if (!isOriginalBundled(copy)) add(copy);
  return paths;
}

Material readLibraryMaterial(const std::string& path, const TaskControl& control) {
  std::optional<Material> found;
  visitNamed(path, [&](const auto& entry) { found = materialOf(entry, control); });
  if (!found)
    throw Error(path + ": no bundled material has this name; there are " + std::to_string(bundledLibrary().size()) +
                ", for example " + std::string(libraryScheme) + bundledLibrary().back().id);
  found->source.path = path;
  return std::move(*found);
}

std::vector<std::byte> bundledFile(const std::string& path) {
  const auto found = std::ranges::find_if(measuredMaterials(), [&](const MeasuredMaterial& measured) {
    return std::string(libraryScheme) + idOf(measured) == path;
  });
  if (found == measuredMaterials().end()) throw Error(path + ": this bundled material is computed and has no file");
  return {found->file.begin(), found->file.end()};
}

}  // namespace gonio::materials
