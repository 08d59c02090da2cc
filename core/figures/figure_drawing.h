// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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

using DrawingItem = std::variant<PictureItem, TextItem, FrameItem>;

/// A white page with its items in drawing order. All file formats are written from this. Texts and title are
/// plainText().
struct FigureDrawing {
  double width = 0, height = 0;  ///< mm
  std::string font, title;       ///< font family; title for the file's metadata
  std::vector<DrawingItem> items;
};

/// Returns the width of a text in mm for a font size in pt.
using TextWidth = std::function<double(std::string_view text, double size, bool bold)>;

}  // namespace gonio::figures
