// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/draw_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/figures/figure_description.h"
#include "core/rendering/error_maps.h"
#include "core/support/text.h"

namespace gonio::figures {

namespace {

constexpr const char* insetColour = "#e8590c";
constexpr double insetLine = 0.25;          ///< mm
constexpr std::uint8_t missingGrey = 0xe4;  ///< of cells that are not measured

Raster missingPicture() { return {1, 1, {missingGrey, missingGrey, missingGrey, 255}}; }

Raster colourBar() {
  constexpr int length = 256;
  Raster bar{.width = length, .height = 1, .rgba = {}};
  for (int x = 0; x < length; ++x) {
    const rendering::DisplayColour colour = rendering::viridis(double(x) / (length - 1));
    bar.rgba.insert(bar.rgba.end(), {colour[0], colour[1], colour[2], 255});
  }
  return bar;
}

FigureTexts textsOf(const FigureDescription& description, const FigureMeasurement& measurement, double maximum) {
  FigureTexts texts;
  for (std::size_t row = 0; row < measurement.rows.size(); ++row)
    texts.rowNames.push_back(rowLabel(description, measurement, row));
  char text[64];
  std::snprintf(text, sizeof text, "%.3g", maximum);
  // The end of the scale is not known before the first measurement.
  const bool isKnown = maximum > 0 || measurement.missingCells() == 0;
  texts.errorScale = (isKnown ? std::string(text) + " " : std::string()) + "luminance error (linear)";
  if (description.inset) {
    // The inset has half of the picture's width beside an error map.
    const double magnification = (description.errorMaps ? 0.5 : 1) / description.inset->size;
    std::snprintf(text, sizeof text, "Insets: magnified %.2g×", magnification);
    texts.insetNote = text;
  }
  return texts;
}

class FigurePainter {
 public:
  FigurePainter(const FigureDescription& description, const FigureMeasurement& measurement, const TextWidth& width)
      : description_(description),
        measurement_(measurement),
        errorMaximum_(errorMaximum(description, measurement)),
        texts_(textsOf(description, measurement, errorMaximum_)),
        layout_(layOutFigure(description, texts_, width)) {
    drawing_.width = layout_.width;
    drawing_.height = layout_.height;
    drawing_.font = description.font;
    drawing_.title = plainText(description.title);
  }

  FigureDrawing paint() {
    if (layout_.title) paintLabel(*layout_.title, false);
    for (const LabelLayout& label : layout_.columnLabels) paintLabel(label, false);
    for (std::size_t row = 0; row < measurement_.rows.size(); ++row) paintRow(row);
    if (layout_.legend) paintLegend(*layout_.legend);
    return std::move(drawing_);
  }

 private:
  void add(DrawingItem item) { drawing_.items.push_back(std::move(item)); }
  void addText(const glm::dvec2& at, const std::string& text, TextAnchor anchor, bool bold = false,
               bool upward = false) {
    add(TextItem{at, text, layout_.fontSize, anchor, bold, upward});
  }

  void paintLabel(const LabelLayout& label, bool upward) {
    for (std::size_t i = 0; i < label.lines.size(); ++i)
      addText(label.at[i], label.lines[i], TextAnchor::middle, true, upward);
  }

  void paintRow(std::size_t row) {
    paintLabel(layout_.rowLabels[row], true);
    const FigureRow& shown = measurement_.rows[row];
    const std::vector<CellLayout>& cells = layout_.cells[row];
    paintPicture(cells[0], shown.reference.get());
    for (std::size_t i = 0; i < description_.numbers.size(); ++i)
      addText(cells[0].numberLines[i], figureNumber(description_.numbers[i]).name, TextAnchor::middle);
    for (std::size_t cell = 0; cell < shown.cells.size(); ++cell) {
      const FigureCell* const measured = shown.cells[cell].get();
      paintPicture(cells[1 + cell], measured ? &measured->picture : nullptr);
      paintErrorMap(cells[1 + cell], shown.reference.get(), measured);
      if (measured) paintNumbers(cells[1 + cell], shown, cell);
    }
  }

  /// @param picture null if it is not rendered yet.
  void paintPicture(const CellLayout& cell, const Image* picture) {
    Raster raster = picture ? displayedOnWhite(*picture, description_.pictures) : missingPicture();
    const int size = picture ? picture->width : description_.pictures.size;
    const InsetPixels shown = description_.inset ? insetPixels(*description_.inset, size) : InsetPixels{};
    Raster inset;
    if (cell.inset) inset = picture ? crop(raster, shown) : missingPicture();
    add(PictureItem{cell.picture, std::move(raster)});
    if (!cell.inset) return;
    const double pixel = cell.picture.width / size;
    add(FrameItem{{cell.picture.x + shown.left * pixel, cell.picture.y + shown.top * pixel, shown.side * pixel,
                   shown.side * pixel},
                  insetColour,
                  insetLine});
    add(PictureItem{*cell.inset, std::move(inset), true});
    add(FrameItem{*cell.inset, insetColour, insetLine});
  }

  /// @param measured null if the cell is not measured yet.
  void paintErrorMap(const CellLayout& cell, const Image* reference, const FigureCell* measured) {
    if (!cell.errorMap) return;
    Raster map = missingPicture();
    if (reference && measured)
      map = {reference->width, reference->height, rendering::errorMap(*reference, measured->picture, errorMaximum_)};
    putOnWhite(map);
    add(PictureItem{*cell.errorMap, std::move(map)});
  }

  void paintNumbers(const CellLayout& cell, const FigureRow& row, std::size_t index) {
    for (std::size_t i = 0; i < description_.numbers.size(); ++i) {
      const std::string& id = description_.numbers[i];
      addText(cell.numberLines[i], valueText(figureNumber(id), row.cells[index]->value(id)), TextAnchor::middle,
              isBest(description_, row, index, i));
    }
  }

  void paintLegend(const LegendLayout& legend) {
    if (legend.bar) {
      addText(legend.zero, "0", TextAnchor::end);
      add(PictureItem{*legend.bar, colourBar()});
      addText(legend.errorScale, texts_.errorScale, TextAnchor::start);
    }
    if (description_.inset) addText(legend.insetNote, texts_.insetNote, TextAnchor::end);
  }

  const FigureDescription& description_;
  const FigureMeasurement& measurement_;
  const double errorMaximum_;
  FigureTexts texts_;
  FigureLayout layout_;
  FigureDrawing drawing_;
};

}  // namespace

InsetPixels insetPixels(const FigureInset& inset, int size) {
  InsetPixels pixels;
  pixels.side = std::clamp(int(std::lround(inset.size * size)), 1, size);
  pixels.left = std::clamp(int(std::lround(inset.x * size)), 0, size - pixels.side);
  pixels.top = std::clamp(int(std::lround(inset.y * size)), 0, size - pixels.side);
  return pixels;
}

void putOnWhite(Raster& raster) {
  for (std::size_t i = 0; i < raster.rgba.size(); i += 4) {
    const double alpha = raster.rgba[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c)
      raster.rgba[i + c] = std::uint8_t(std::lround(alpha * raster.rgba[i + c] + 255 * (1 - alpha)));
    raster.rgba[i + 3] = 255;
  }
}

Raster displayedOnWhite(const Image& picture, const FigurePictures& pictures) {
  Raster raster{picture.width, picture.height, rendering::toDisplayBytes(picture, pictures.exposure, pictures.toneMap)};
  putOnWhite(raster);
  return raster;
}

Raster crop(const Raster& raster, const InsetPixels& pixels) {
  Raster cut{pixels.side, pixels.side, {}};
  for (int y = pixels.top; y < pixels.top + pixels.side; ++y) {
    const auto begin = raster.rgba.begin() + 4 * (std::ptrdiff_t(y) * raster.width + pixels.left);
    cut.rgba.insert(cut.rgba.end(), begin, begin + 4 * std::ptrdiff_t(pixels.side));
  }
  return cut;
}

bool isBest(const FigureDescription& description, const FigureRow& row, std::size_t cell, std::size_t number) {
  const FigureNumber& kind = figureNumber(description.numbers[number]);
  const double value = row.cells[cell]->value(kind.id);
  if (!kind.isError || row.cells.size() < 2 || std::isnan(value)) return false;
  return std::ranges::none_of(row.cells, [&](const auto& other) {
    return other && (kind.better == Better::higher ? other->value(kind.id) > value : other->value(kind.id) < value);
  });
}

FigureLayout figureLayout(const FigureDescription& description, const FigureMeasurement& measurement,
                          const TextWidth& width) {
  return layOutFigure(description, textsOf(description, measurement, errorMaximum(description, measurement)), width);
}

FigureDrawing drawFigure(const FigureDescription& description, const FigureMeasurement& measurement,
                         const TextWidth& width) {
  return FigurePainter(description, measurement, width).paint();
}

}  // namespace gonio::figures
