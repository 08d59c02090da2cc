// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/export_source.h"

#include "app/goniotool/materials.h"
#include "core/editing/blend_source.h"
#include "core/export/spectral_edit.h"
#include "core/io/atomic_file.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material_file.h"

namespace gonio::tool {

std::string editsText(const editing::EditList& edits) {
  std::string text;
  for (const editing::Edit& edit : edits) {
    if (!edit.enabled) continue;
    text += text.empty() ? "" : ", ";
    if (!edit.name.empty()) text += "\"" + edit.name + "\" ";
    if (const auto* change = std::get_if<editing::DifferentialEdit>(&edit.content))
      text += "change of " + std::string(change->model->spec().id) + " (" +
              std::string(editing::compositionIds[std::size_t(change->composition)]) + ")";
    else
      text += "factors";
  }
  return text.empty() ? "none" : text;
}

OpenedSource openForExport(const std::string& argument, const TaskControl& control) {
  const materials::Material material = openMaterial(argument, control);
  OpenedSource opened{{.name = material.name, .brdf = material.brdf}, material, {}, {}};
  if (isDocument(argument)) {
    const editing::EditDocument document = editing::readDocument(argument);
    opened.edits = document.edits;
    opened.base = editing::readSource(document, argument, control);
    if (editing::isIdentity(opened.edits)) opened.material.brdf = opened.base.brdf;
  }
  describeSource(opened.material, opened.base, editsText(opened.edits));
  if (!opened.base.source.path.native().starts_with(materials::libraryScheme)) opened.path = opened.base.source.path;
  return opened;
}

void describeSource(exports::ExportSource& source, const materials::Material& base, const std::string& edits) {
  source.origin = source.name + ", exported by Gonio " GONIO_VERSION ". Source: " + base.name + " (" +
                  base.source.format + "), SHA-256 " + base.source.sha256 + ". Edits: " + edits;
  if (const RglBrdf* rgl = base.brdf->asRgl()) {
    source.rgl = std::shared_ptr<const RglBrdf>(base.brdf, rgl);
    source.rglFile = materials::materialFile(base.source);
  }
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
