// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>

namespace gonio::plots {

/// Shapes that distinguish points without their colours.
enum class Marker { square, circle, triangle, diamond, cross, star };

struct SvgStroke {
  std::string_view colour = "#222222";
  double width = 1;           ///< in the page's unit, as all lengths
  std::string_view dashes{};  ///< "4 3"; none: solid
};

/// What a drawing is measured in and written with.
struct SvgPage {
  std::string_view unit{};  ///< "mm"; none: pixels
  std::string_view fontFamily = "sans-serif";
};

/// A drawing as SVG 1.1 text: in the page's unit, the origin at the top left, y down, on white. Colours as CSS names
/// them.
class SvgDrawing {
 public:
  SvgDrawing(double width, double height, const SvgPage& page = {});

  void line(const glm::dvec2& from, const glm::dvec2& to, const SvgStroke& stroke = {});
  void polyline(std::span<const glm::dvec2> points, const SvgStroke& stroke = {});
  void frame(const glm::dvec2& low, const glm::dvec2& high, const SvgStroke& stroke = {});
  /// @param size about half its height and width.
  /// @param title what a viewer shows while the pointer rests on it; none where it is empty.
  void marker(Marker marker, const glm::dvec2& at, double size, std::string_view colour, bool hollow,
              std::string_view title = {});

  /// An embedded picture, stretched to the rectangle. @param exactPixels drawn as squares, not smoothed.
  void picture(const glm::dvec2& low, const glm::dvec2& high, std::span<const std::byte> png, bool exactPixels);

  enum class Anchor { start, middle, end };
  struct TextStyle {
    double size = 12;  ///< in the page's unit
    Anchor anchor = Anchor::start;
    bool bold = false;
    bool upward = false;  ///< turned by 90 degrees, read from below
    bool halo = false;    ///< white about the letters, where they cross lines
    std::string_view colour = "#222222";
  };
  /// @param at on the base line, where the anchor says.
  void text(const glm::dvec2& at, std::string_view text, const TextStyle& style);
  void text(const glm::dvec2& at, std::string_view words) { text(at, words, TextStyle()); }

  /// The whole file.
  std::string str() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace gonio::plots
