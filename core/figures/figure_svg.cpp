// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_svg.h"

#include "core/io/image_io.h"
#include "core/plots/svg_drawing.h"

namespace gonio::figures {

namespace {

using plots::SvgDrawing;

struct SvgPainter {
  SvgDrawing& svg;

  void operator()(const PictureItem& item) const {
    const Raster& raster = item.raster;
    const PageRectangle& place = item.place;
    svg.picture({place.x, place.y}, {place.right(), place.bottom()},
                io::encodePng(raster.rgba, raster.width, raster.height), item.exactPixels);
  }
  void operator()(const TextItem& item) const {
    svg.text(item.at, item.text,
             {.size = item.size * millimetresPerPoint,
              .anchor = SvgDrawing::Anchor(item.anchor),
              .bold = item.bold,
              .upward = item.upward,
              .colour = "#000000"});
  }
  void operator()(const FrameItem& item) const {
    const PageRectangle& place = item.place;
    svg.frame({place.x, place.y}, {place.right(), place.bottom()}, {.colour = item.colour, .width = item.lineWidth});
  }
};

/// With fonts of the same widths in its place, by which other machines break no line.
std::string familiesOf(const std::string& font) {
  if (font == "Helvetica" || font == "Arial") return font + ", Nimbus Sans, Liberation Sans, Arial, sans-serif";
  if (font.starts_with("Times")) return font + ", Nimbus Roman, Liberation Serif, Times New Roman, serif";
  return font + ", sans-serif";
}

}  // namespace

std::string figureSvg(const FigureDrawing& drawing) {
  const std::string families = familiesOf(drawing.font);
  SvgDrawing svg(drawing.width, drawing.height, {.unit = "mm", .fontFamily = families});
  for (const DrawingItem& item : drawing.items) std::visit(SvgPainter{svg}, item);
  return svg.str();
}

}  // namespace gonio::figures
