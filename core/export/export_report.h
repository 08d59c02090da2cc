// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/rendering/rendered_comparison.h"

/// What the targets share: the measure of an export, and its text.
namespace gonio::exports {

/// The material in comparisonScene(), of the size and samples that the options ask for. @throws Cancelled.
RenderedComparison exportComparison(const ExportSource& source, const ExportOptions& options,
                                    const TaskControl& control);

/// Sets `brdf` and `snr`. @throws Cancelled.
void measureExport(MadeExport& made, std::shared_ptr<const Brdf> brdf, const RenderedComparison& comparison,
                   const TaskControl& control);

/// The origin with the accuracy: "chrome, exported by Gonio 1.0. ... Rendered SNR 31.2 dB (sphere-studio)."
std::string originText(const ExportSource& source, double snr);

/// The text as lines that begin with `mark` ("# ", "// "), whatever line ends it has; "\n" at its end.
std::string commentLines(const std::string& text, std::string_view mark);

/// A part of an export.
ExportPart textPart(std::string_view suffix, std::string_view text);

/// The sentence about an anisotropic material in a target that holds isotropic ones.
std::string meanAzimuthWarning();

}  // namespace gonio::exports
