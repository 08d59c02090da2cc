// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/surface_values.h"

namespace gonio::exports {

/// Writes the text of a file. @param origin the text from originText().
using SurfaceText = std::string (*)(const materials::EditedMaterial& source, const SurfaceValues& values,
                                    const std::string& origin);

/// The values as written to a file: layers without effect are set to 0, and the rotation is reduced to [0, pi), the
/// period of a grain.
SurfaceValues writtenValues(SurfaceValues values);

/// An export with one file, fitted by fitSurface(). @throws Cancelled.
ExportResult makeSurfaceExport(const SurfaceShader& shader, std::string_view suffix, SurfaceText text,
                               const materials::EditedMaterial& source, const ExportOptions& options,
                               const TaskControl& control);

/// A number with up to six significant digits: "0.25", "1e-05".
std::string decimalText(double number);
/// The channels with a separator, e.g. "0.8, 0.4, 0.1".
std::string colourText(const Rgb& colour, std::string_view separator = ", ");

}  // namespace gonio::exports
