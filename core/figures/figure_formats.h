// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/figures/figure_layout.h"
#include "core/figures/figure_measurement.h"

namespace gonio::figures {

/// Measures text widths in a system font, as figurePdf() and figurePng() draw them. @param font family.
TextWidth cairoTextWidth(const std::string& font);

/// A drawing as PDF, with embedded fonts and pictures at full resolution. Equal drawings and fonts give equal bytes.
/// @throws Error that states cairo's reason.
std::vector<std::byte> figurePdf(const FigureDrawing& drawing);

/// A drawing as PNG, or its pixels. @param dotsPerInch resolution. @throws as figurePdf().
std::vector<std::byte> figurePng(const FigureDrawing& drawing, double dotsPerInch);
Raster figureRaster(const FigureDrawing& drawing, double dotsPerInch);

/// A drawing as SVG, in mm, with pictures embedded as PNG and texts as text elements, so that they can be edited (cairo
/// writes outlines).
std::string figureSvg(const FigureDrawing& drawing);

/// File formats of figures.
enum class FigureFormat { pdf, svg, png };

/// The format for a file name's suffix, in upper or lower case. @throws Error that names the file if the suffix is
/// unknown.
FigureFormat figureFormatOf(const std::filesystem::path& path);

/// Default resolution of PNG files, as required for printing.
inline constexpr double figureDotsPerInch = 300;

/// The bytes of a figure's file. @throws Error as layOutFigure(), and for errors of cairo.
std::vector<std::byte> figureFile(const FigureDescription& description, const FigureMeasurement& measurement,
                                  FigureFormat format, double dotsPerInch = figureDotsPerInch);

/// Checks that the page is wide enough for all columns. Call it before a measurement. @throws Error as layOutFigure().
void checkFigureFits(const FigureDescription& description);

}  // namespace gonio::figures
