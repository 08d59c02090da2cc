// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/figures/figure_measurement.h"

namespace gonio::figures {

/// Files that a figure can be written as.
enum class FigureFormat { pdf, svg, png };

/// By the suffix of a name, in either case. @throws Error naming the file where it has another one.
FigureFormat figureFormatOf(const std::filesystem::path& path);

/// Of PNG files, as printers ask for pictures.
inline constexpr double figureDotsPerInch = 300;

/// The file of a figure. @throws Error as layOutFigure(), and for what cairo cannot draw.
std::vector<std::byte> figureFile(const FigureDescription& description, const FigureMeasurement& measurement,
                                  FigureFormat format, double dotsPerInch = figureDotsPerInch);

/// Whether the page holds all columns; before the work of a measurement.
/// @throws Error as layOutFigure().
void checkFigureFits(const FigureDescription& description);

}  // namespace gonio::figures
