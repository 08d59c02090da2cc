// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/rendering/rendered_comparison.h"

/// Functions that the targets share: measuring the accuracy of an export, and texts.
namespace gonio::exports {

/// Renders `brdf` and sets the members `brdf` and `snr` of the export. @throws Cancelled.
void measureExport(ExportResult& made, std::shared_ptr<const Brdf> brdf, const RenderedComparison& comparison,
                   const TaskControl& control);

/// The origin with the accuracy: "chrome, exported by Gonio 1.0. ... Rendered SNR 31.2 dB (comparison scene)."
std::string originText(const materials::EditedMaterial& source, double snr);

/// A text file as a part of an export.
ExportPart textPart(std::string_view suffix, std::string_view text);

/// The warning for an anisotropic material in a target of isotropic materials.
std::string meanAzimuthWarning();

}  // namespace gonio::exports
