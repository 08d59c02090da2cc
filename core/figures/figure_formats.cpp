// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_formats.h"

#include <span>

#include "core/figures/cairo_figure.h"
#include "core/figures/draw_figure.h"
#include "core/figures/figure_layout.h"
#include "core/figures/figure_svg.h"
#include "core/support/text.h"

namespace gonio::figures {

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
