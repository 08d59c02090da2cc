// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::plots {

/// Shapes of points, which distinguish them without colour.
enum class Marker {
  square,
  circle,
  triangle,
  diamond,
  cross,
  star,
  triangleDown,
  saltire,
  pentagon,
  triangleLeft,
  triangleRight,
  threeStar,
  fourStar,
  hourglass,
  arrowhead
};

/// The corners of a marker around the origin, y down; empty for a circle, which has the radius `size`.
/// @param size about half the height and width.
std::vector<glm::dvec2> markerOutline(Marker marker, double size);

struct SvgStroke {
  std::string_view colour = "#222222";
  double width = 1;           ///< in the page's unit, like all lengths
  std::string_view dashes{};  ///< e.g. "4 3"; empty: solid
};

/// Unit and font of a drawing.
struct SvgPage {
  std::string_view unit{};  ///< e.g. "mm"; empty: pixels
  std::string_view fontFamily = "sans-serif";
};

/// Writes a drawing as SVG 1.1, in the page's unit, with the origin at the top left and y down, on white. Colours are
/// CSS colours. Texts are written by xmlText().
class SvgDrawing {
 public:
  SvgDrawing(double width, double height, const SvgPage& page = {});

  void line(const glm::dvec2& from, const glm::dvec2& to, const SvgStroke& stroke = {});
  void polyline(std::span<const glm::dvec2> points, const SvgStroke& stroke = {});
  void frame(const glm::dvec2& topLeft, const glm::dvec2& bottomRight, const SvgStroke& stroke = {});
  /// @param size about half the height and width.
  /// @param title tooltip in SVG viewers; empty: none.
  void marker(Marker marker, const glm::dvec2& at, double size, std::string_view colour, bool hollow,
              std::string_view title = {});

  /// An embedded picture, scaled to the rectangle. @param exactPixels whether pixels are drawn as squares instead of
  /// interpolated.
  void picture(const glm::dvec2& topLeft, const glm::dvec2& bottomRight, std::span<const std::byte> png,
               bool exactPixels);

  enum class Anchor { start, middle, end };
  struct TextStyle {
    double size = 12;  ///< in the page's unit
    Anchor anchor = Anchor::start;
    bool bold = false;
    bool upward = false;  ///< rotated by 90 degrees, reads from bottom to top
    bool halo = false;    ///< white outline, for text across lines
    std::string_view colour = "#222222";
  };
  /// @param at position of the anchor on the base line.
  void text(const glm::dvec2& at, std::string_view text, const TextStyle& style);
  void text(const glm::dvec2& at, std::string_view words) { text(at, words, TextStyle()); }

  /// The complete file.
  std::string str() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace gonio::plots
