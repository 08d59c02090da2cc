// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/export_source.h"

#include "app/goniotool/materials.h"
#include "app/goniotool/outputs.h"
#include "core/documents/blend_source.h"
#include "core/export/export_origin.h"
#include "core/export/spectral_edit.h"
#include "core/io/atomic_file.h"
#include "core/materials/material_formats.h"

namespace gonio::tool {

OpenedSource openForExport(const std::string& argument, const TaskControl& control) {
  const materials::Material material = openMaterial(argument, control);
  OpenedSource opened{.base = material, .files = filesOf(argument)};
  std::shared_ptr<const Brdf> shown = material.brdf;
  if (isDocument(argument)) {
    const editing::EditDocument document = editing::readDocument(argument);
    opened.edits = document.edits;
    opened.base = editing::readSource(document, argument, control);
    if (editing::isIdentity(opened.edits)) shown = opened.base.brdf;
  }
  opened.material = exports::exportSource(material.name, opened.base, std::move(shown), opened.edits);
  return opened;
}

bool isOwnForm(const std::filesystem::path& out) {
  return out.extension() == materials::formatOf(materials::FormatId::rgl).suffix() ||
         out.extension() == materials::formatOf(materials::FormatId::utia).suffix();
}

std::vector<std::string> writeOwnForm(const exports::ExportSource& source, const materials::Material& base,
                                      const std::filesystem::path& out, const TaskControl& control) {
  const exports::MaterialForm form = exports::formBySuffix(out, *base.brdf);
  exports::FormFile file = exports::encodeMaterial(source, base, form, control);
  io::writeFileAtomically(out, file.bytes);
  return std::move(file.losses);
}

std::shared_ptr<const Brdf> openAtWavelength(const std::string& argument, double nanometres,
                                             const TaskControl& control) {
  if (nanometres == 0) return openMaterial(argument, control).brdf;
  const OpenedSource opened = openForExport(argument, control);
  const RglBrdf* file = opened.base.brdf->asRgl();
  if (!file || !file->tables()->data.spectra)
    throw Error(argument + ": found a material without spectra, expected a spectral RGL file for --wavelength");
  std::shared_ptr<const Brdf> edited;
  if (!editing::isIdentity(opened.edits))
    edited = editing::applyEdits(file->withIncident(IncidentSlot::viewer), opened.edits);
  return exports::atWavelength(*file, edited.get(), nanometres, control);
}

}  // namespace gonio::tool
