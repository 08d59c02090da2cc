// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/materials/material_formats.h"

/// The formats of materials: one file each, which recognises, reads and encodes the format and ends with its row of the
/// table. A new format is a file in this folder with a row, declared and listed here.
namespace gonio::formats {

using materials::MaterialFormat;

extern const MaterialFormat rglFormat, merlFormat, merlCircleFormat, utiaFormat, zemaxFormat, lightToolsFormat,
    astmFormat, goniophotometerFormat, refletFormat, altaFormat, curetFormat, pdvFormat, codeFormat, neuralFormat,
    radianceFormat, openMaterialFormat, speosFormat, csvFormat;

/// All rows, in the order of lists for people. Of formats with the same suffix, the first is written and names a
/// damaged file. The last one reports tables that no format accepts.
inline constexpr const MaterialFormat* allFormats[] = {
    &merlFormat, &merlCircleFormat,      &rglFormat,      &utiaFormat,         &zemaxFormat, &lightToolsFormat,
    &astmFormat, &goniophotometerFormat, &refletFormat,   &altaFormat,         &curetFormat, &pdvFormat,
    &codeFormat, &neuralFormat,          &radianceFormat, &openMaterialFormat, &speosFormat, &csvFormat};

}  // namespace gonio::formats
