// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/export_source.h"

#include "app/goniotool/materials.h"
#include "app/goniotool/outputs.h"
#include "core/export/export_origin.h"
#include "core/export/spectral_edit.h"

namespace gonio::tool {

OpenedSource openForExport(const std::string& argument, const TaskControl& control) {
  editing::EditedMaterial edited = editing::openWithEdits(argument, control);
  OpenedSource opened{.base = edited.base, .edits = edited.edits, .files = editing::filesOf(argument)};
  opened.material = exports::exportSource(edited.shown.name, edited.base, edited.shown.brdf, edited.edits);
  return opened;
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
    edited = editing::applyEdits(file->withIncident(IncidentDirection::viewer), opened.edits);
  return exports::atWavelength(*file, edited.get(), nanometres, control);
}

}  // namespace gonio::tool
