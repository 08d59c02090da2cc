// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/figures/figure_layout.h"
#include "core/figures/figure_measurement.h"

namespace gonio::figures {

/// Computes the layout of a figure. @param width measures text widths in the description's font. @throws as
/// layOutFigure().
FigureLayout figureLayout(const FigureDescription& description, const FigureMeasurement& measurement,
                          const TextWidth& width);

/// Draws the page of a figure. The best error of each material is bold if there are several representations. Cells that
/// are not measured are grey. @param measurement of the same description, from measureFigure() or knownPart().
/// @param width measures text widths in the description's font. @throws as layOutFigure().
FigureDrawing drawFigure(const FigureDescription& description, const FigureMeasurement& measurement,
                         const TextWidth& width);

/// The pixels that an inset shows: a square of at least one pixel, from the top left of a picture with `size` pixels
/// per side.
struct InsetPixels {
  int left = 0, top = 0, side = 1;
};
InsetPixels insetPixels(const FigureInset& inset, int size);

/// Composites straight colours with alpha over white, in display values; the raster is then opaque.
void putOnWhite(Raster& raster);
/// An image with exposure and tone map applied, composited over white.
Raster displayedOnWhite(const Image& picture, const FigurePictures& pictures);
/// Crops a picture. Precondition: the pixels are inside it.
Raster crop(const Raster& raster, const InsetPixels& pixels);

/// Whether a cell has the best value of a number in its row. False for rows of one cell, numbers that are not errors
/// (FigureNumber::isError) and NaN. Precondition: the cell is measured.
bool isBest(const FigureDescription& description, const FigureRow& row, std::size_t cell, std::size_t number);

}  // namespace gonio::figures
