// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/surface_values.h"

namespace gonio::exports {

/// The text of a file. @param origin of originText().
using SurfaceText = std::string (*)(const ExportSource& source, const SurfaceValues& values, const std::string& origin);

/// The values as a file has them: layers without effect are 0, and the rotation is in [0, pi), of which more turns of a
/// grain mean the same.
SurfaceValues writtenValues(SurfaceValues values);

/// An export of one file, by fitSurface(). @throws Cancelled.
MadeExport makeSurfaceExport(const SurfaceShader& shader, std::string_view suffix, SurfaceText text,
                             const ExportSource& source, const ExportOptions& options, const TaskControl& control);

/// A number with six digits: "0.25", "1e-05".
std::string decimalText(double number);
/// "0.8, 0.4, 0.1" with any separator.
std::string colourText(const Rgb& colour, std::string_view separator = ", ");

}  // namespace gonio::exports
