// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/figures/figure_description.h"
#include "core/figures/figure_drawing.h"

namespace gonio::figures {

/// mm: one column of a page with two, and both with the space between them. They fit into those of ACM (acmart: 84.7
/// and 177.9) and of IEEE (IEEEtran: 88.6 and 181.4).
inline constexpr double oneColumnWidth = 84, twoColumnsWidth = 177;
double pageWidth(FigureWidth width);
/// pt: that of the description, or the default of its width.
double fontSizeOf(const FigureDescription& description);

/// What stands for one material and one representation, or for its reference.
struct CellLayout {
  PageRectangle picture;
  std::optional<PageRectangle> inset, errorMap;
  PageRectangle caption;                ///< the lines of the numbers
  std::vector<glm::dvec2> numberLines;  ///< the middle of each line's base line
};

/// Lines of one text, with the middle of each on the base line.
struct LabelLayout {
  std::vector<std::string> lines;
  std::vector<glm::dvec2> at;
  PageRectangle place;
};

/// The scale of the error maps and the note on the insets, under the grid: in one line, or where the page is too narrow
/// in two.
struct LegendLayout {
  PageRectangle place;
  std::optional<PageRectangle> bar;  ///< colours from 0 to the maximum
  glm::dvec2 zero, errorScale;       ///< beside the bar: end of the text "0", start of FigureTexts::errorScale
  glm::dvec2 insetNote;              ///< end of the text, at the right
};

/// What a layout has to find space for beside what the description has.
struct FigureTexts {
  std::vector<std::string> rowNames;  ///< of the materials
  std::string errorScale;             ///< the end of the scale and what it is: "0.05 luminance error"
  std::string insetNote;
};

/// Where everything stands: mm.
struct FigureLayout {
  double width = 0, height = 0;
  double fontSize = 0;  ///< pt
  std::optional<LabelLayout> title;
  std::vector<LabelLayout> columnLabels;       ///< the reference, then the representations
  std::vector<LabelLayout> rowLabels;          ///< of the materials: read from below
  std::vector<std::vector<CellLayout>> cells;  ///< [material][0: reference, 1 + representation]
  std::optional<LegendLayout> legend;          ///< with error maps or insets
};

/// Cells of one size in a grid, as wide as the page allows. Under a picture its inset and its error map share the
/// cell's width; alone, either has all of it. Pure geometry.
/// @param width of texts, by which labels are broken into lines.
/// @throws Error for more columns than the page holds with cells of 9 mm.
FigureLayout layOutFigure(const FigureDescription& description, const FigureTexts& texts, const TextWidth& width);

/// A text in lines no wider than `most` mm: broken at spaces, after hyphens and underscores, and where a part is wider
/// by itself between two letters.
std::vector<std::string> brokenLines(const std::string& text, double most, double size, const TextWidth& width,
                                     bool bold = false);

}  // namespace gonio::figures
