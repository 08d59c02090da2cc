// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/figures/figure_drawing.h"

/// Figures as PDF and PNG, drawn by cairo.
namespace gonio::figures {

/// Measures text widths in a system font, as figurePdf() and figurePng() draw them. @param font family.
TextWidth cairoTextWidth(const std::string& font);

/// A drawing as PDF, with embedded fonts and pictures at full resolution. Equal drawings and fonts give equal bytes.
/// @throws Error that states cairo's reason.
std::vector<std::byte> figurePdf(const FigureDrawing& drawing);

/// A drawing as PNG, or its pixels. @param dotsPerInch resolution. @throws as figurePdf().
std::vector<std::byte> figurePng(const FigureDrawing& drawing, double dotsPerInch);
Raster figureRaster(const FigureDrawing& drawing, double dotsPerInch);

}  // namespace gonio::figures
