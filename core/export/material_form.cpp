// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/material_form.h"

#include <algorithm>

#include "core/editing/edit.h"
#include "core/export/rgl_export.h"
#include "core/io/atomic_file.h"
#include "core/io/merl_file.h"
#include "core/io/utia_file.h"
#include "core/materials/material_file.h"
#include "core/rendering/rendered_comparison.h"

namespace gonio::exports {

namespace {

constexpr HalfDifferenceGrid wholeCircle{.phiDCount = 360, .reciprocal = false};

const UtiaBrdf* asUtia(const Brdf& base) { return dynamic_cast<const UtiaBrdf*>(&base); }

Direction utiaDirection(std::size_t index) {
  const std::size_t ring = index / UtiaBrdf::azimuthCount;
  return fromSpherical(UtiaBrdf::polarStep * double(ring),
                       UtiaBrdf::azimuthStep * double(index % UtiaBrdf::azimuthCount));
}

std::vector<glm::vec3> editedUtia(const UtiaBrdf& file, const Brdf& edited, const TaskControl& control) {
  const auto own = file.withIncident(IncidentDirection::viewer);
  std::vector<glm::vec3> values = *file.values();
  constexpr std::size_t side = UtiaBrdf::directionCount;
  std::vector<DirectionPair> pairs(side);
  std::vector<Rgb> before(side), after(side);
  for (std::size_t incident = 0; incident < side; ++incident) {
    control.throwIfStopped();
    for (std::size_t i = 0; i < side; ++i) pairs[i] = {utiaDirection(i), utiaDirection(incident)};
    own->evaluate(pairs, before);
    edited.evaluate(pairs, after);
    for (std::size_t i = 0; i < side; ++i)
      if (before[i] != after[i]) {
        glm::vec3& value = values[incident * side + i];
        value = glm::vec3(glm::max(Rgb(0), Rgb(value) + after[i] - before[i]));
      }
  }
  return values;
}

FormFile encodeUtiaForm(const ExportSource& source, const materials::Material& base, const TaskControl& control) {
  const UtiaBrdf* file = asUtia(*base.brdf);
  if (!file)
    throw Error(source.name +
                ": found a material that is not a UTIA file, expected one for .bin; choose another suffix, or export "
                "it with the target UTIA file (goniotool export --for utia)");
  return {io::encodeUtia(source.brdf == base.brdf ? *file->values() : editedUtia(*file, *source.brdf, control)), {}};
}

FormFile encodeRglForm(const ExportSource& source, const materials::Material& base, const TaskControl& control) {
  RglExport made = exportRgl(source, {}, control);
  const RglBrdf* file = base.brdf->asRgl();
  const bool spectral = file && file->tables()->data.spectra;
  FormFile result{spectral ? std::move(made.spectral) : std::move(made.rgb), {}};
  if (!file) result.losses.push_back("the material was resampled to the grid of an RGL file");
  if (made.clippedValues > 0)
    result.losses.push_back(std::to_string(made.clippedValues) + " negative values were set to 0");
  return result;
}

FormFile encodeTableForm(const ExportSource& source, const HalfDifferenceGrid& grid, const TaskControl& control) {
  const TabulatedBrdf* own = source.brdf->asTable();
  if (own && own->grid() == grid) return {io::encodeMerl(*own), {}};
  FormFile result{io::encodeMerl(*bakeTable(*source.brdf, grid, control, editing::bakedAzimuths)), {}};
  result.losses.push_back("the material was resampled to the grid of a table");
  if (!source.brdf->isIsotropic()) result.losses.push_back(azimuthLoss());
  if (grid.reciprocal && !source.brdf->isReciprocal())
    result.losses.push_back(
        "the material is not reciprocal: the table contains the mean of each value and the value "
        "with light and viewer exchanged");
  return result;
}

bool isTable(MaterialForm form) { return form == MaterialForm::foldedTable || form == MaterialForm::wholeCircleTable; }

HalfDifferenceGrid gridOf(MaterialForm form) {
  return form == MaterialForm::wholeCircleTable ? wholeCircle : HalfDifferenceGrid();
}

/// Whether the file that was read is already what is wanted.
bool isOwnFile(const ExportSource& source, const materials::Material& base, MaterialForm form) {
  if (source.brdf != base.brdf || base.source.format != materials::formatOf(formatOf(form)).name) return false;
  if (isTable(form)) return base.table && base.table->grid() == gridOf(form);
  return form == MaterialForm::utia && base.source.path.extension() == materials::formatOf(formatOf(form)).suffix();
}

}  // namespace

std::vector<MaterialForm> formsOf(const Brdf& base) {
  using enum MaterialForm;
  if (asUtia(base)) return {utia, rgl, wholeCircleTable, foldedTable};
  if (const TabulatedBrdf* table = base.asTable())
    return table->grid().reciprocal ? std::vector{foldedTable, wholeCircleTable, rgl}
                                    : std::vector{wholeCircleTable, foldedTable, rgl};
  return {rgl, wholeCircleTable, foldedTable};
}

materials::FormatId formatOf(MaterialForm form) {
  if (isTable(form)) return materials::FormatId::merl;
  return form == MaterialForm::utia ? materials::FormatId::utia : materials::FormatId::rgl;
}

MaterialForm formBySuffix(const std::filesystem::path& path, const Brdf& base, MaterialForm table) {
  const std::string suffix = path.extension().string();
  for (const MaterialForm form : formsOf(base))
    if (materials::formatOf(formatOf(form)).suffix() == suffix) return isTable(form) ? table : form;
  const char* expected = asUtia(base) ? "'.bin', '.bsdf' or '.binary'" : "'.bsdf' or '.binary'";
  throw Error(path.string() + ": found the suffix '" + suffix + "', expected " + expected);
}

std::string azimuthLoss() {
  return "the material is anisotropic: the table contains its mean over " + std::to_string(editing::bakedAzimuths) +
         " azimuths";
}

FormFile encodeMaterial(const ExportSource& source, const materials::Material& base, MaterialForm form,
                        const TaskControl& control) {
  if (isOwnFile(source, base, form)) return {materials::materialFile(base.source), {}};
  if (form == MaterialForm::utia) return encodeUtiaForm(source, base, control);
  if (form == MaterialForm::rgl) return encodeRglForm(source, base, control);
  return encodeTableForm(source, gridOf(form), control);
}

void checkFormSuffix(const std::filesystem::path& path, std::string_view other) {
  if (isRglOrUtia(path) || materials::hasSuffixOf(materials::FormatId::merl, path)) return;
  const std::string suffixes = other.empty() ? ".binary or .bsdf" : ".binary, .bsdf or " + std::string(other);
  throw Error(path.string() + ": found the suffix '" + path.extension().string() + "', expected " + suffixes +
              " (for UTIA files also .bin)");
}

bool isRglOrUtia(const std::filesystem::path& path) {
  return path.extension() == materials::formatOf(materials::FormatId::rgl).suffix() ||
         path.extension() == materials::formatOf(materials::FormatId::utia).suffix();
}

std::vector<std::string> writeRglOrUtia(const ExportSource& source, const materials::Material& base,
                                        const std::filesystem::path& path, const TaskControl& control) {
  FormFile file = encodeMaterial(source, base, formBySuffix(path, *base.brdf), control);
  io::writeFileAtomically(path, file.bytes);
  return std::move(file.losses);
}

double formSnr(const FormFile& file, const Brdf& material, const TaskControl& control) {
  RenderOptions pictures;
  pictures.width = pictures.height = 128;
  pictures.samples = 64;
  const materials::Material written = materials::readMaterial(io::MemorySource(file.bytes), control.between(0, 0.1));
  const RenderedComparison comparison(material, pictures, control.between(0.1, 0.5));
  return comparison.signalToNoiseRatio(comparison.render(*written.brdf, control.between(0.5, 1)));
}

}  // namespace gonio::exports
