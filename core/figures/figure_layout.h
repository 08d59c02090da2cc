// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/figures/figure_description.h"

namespace gonio::figures {

/// Size of a typographic point, the unit of font sizes, in millimetres.
inline constexpr double millimetresPerPoint = 25.4 / 72;

/// A rectangle on the page, mm, with the origin at the top left and y down.
struct PageRectangle {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool operator==(const PageRectangle&) const = default;
};

/// 8-bit sRGB RGBA, opaque; the first row is the top one.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

struct PictureItem {
  PageRectangle place;
  Raster raster;
  bool exactPixels = false;  ///< whether pixels are drawn as rectangles instead of interpolated
};

enum class TextAnchor { start, middle, end };

struct TextItem {
  glm::dvec2 at;  ///< position of the anchor on the base line, mm
  std::string text;
  double size = 8;  ///< pt
  TextAnchor anchor = TextAnchor::start;
  bool bold = false;
  bool upward = false;  ///< rotated by 90 degrees, reads from bottom to top
};

/// The outline of a rectangle.
struct FrameItem {
  PageRectangle place;
  std::string colour = "#222222";  ///< "#rrggbb"
  double lineWidth = 0.1;          ///< mm
};

/// A line through points, for plots.
struct LineItem {
  std::vector<glm::dvec2> points;  ///< mm
  std::string colour = "#222222";  ///< "#rrggbb"
  double lineWidth = 0.1;          ///< mm
  double dash = 0;                 ///< length of dashes and gaps, mm; 0: solid
};

using DrawingItem = std::variant<PictureItem, TextItem, FrameItem, LineItem>;

/// A white page with its items in drawing order. All file formats are written from this. Texts and title are
/// plainText().
struct FigureDrawing {
  double width = 0, height = 0;  ///< mm
  std::string font, title;       ///< font family; title for the file's metadata
  std::vector<DrawingItem> items;
};

/// Returns the width of a text in mm for a font size in pt.
using TextWidth = std::function<double(std::string_view text, double size, bool bold)>;

/// Widths of one column and of two with the gap between them, mm. They fit the pages of ACM (acmart: 84.7 and 177.9)
/// and IEEE (IEEEtran: 88.6 and 181.4).
inline constexpr double oneColumnWidth = 84, twoColumnsWidth = 177;
double pageWidth(FigureWidth width);
/// Font size in pt: that of the description, or the default for its width.
double fontSizeOf(const FigureDescription& description);

/// Layout of one material and one representation, or of the reference.
struct CellLayout {
  PageRectangle picture;
  std::optional<PageRectangle> inset, errorMap;
  PageRectangle caption;                ///< area of the numbers
  std::vector<glm::dvec2> numberLines;  ///< centre of each base line
};

/// Lines of one text; `at` contains the centre of each base line.
struct LabelLayout {
  std::vector<std::string> lines;
  std::vector<glm::dvec2> at;
  PageRectangle place;
};

/// The scale of the error maps and the note on the insets, below the grid: in one line, or in two if the page is too
/// narrow.
struct LegendLayout {
  PageRectangle place;
  std::optional<PageRectangle> bar;  ///< colours from 0 to the maximum
  glm::dvec2 zero, errorScale;  ///< end of the text "0" left of the bar, start of FigureTexts::errorScale right of it
  glm::dvec2 insetNote;         ///< right end of the text
};

/// Texts that a layout places in addition to those of the description.
struct FigureTexts {
  std::vector<std::string> rowNames;  ///< of the materials
  std::string errorScale;             ///< the end of the scale and its quantity, e.g. "0.05 luminance error"
  std::string insetNote;
};

/// Positions of all parts of a figure, mm.
struct FigureLayout {
  double width = 0, height = 0;
  double fontSize = 0;  ///< pt
  std::optional<LabelLayout> title;
  std::vector<LabelLayout> columnLabels;       ///< the reference, then the representations
  std::vector<LabelLayout> rowLabels;          ///< of the materials; read from bottom to top
  std::vector<std::vector<CellLayout>> cells;  ///< [material][0: reference, 1 + representation]
  std::optional<LegendLayout> legend;          ///< if there are error maps or insets
};

/// Computes the layout: a grid of cells of equal size, as wide as the page allows. The inset and the error map are
/// below each picture, side by side; if there is only one of them, it has the full width. @param width measures text
/// widths, for the line breaks of labels. @throws Error if the columns would be narrower than 9 mm.
FigureLayout layOutFigure(const FigureDescription& description, const FigureTexts& texts, const TextWidth& width);

/// Breaks a text into lines of at most `maxWidth` mm: at spaces, after hyphens and underscores, and between letters
/// where a part is wider than a line. @param size of the font, pt.
std::vector<std::string> brokenLines(const std::string& text, double maxWidth, double size, const TextWidth& width,
                                     bool bold = false);

}  // namespace gonio::figures
