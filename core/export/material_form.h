// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_source.h"
#include "core/materials/material_formats.h"

namespace gonio::exports {

/// What a material is written as: a file of a format, of which MERL has two grids.
enum class MaterialForm {
  rgl,               ///< RGL, in the parameterisation of the source where it is an RGL file; spectral where that is
  utia,              ///< UTIA `.bin`, of UTIA files
  foldedTable,       ///< MERL, 90 x 90 x 180: reciprocal and isotropic
  wholeCircleTable,  ///< MERL, 90 x 90 x 360: isotropic; other programs' readers of MERL files do not take it
};

/// The forms that a measurement can be written in, the one that keeps most of it first.
std::vector<MaterialForm> formsOf(const Brdf& base);
materials::FormatId formatOf(MaterialForm form);
/// The form that the suffix of a name stands for: `.bsdf`, `.bin`, `.binary` (`table` is which of the two grids).
/// @throws Error naming the file: of another suffix, or of one that cannot hold `base`.
MaterialForm formBySuffix(const std::filesystem::path& path, const Brdf& base,
                          MaterialForm table = MaterialForm::foldedTable);

struct FormFile {
  std::vector<std::byte> bytes;
  std::vector<std::string> losses;  ///< sentences for people: what the form cannot hold; of the source's own none
};

/// The sentence about an anisotropic material in a table.
std::string azimuthLoss();

/// A material as the bytes of a file. What was only read stays byte for byte in its own format; an edited RGL or UTIA
/// file has the values of its own nodes plus what the edits change there, and all else of it as it was.
/// @param base without edits, as it was read
/// @param source the same as it is shown: `brdf` is `base.brdf` where nothing is edited, and a table where a table was
/// edited; `rgl` and `rglFile` where `base` is an RGL file
/// @throws Error where the form does not hold `base`; Cancelled.
FormFile encodeMaterial(const ExportSource& source, const materials::Material& base, MaterialForm form,
                        const TaskControl& control = {});

/// Whether a name asks for a form that is no table (`.bsdf`, `.bin`).
bool isOwnForm(const std::filesystem::path& path);
/// Writes a material in such a form, atomically. Returns what it cannot hold. @throws Error naming the file; as
/// encodeMaterial().
std::vector<std::string> writeOwnForm(const ExportSource& source, const materials::Material& base,
                                      const std::filesystem::path& path, const TaskControl& control = {});

/// How far a file that encodeMaterial() made is from the material: rendered SNR in comparisonScene(), dB; +infinity for
/// equal pictures. Some seconds. @throws Cancelled.
double formError(const FormFile& file, const Brdf& material, const TaskControl& control = {});

}  // namespace gonio::exports
