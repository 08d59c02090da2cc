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

/// Typographic points, in which sizes of fonts are given, in millimetres.
inline constexpr double millimetresPerPoint = 25.4 / 72;

/// A rectangle on the page: mm, the origin at the top left, y down.
struct PageRectangle {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool operator==(const PageRectangle&) const = default;
};

/// 8-bit sRGB RGBA, the first row at the top, opaque.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

struct PictureItem {
  PageRectangle place;
  Raster raster;
  bool exactPixels = false;  ///< pixels are drawn as rectangles, not smoothed
};

enum class TextAnchor { start, middle, end };

struct TextItem {
  glm::dvec2 at;  ///< mm, on the base line, where the anchor says
  std::string text;
  double size = 8;  ///< pt
  TextAnchor anchor = TextAnchor::start;
  bool bold = false;
  bool upward = false;  ///< turned by 90 degrees, read from below
};

/// The outline of a rectangle.
struct FrameItem {
  PageRectangle place;
  std::string colour = "#222222";  ///< "#rrggbb"
  double lineWidth = 0.1;          ///< mm
};

using DrawingItem = std::variant<PictureItem, TextItem, FrameItem>;

/// A page with its items in the order in which they are drawn, on white. Every file format draws this.
struct FigureDrawing {
  double width = 0, height = 0;  ///< mm
  std::string font, title;       ///< family; for the file's own properties
  std::vector<DrawingItem> items;
};

/// The width of a text in mm, of a size in pt.
using TextWidth = std::function<double(std::string_view text, double size, bool bold)>;

}  // namespace gonio::figures
