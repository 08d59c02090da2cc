// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/figures/figure_layout.h"
#include "core/math/image.h"
#include "core/plots/svg_drawing.h"

/// Drawings of reproduced figures: charts of lines, grids of pictures, tables of texts. Pages are two columns wide
/// (figures::twoColumnsWidth); the height follows from the content.
namespace gonio::reproduction {

struct ChartSeries {
  std::string name = {};  ///< in the legend; empty: not listed
  std::vector<glm::dvec2> points;
  std::string colour = {};  ///< "#rrggbb"; empty: the colour of its number among the series
  bool isLine = true;
  bool hasMarkers = false;
  bool isDashed = false;
  std::optional<plots::Marker> marker = {};  ///< empty: the marker of its number among the series
};

struct Chart {
  std::string title, xTitle, yTitle;
  std::vector<ChartSeries> series;
  bool logX = false, logY = false;
  std::optional<std::array<double, 2>> xRange = {}, yRange = {};  ///< empty: from the points
  bool isDisk = false;                                            ///< equal scales, no axes; ranges must be given
  /// A picture instead of series, over the whole ranges; its first row is at the top.
  std::optional<figures::Raster> raster = {};
};

/// Charts in a grid of equal cells. @param columns [1, 4].
figures::FigureDrawing drawCharts(const std::string& title, std::span<const Chart> charts, int columns);

/// A picture with its lines of text below.
struct PictureCell {
  figures::Raster raster;
  std::vector<std::string> lines = {};
};
struct PictureRow {
  std::string label;
  std::vector<PictureCell> cells;
};
/// Rows of pictures with a label each; all rows have as many cells as there are column labels.
figures::FigureDrawing drawPictures(const std::string& title, std::span<const std::string> columns,
                                    std::span<const PictureRow> rows, const std::string& note = {});

/// A table of texts with a line of titles. Columns are as wide as their texts.
figures::FigureDrawing drawTable(const std::string& title, std::span<const std::string> columns,
                                 std::span<const std::vector<std::string>> rows);

/// A picture as displayed on white.
figures::Raster shownPicture(const Image& picture);
/// The absolute luminance difference of pictures in false colours on a scale from 0 to `range`.
figures::Raster errorPicture(const Image& reference, const Image& picture, double range);

}  // namespace gonio::reproduction
