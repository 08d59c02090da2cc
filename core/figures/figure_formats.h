// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/figures/figure_measurement.h"

namespace gonio::figures {

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
