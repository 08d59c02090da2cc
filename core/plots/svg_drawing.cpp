// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/svg_drawing.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "core/io/byte_source.h"
#include "core/math/types.h"
#include "core/support/text.h"

namespace gonio::plots {

namespace {

/// A tenth of a hundredth of a pixel is not seen.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string pointsText(std::span<const glm::dvec2> points) {
  std::string text;
  for (const glm::dvec2& point : points) text += (text.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  return text;
}

std::string strokeText(const SvgStroke& stroke) {
  std::string text =
      " stroke=\"" + std::string(stroke.colour) + "\" stroke-width=\"" + number(stroke.width) + "\" fill=\"none\"";
  if (!stroke.dashes.empty()) text += " stroke-dasharray=\"" + std::string(stroke.dashes) + "\"";
  return text;
}

/// Corners on circles around the origin, starting at the top.
std::vector<glm::dvec2> corners(int count, double radius, double innerRadius) {
  std::vector<glm::dvec2> result;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count, r = i % 2 == 0 ? radius : innerRadius;
    result.emplace_back(r * std::sin(angle), -r * std::cos(angle));
  }
  return result;
}

/// A cross with four arms.
std::vector<glm::dvec2> plus(double size) {
  const double s = 1.1 * size, t = 0.4 * size;
  return {{-t, -s}, {t, -s}, {t, -t}, {s, -t}, {s, t}, {t, t}, {t, s}, {-t, s}, {-t, t}, {-s, t}, {-s, -t}, {-t, -t}};
}

std::vector<glm::dvec2> turned(std::vector<glm::dvec2> points, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (glm::dvec2& point : points) point = {c * point.x - s * point.y, s * point.x + c * point.y};
  return points;
}

}  // namespace

std::vector<glm::dvec2> markerOutline(Marker marker, double size) {
  switch (marker) {
    case Marker::square:
      return {{-0.85 * size, -0.85 * size},
              {0.85 * size, -0.85 * size},
              {0.85 * size, 0.85 * size},
              {-0.85 * size, 0.85 * size}};
    case Marker::triangle:
      return corners(3, 1.2 * size, 1.2 * size);
    case Marker::triangleDown:
      return turned(corners(3, 1.2 * size, 1.2 * size), pi);
    case Marker::triangleLeft:
      return turned(corners(3, 1.2 * size, 1.2 * size), -pi / 2);
    case Marker::triangleRight:
      return turned(corners(3, 1.2 * size, 1.2 * size), pi / 2);
    case Marker::diamond:
      return corners(4, 1.25 * size, 1.25 * size);
    case Marker::cross:
      return plus(size);
    case Marker::saltire:
      return turned(plus(size), pi / 4);
    case Marker::star:
      return corners(10, 1.45 * size, 0.6 * size);
    case Marker::pentagon:
      return corners(5, 1.15 * size, 1.15 * size);
    case Marker::threeStar:
      return corners(6, 1.5 * size, 0.5 * size);
    case Marker::fourStar:
      return corners(8, 1.5 * size, 0.55 * size);
    case Marker::hourglass: {
      const double x = 0.9 * size, y = 1.1 * size, waist = 0.2 * size;
      return {{-x, -y}, {x, -y}, {waist, 0}, {x, y}, {-x, y}, {-waist, 0}};
    }
    case Marker::arrowhead:
      return {{0, -1.3 * size}, {1.1 * size, 1.1 * size}, {0, 0.5 * size}, {-1.1 * size, 1.1 * size}};
    case Marker::circle:
      break;
  }
  return {};
}

SvgDrawing::SvgDrawing(double width, double height, const SvgPage& page) {
  const std::string w = number(width), h = number(height), unit(page.unit);
  body_ =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"" +
      w + unit + "\" height=\"" + h + unit + "\" viewBox=\"0 0 " + w + " " + h + "\" font-family=\"" +
      xmlText(page.fontFamily) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void SvgDrawing::line(const glm::dvec2& from, const glm::dvec2& to, const SvgStroke& stroke) {
  body_ += "<line x1=\"" + number(from.x) + "\" y1=\"" + number(from.y) + "\" x2=\"" + number(to.x) + "\" y2=\"" +
           number(to.y) + "\"" + strokeText(stroke) + "/>\n";
}

void SvgDrawing::polyline(std::span<const glm::dvec2> points, const SvgStroke& stroke) {
  body_ += "<polyline points=\"" + pointsText(points) + "\"" + strokeText(stroke) + "/>\n";
}

void SvgDrawing::frame(const glm::dvec2& topLeft, const glm::dvec2& bottomRight, const SvgStroke& stroke) {
  const glm::dvec2 size = bottomRight - topLeft;
  body_ += "<rect x=\"" + number(topLeft.x) + "\" y=\"" + number(topLeft.y) + "\" width=\"" + number(size.x) +
           "\" height=\"" + number(size.y) + "\"" + strokeText(stroke) + "/>\n";
}

void SvgDrawing::marker(Marker marker, const glm::dvec2& at, double size, std::string_view colour, bool hollow,
                        std::string_view title) {
  const std::string paint = " stroke=\"" + std::string(colour) + "\" stroke-width=\"1.4\" fill=\"" +
                            (hollow ? std::string("#ffffff") : std::string(colour)) + "\"";
  std::vector<glm::dvec2> points = markerOutline(marker, size);
  for (glm::dvec2& point : points) point += at;
  const std::string shape = marker == Marker::circle ? "circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) +
                                                           "\" r=\"" + number(size) + "\""
                                                     : "polygon points=\"" + pointsText(points) + "\"";
  body_ += "<" + shape + paint;
  if (title.empty())
    body_ += "/>\n";
  else
    body_ += "><title>" + xmlText(title) + "</title></" + (marker == Marker::circle ? "circle" : "polygon") + ">\n";
}

void SvgDrawing::picture(const glm::dvec2& topLeft, const glm::dvec2& bottomRight, std::span<const std::byte> png,
                         bool exactPixels) {
  const glm::dvec2 size = bottomRight - topLeft;
  body_ += "<image x=\"" + number(topLeft.x) + "\" y=\"" + number(topLeft.y) + "\" width=\"" + number(size.x) +
           "\" height=\"" + number(size.y) + "\" preserveAspectRatio=\"none\"";
  if (exactPixels) body_ += " style=\"image-rendering:pixelated\"";
  body_ += " xlink:href=\"data:image/png;base64," + io::base64Text(png) + "\"/>\n";
}

void SvgDrawing::text(const glm::dvec2& at, std::string_view words, const TextStyle& style) {
  constexpr const char* anchors[] = {"start", "middle", "end"};
  body_ += "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" font-size=\"" + number(style.size) +
           "\" text-anchor=\"" + anchors[int(style.anchor)] + "\" fill=\"" + std::string(style.colour) + "\"";
  if (style.bold) body_ += " font-weight=\"bold\"";
  if (style.halo) body_ += " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"";
  if (style.upward) body_ += " transform=\"rotate(-90 " + number(at.x) + " " + number(at.y) + ")\"";
  body_ += ">" + xmlText(words) + "</text>\n";
}

}  // namespace gonio::plots
