// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_source.h"
#include "core/materials/material_formats.h"

namespace gonio::exports {

/// The file format of a material; MERL has two grids.
enum class MaterialForm {
  rgl,               ///< RGL; if the source is an RGL file, in its parameterisation, and spectral if that is spectral
  utia,              ///< UTIA `.bin`, only for UTIA files
  foldedTable,       ///< MERL, 90 x 90 x 180: reciprocal and isotropic
  wholeCircleTable,  ///< MERL, 90 x 90 x 360: isotropic; other programs that read MERL files do not support it
};

/// The forms in which a measurement can be written, the most accurate first.
std::vector<MaterialForm> formsOf(const Brdf& base);
materials::FormatId formatOf(MaterialForm form);
/// The form for the suffix of a name: `.bsdf`, `.bin` or `.binary`. @param table the grid for `.binary`. @throws Error
/// that names the file, for another suffix or one that cannot represent `base`.
MaterialForm formBySuffix(const std::filesystem::path& path, const Brdf& base,
                          MaterialForm table = MaterialForm::foldedTable);

struct FormFile {
  std::vector<std::byte> bytes;
  std::vector<std::string> losses;  ///< for the user: what the form does not represent; empty for the native form
};

/// The text for an anisotropic material in a table.
std::string azimuthLoss();

/// The bytes of a material's file. An unedited material in its own format gives its file unchanged, byte for byte. For
/// an edited RGL or UTIA file, the change of the edits is added to the values at the file's nodes; all other content is
/// copied.
/// @param base the material without edits, as it was read.
/// @param source the same material with edits: `brdf` is `base.brdf` if there are none, and a table if `base` is a
/// table; `rgl` and `rglFile` are set if `base` is an RGL file.
/// @throws Error if the form cannot represent `base`; Cancelled.
FormFile encodeMaterial(const ExportSource& source, const materials::Material& base, MaterialForm form,
                        const TaskControl& control = {});

/// Checks that the suffix of a name is that of a form: `.binary`, `.bsdf` or `.bin`. @param other another suffix that
/// the caller writes, for the message; empty if there is none. @throws Error that names the file and lists the
/// suffixes.
void checkFormSuffix(const std::filesystem::path& path, std::string_view other = {});
/// Whether the suffix of a name is that of a form other than a table (`.bsdf`, `.bin`).
bool isRglOrUtia(const std::filesystem::path& path);
/// Writes a material in such a form, atomically. @return FormFile::losses. @throws Error that names the file; as
/// encodeMaterial().
std::vector<std::string> writeRglOrUtia(const ExportSource& source, const materials::Material& base,
                                        const std::filesystem::path& path, const TaskControl& control = {});

/// Rendered SNR of a file from encodeMaterial() against the material in comparisonScene(), dB, larger is better;
/// +infinity for equal pictures. Takes a few seconds. @throws Cancelled.
double formSnr(const FormFile& file, const Brdf& material, const TaskControl& control = {});

}  // namespace gonio::exports
