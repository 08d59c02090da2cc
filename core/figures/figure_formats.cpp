// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_formats.h"

#include <cairo/cairo-pdf.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

#include "core/figures/draw_figure.h"
#include "core/figures/figure_layout.h"
#include "core/io/image_io.h"
#include "core/plots/svg_drawing.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::figures {

namespace {

constexpr double millimetresPerInch = 25.4;

struct SurfaceEnd {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceEnd>;

struct ContextEnd {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Context = std::unique_ptr<cairo_t, ContextEnd>;

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("the figure could not be drawn: ") + cairo_status_to_string(status));
}

cairo_status_t collect(void* target, const unsigned char* data, unsigned length) {
  const auto added = std::as_bytes(std::span(data, length));
  auto& bytes = *static_cast<std::vector<std::byte>*>(target);
  bytes.insert(bytes.end(), added.begin(), added.end());
  return CAIRO_STATUS_SUCCESS;
}

void selectFont(cairo_t* cairo, const std::string& font, double size, bool bold) {
  cairo_select_font_face(cairo, plainText(font).c_str(), CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size * millimetresPerPoint);
}

double advance(cairo_t* cairo, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

/// Widths that do not depend on the resolution.
void setUnhintedText(cairo_t* cairo) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
}

/// Cairo's pixels: 0x00rrggbb in the machine's order of bytes.
Surface surfaceOf(const Raster& raster) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, raster.width, raster.height));
  check(cairo_surface_status(surface.get()));
  cairo_surface_flush(surface.get());
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x) {
      const std::uint8_t* from = &raster.rgba[4 * (std::size_t(y) * std::size_t(raster.width) + std::size_t(x))];
      const std::uint32_t pixel = std::uint32_t(from[0]) << 16 | std::uint32_t(from[1]) << 8 | from[2];
      std::copy_n(reinterpret_cast<const unsigned char*>(&pixel), 4, data + std::ptrdiff_t(y) * stride + 4 * x);
    }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

struct CairoPainter {
  cairo_t* cairo;
  const std::string& font;

  void operator()(const PictureItem& item) const {
    const PageRectangle& place = item.place;
    const Surface surface = surfaceOf(item.raster);
    cairo_save(cairo);
    cairo_translate(cairo, place.x, place.y);
    cairo_scale(cairo, place.width / item.raster.width, place.height / item.raster.height);
    cairo_set_source_surface(cairo, surface.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo), item.exactPixels ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
    // Pixels of a page's edge would be mixed with nothing; a PDF has pictures as they are.
    const bool isPdf = cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_PDF;
    cairo_pattern_set_extend(cairo_get_source(cairo), isPdf ? CAIRO_EXTEND_NONE : CAIRO_EXTEND_PAD);
    cairo_rectangle(cairo, 0, 0, item.raster.width, item.raster.height);
    cairo_fill(cairo);
    cairo_restore(cairo);
  }

  void operator()(const TextItem& item) const {
    cairo_save(cairo);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    selectFont(cairo, font, item.size, item.bold);
    cairo_translate(cairo, item.at.x, item.at.y);
    if (item.upward) cairo_rotate(cairo, -std::acos(0.0));
    const double shift = item.anchor == TextAnchor::start ? 0 : item.anchor == TextAnchor::middle ? 0.5 : 1;
    cairo_move_to(cairo, -shift * advance(cairo, item.text), 0);
    cairo_show_text(cairo, item.text.c_str());
    cairo_restore(cairo);
  }

  void operator()(const FrameItem& item) const {
    setStroke(item.colour, item.lineWidth);
    cairo_rectangle(cairo, item.place.x, item.place.y, item.place.width, item.place.height);
    cairo_stroke(cairo);
  }

  void operator()(const LineItem& item) const {
    setStroke(item.colour, item.lineWidth);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(cairo, &item.dash, item.dash > 0 ? 1 : 0, 0);
    cairo_new_path(cairo);  // a text leaves a current point
    for (const glm::dvec2& point : item.points) cairo_line_to(cairo, point.x, point.y);
    cairo_stroke(cairo);
    cairo_set_dash(cairo, nullptr, 0, 0);
  }

 private:
  void setStroke(const std::string& colour, double width) const {
    unsigned red = 0, green = 0, blue = 0;
    std::sscanf(colour.c_str(), "#%2x%2x%2x", &red, &green, &blue);
    cairo_set_source_rgb(cairo, red / 255.0, green / 255.0, blue / 255.0);
    cairo_set_line_width(cairo, width);
  }
};

/// @param scale device units per mm.
void draw(cairo_surface_t* surface, const FigureDrawing& drawing, double scale) {
  const Context cairo(cairo_create(surface));
  cairo_set_source_rgb(cairo.get(), 1, 1, 1);
  cairo_paint(cairo.get());
  cairo_scale(cairo.get(), scale, scale);
  setUnhintedText(cairo.get());
  for (const DrawingItem& item : drawing.items) std::visit(CairoPainter{cairo.get(), drawing.font}, item);
  check(cairo_status(cairo.get()));
}

Surface drawnSurface(const FigureDrawing& drawing, double dotsPerInch) {
  const double scale = dotsPerInch / millimetresPerInch;
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(std::ceil(drawing.width * scale)),
                                             int(std::ceil(drawing.height * scale))));
  check(cairo_surface_status(surface.get()));
  draw(surface.get(), drawing, scale);
  return surface;
}

}  // namespace

TextWidth cairoTextWidth(const std::string& font) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const std::shared_ptr<cairo_t> cairo(cairo_create(surface.get()), cairo_destroy);
  // The scale of a large page: widths scale with it.
  constexpr double scale = 100;
  cairo_scale(cairo.get(), scale, scale);
  setUnhintedText(cairo.get());
  return [cairo, font](std::string_view text, double size, bool bold) {
    selectFont(cairo.get(), font, size, bold);
    return advance(cairo.get(), std::string(text));
  };
}

std::vector<std::byte> figurePdf(const FigureDrawing& drawing) {
  std::vector<std::byte> bytes;
  const double scale = 1 / millimetresPerPoint;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(collect, &bytes, drawing.width * scale, drawing.height * scale));
  check(cairo_surface_status(surface.get()));
  // Without the date of the file, which would differ each time.
  // What every journal and LaTeX reads; cairo 1.18 would write 1.7, with objects in compressed streams.
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Gonio");
  if (!drawing.title.empty())
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, drawing.title.c_str());
  draw(surface.get(), drawing, scale);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

std::vector<std::byte> figurePng(const FigureDrawing& drawing, double dotsPerInch) {
  const Surface surface = drawnSurface(drawing, dotsPerInch);
  std::vector<std::byte> bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), collect, &bytes));
  return bytes;
}

Raster figureRaster(const FigureDrawing& drawing, double dotsPerInch) {
  const Surface surface = drawnSurface(drawing, dotsPerInch);
  cairo_surface_flush(surface.get());
  Raster raster{cairo_image_surface_get_width(surface.get()), cairo_image_surface_get_height(surface.get()), {}};
  raster.rgba.reserve(4 * std::size_t(raster.width) * std::size_t(raster.height));
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, data + std::ptrdiff_t(y) * cairo_image_surface_get_stride(surface.get()) + 4 * x, 4);
      for (const int shift : {16, 8, 0}) raster.rgba.push_back(std::uint8_t(pixel >> shift));
      raster.rgba.push_back(255);
    }
  return raster;
}

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
  void operator()(const LineItem& item) const {
    const std::string dashes = item.dash > 0 ? numberText(item.dash) : "";
    svg.polyline(item.points, {.colour = item.colour, .width = item.lineWidth, .dashes = dashes});
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

FigureFormat figureFormatOf(const std::filesystem::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  if (suffix == ".pdf") return FigureFormat::pdf;
  if (suffix == ".svg") return FigureFormat::svg;
  if (suffix == ".png") return FigureFormat::png;
  throw Error(path.string() + ": found the suffix '" + suffix + "', expected .pdf, .svg or .png");
}

std::vector<std::byte> figureFile(const FigureDescription& description, const FigureMeasurement& measurement,
                                  FigureFormat format, double dotsPerInch) {
  const FigureDrawing drawing = drawFigure(description, measurement, cairoTextWidth(description.font));
  if (format == FigureFormat::pdf) return figurePdf(drawing);
  if (format == FigureFormat::png) return figurePng(drawing, dotsPerInch);
  const std::string svg = figureSvg(drawing);
  const auto bytes = std::as_bytes(std::span(svg));
  return {bytes.begin(), bytes.end()};
}

void checkFigureFits(const FigureDescription& description) {
  layOutFigure(description,
               {.rowNames = std::vector<std::string>(description.materials.size()), .errorScale = {}, .insetNote = {}},
               cairoTextWidth(description.font));
}

}  // namespace gonio::figures
