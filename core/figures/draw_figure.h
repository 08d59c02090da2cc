// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/figures/figure_drawing.h"
#include "core/figures/figure_measurement.h"

namespace gonio::figures {

/// The page of a figure. The best error of each material stands in bold where there are several.
/// @param width of texts in the description's font. @throws Error as layOutFigure().
FigureDrawing drawFigure(const FigureDescription& description, const FigureMeasurement& measurement,
                         const TextWidth& width);

/// Which pixels an inset shows: whole ones, at least one. In pixels from the top left, of pictures of `size` pixels.
struct InsetPixels {
  int left = 0, top = 0, side = 1;
};
InsetPixels insetPixels(const FigureInset& inset, int size);

/// A picture as it is displayed on white paper.
Raster displayedOnPaper(const Image& picture, const FigurePictures& pictures);
/// Pixels of a picture. Contract: they lie in it.
Raster cutOut(const Raster& raster, const InsetPixels& pixels);

/// Whether a cell has the best value of one of the errors among all cells of a row of two or more; numbers that are no
/// errors, and values that are not numbers, are never the best.
bool isBest(const FigureDescription& description, const FigureRow& row, std::size_t cell, std::size_t number);

}  // namespace gonio::figures
