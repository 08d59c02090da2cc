// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>

#include "core/editing/edit.h"
#include "core/export/material_form.h"
#include "core/support/task_control.h"

namespace gonio::tool {

struct OpenedSource {
  exports::ExportSource material;
  materials::Material base;                  ///< without edits
  editing::EditList edits;                   ///< edits of a document
  std::vector<std::filesystem::path> files;  ///< files that must not be overwritten; none for a bundled material
};

/// Opens a material argument for an export, with a sentence on its origin and, for an RGL file, the bytes of the file.
/// @throws Error that names the file, as openMaterial().
OpenedSource openForExport(const std::string& argument, const TaskControl& control = {});

using exports::checkFormSuffix;
using exports::isRglOrUtia;
using exports::writeRglOrUtia;

/// The help of an option that names a material to write in any form.
inline std::string nativeFormHelp(const std::string& what) {
  return what + " (.binary, .bsdf; for UTIA files also .bin)";
}

/// Opens a material argument at one wavelength, nm, as three equal channels; 0: as openMaterial(). @throws Error that
/// names a file without spectra.
std::shared_ptr<const Brdf> openAtWavelength(const std::string& argument, double nanometres,
                                             const TaskControl& control = {});
inline constexpr const char* wavelengthHelp =
    "Wavelength in nm: use only this one of a spectral RGL file, as grey values (all wavelengths under D65)";

}  // namespace gonio::tool
