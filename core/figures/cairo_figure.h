// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/figures/figure_drawing.h"

/// Drawings by cairo.
namespace gonio::figures {

/// Widths of texts in a font of the system: those of figurePdf() and figurePng().
TextWidth cairoTextWidth(const std::string& font);

/// A drawing as PDF, with its fonts embedded and its pictures at their own size; the same bytes for the same drawing
/// and the same fonts. @throws Error stating cairo's reason.
std::vector<std::byte> figurePdf(const FigureDrawing& drawing);

/// A drawing as PNG. @param dotsPerInch its resolution. @throws Error likewise.
std::vector<std::byte> figurePng(const FigureDrawing& drawing, double dotsPerInch);

}  // namespace gonio::figures
