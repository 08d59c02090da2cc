// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cairo/cairo.h>

#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/figures/draw_figure.h"
#include "core/figures/figure_description.h"
#include "core/figures/figure_formats.h"
#include "core/figures/figure_layout.h"
#include "core/figures/figure_tables.h"
#include "core/io/csv_text.h"
#include "core/rendering/error_maps.h"
#include "core/support/error.h"
#include "tests/core/figures/small_figure.h"
#include "tests/support/test_program.h"

namespace figure_files_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::figures;

/// Every character half as wide as the font is high.
double halfWidth(std::string_view text, double size, bool) {
  return 0.5 * size * millimetresPerPoint * double(text.size());
}

FigureDescription figureWithInsets() {
  FigureDescription figure = test::smallFigure();
  figure.title = "50 % & <more>";
  figure.inset = FigureInset{0.25, 0.5, 0.25};
  return figure;
}

std::string textOf(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// An opaque picture of a PNG file.
Raster decodedPng(const std::string& png) {
  std::string_view rest = png;
  const auto read = [](void* from, unsigned char* data, unsigned length) {
    auto& bytes = *static_cast<std::string_view*>(from);
    if (bytes.size() < length) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, bytes.data(), length);
    bytes.remove_prefix(length);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &rest);
  Raster raster{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* data = cairo_image_surface_get_data(surface);
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, data + std::ptrdiff_t(y) * cairo_image_surface_get_stride(surface) + 4 * x, 4);
      for (const int shift : {16, 8, 0}) raster.rgba.push_back(std::uint8_t(pixel >> shift));
      raster.rgba.push_back(255);
    }
  cairo_surface_destroy(surface);
  return raster;
}

template <typename Item>
std::vector<Item> itemsOf(const FigureDrawing& drawing) {
  std::vector<Item> items;
  for (const DrawingItem& item : drawing.items)
    if (const Item* one = std::get_if<Item>(&item)) items.push_back(*one);
  return items;
}

class FigureFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Each row: the reference with its inset, then for each representation picture, inset and error map.
  void picturesInsetsAndMaps() {
    const FigureDescription figure = figureWithInsets();
    const FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const auto pictures = itemsOf<PictureItem>(drawFigure(figure, measurement, halfWidth));
    QCOMPARE(pictures.size(), std::size_t(2 * (2 + 2 * 3) + 1));
    for (std::size_t row = 0; row < 2; ++row) {
      const Image& reference = *measurement.rows[row].reference;
      const Raster whole = displayedOnWhite(reference, figure.pictures);
      QVERIFY(pictures[8 * row].raster.rgba == whole.rgba);
      // Pixels 4 to 7 across and 8 to 11 down, as they are.
      const PictureItem& inset = pictures[8 * row + 1];
      QVERIFY(inset.exactPixels && !pictures[8 * row].exactPixels);
      QCOMPARE(inset.raster.width, 4);
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
          for (int c = 0; c < 4; ++c)
            QCOMPARE(inset.raster.rgba[std::size_t(4 * (4 * y + x) + c)],
                     whole.rgba[std::size_t(4 * (16 * (8 + y) + 4 + x) + c)]);
      for (std::size_t cell = 0; cell < 2; ++cell)
        QVERIFY(pictures[8 * row + 4 + 3 * cell].raster.rgba ==
                errorMap(reference, measurement.rows[row].cells[cell]->picture, errorMaximum(figure, measurement)));
    }
  }

  /// The page before the measurement: grey pictures at the same positions, no numbers, the frames of the insets.
  void whatIsMissingIsGrey() {
    const FigureDescription figure = figureWithInsets();
    const FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const FigureDrawing whole = drawFigure(figure, measurement, halfWidth);
    const FigureDrawing empty = drawFigure(figure, knownPart(figure, {}), halfWidth);
    const auto pictures = itemsOf<PictureItem>(empty), measured = itemsOf<PictureItem>(whole);
    QCOMPARE(pictures.size(), measured.size());
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
      QVERIFY(pictures[i].place == measured[i].place);
      QVERIFY(pictures[i].raster.rgba == (std::vector<std::uint8_t>{228, 228, 228, 255}));
    }
    const auto frames = itemsOf<FrameItem>(empty), expected = itemsOf<FrameItem>(whole);
    QVERIFY(std::ranges::equal(frames, expected, {}, &FrameItem::place, &FrameItem::place));
    const auto texts = itemsOf<TextItem>(empty);
    QVERIFY(std::ranges::find(texts, std::string("SNR"), &TextItem::text) != texts.end());
    QVERIFY(std::ranges::none_of(texts, [](const TextItem& item) { return item.text.ends_with(" dB"); }));
    QVERIFY(std::ranges::find(texts, std::string("luminance error (linear)"), &TextItem::text) != texts.end());
  }

  /// The raster for display has the pixels of the PNG file.
  void rasterHasThePixelsOfThePng() {
    const FigureDescription figure = figureWithInsets();
    const FigureDrawing drawing = drawFigure(figure, test::madeUpMeasurement(figure), halfWidth);
    const Raster raster = figureRaster(drawing, 100), expected = decodedPng(textOf(figurePng(drawing, 100)));
    QCOMPARE(raster.width, expected.width);
    QVERIFY(raster.rgba == expected.rgba);
  }

  void insetsAreOfWholePixels() {
    const InsetPixels pixels = insetPixels({0.5, 0.99, 0.001}, 100);
    QCOMPARE(pixels.side, 1);
    QCOMPARE(pixels.left, 50);
    QCOMPARE(pixels.top, 99);
    QCOMPARE(insetPixels({0, 0, 1}, 7).side, 7);
    const InsetPixels rounded = insetPixels({0.75, 0.5, 0.25}, 10);
    QVERIFY(rounded.left + rounded.side <= 10);
  }

  /// Transparent pixels are paper, covered ones are as they are displayed.
  void picturesAreOnPaper() {
    Image image(2, 1);
    image.pixels = {glm::vec3(0), glm::vec3(1, 0, 0)};
    image.alpha = {0, 1};
    const Raster raster = displayedOnWhite(image, {});
    QVERIFY(raster.rgba == (std::vector<std::uint8_t>{255, 255, 255, 255, 255, 0, 0, 255}));
  }

  /// A line covers the pixels between its points, in its colour; a text before it is not joined to it.
  void linesAreBetweenTheirPoints() {
    FigureDrawing drawing{.width = 25.4, .height = 25.4, .font = "Helvetica", .title = {}, .items = {}};
    drawing.items.emplace_back(TextItem{{1, 24}, "."});
    drawing.items.emplace_back(LineItem{{{5, 10}, {20, 10}}, "#ff0000", 2});
    const Raster raster = figureRaster(drawing, 100);  // 100 x 100 pixels
    const auto isWhite = [&](int x, int y) {
      const std::uint8_t* pixel = &raster.rgba[4 * (std::size_t(y) * std::size_t(raster.width) + std::size_t(x))];
      return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
    };
    const std::size_t middle = 4 * (39 * std::size_t(raster.width) + 50);
    QVERIFY(raster.rgba[middle] == 255 && raster.rgba[middle + 1] == 0 && raster.rgba[middle + 2] == 0);
    for (int x = 0; x < 100; ++x) QVERIFY(isWhite(x, 60) && isWhite(x, 30));
    QVERIFY(isWhite(15, 39) && isWhite(85, 39));
    const std::string svg = figureSvg(drawing);
    QVERIFY(svg.find("#ff0000") != std::string::npos && svg.find("dasharray") == std::string::npos);
    std::get<LineItem>(drawing.items.back()).dash = 1.5;
    QVERIFY(figureSvg(drawing).find("dasharray=\"1.5\"") != std::string::npos);
  }

  void theBestErrorsAreBold() {
    const FigureDescription figure = test::smallFigure();
    FigureMeasurement measurement = test::madeUpMeasurement(figure);
    FigureRow& row = measurement.rows[0];
    const double values[2][4] = {{30, 0.1, std::nan(""), 10}, {40, 0.2, std::nan(""), 20}};
    for (std::size_t cell = 0; cell < 2; ++cell)
      for (std::size_t k = 0; k < 4; ++k) test::setValue(row.cells[cell], figure.numbers[k], values[cell][k]);
    const auto best = [&](std::size_t cell, std::size_t number) { return isBest(figure, row, cell, number); };
    QVERIFY(!best(0, 0) && best(1, 0));
    QVERIFY(best(0, 1) && !best(1, 1));
    QVERIFY(!best(0, 2) && !best(1, 2));
    QVERIFY(!best(0, 3) && !best(1, 3));
    const auto texts = itemsOf<TextItem>(drawFigure(figure, measurement, halfWidth));
    const auto isBold = [&](const std::string& text) { return std::ranges::find(texts, text, &TextItem::text)->bold; };
    QVERIFY(isBold("40.0 dB") && !isBold("30.0 dB"));
    row.cells.pop_back();
    QVERIFY(!isBest(figure, row, 0, 0));
  }

  void svgIsXmlWithTextsAndPictures() {
    const FigureDescription figure = figureWithInsets();
    const FigureDrawing drawing = drawFigure(figure, test::madeUpMeasurement(figure), halfWidth);
    const std::string svg = figureSvg(drawing);
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    std::vector<Raster> pictures;
    QStringList texts;
    while (!reader.atEnd()) {
      reader.readNext();
      if (!reader.isStartElement()) continue;
      if (reader.name() == QLatin1String("svg"))
        QCOMPARE(reader.attributes().value("width").toString(), QString("177.00mm"));
      if (reader.name() == QLatin1String("image")) {
        const QString address = reader.attributes().value("xlink:href").toString();
        QVERIFY(address.startsWith("data:image/png;base64,"));
        pictures.push_back(decodedPng(QByteArray::fromBase64(address.mid(22).toLatin1()).toStdString()));
      }
      if (reader.name() == QLatin1String("text")) texts.push_back(reader.readElementText());
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    const auto items = itemsOf<PictureItem>(drawing);
    QCOMPARE(pictures.size(), items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      QCOMPARE(pictures[i].width, items[i].raster.width);
      QVERIFY(pictures[i].rgba == items[i].raster.rgba);
    }
    for (const char* text : {"50 % & <more>", "Reference", "blue rubber", "SNR", "Insets: magnified 2×"})
      QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
    QVERIFY(svg == figureSvg(drawing));
  }

  void pdfIsReproducible() {
    const FigureDescription figure = figureWithInsets();
    const FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const std::string pdf = textOf(figureFile(figure, measurement, FigureFormat::pdf));
    QVERIFY(pdf.starts_with("%PDF-1."));
    QVERIFY(pdf.ends_with("%%EOF\n"));
    // As wide as the columns, in points.
    QVERIFY(pdf.find("/MediaBox [ 0 0 501.7") != std::string::npos);
    QVERIFY(pdf.find("/FontFile") != std::string::npos);
    QVERIFY(pdf.find("CreationDate") == std::string::npos);
    QTest::qWait(1100);  // the next second
    QVERIFY(pdf == textOf(figureFile(figure, measurement, FigureFormat::pdf)));
  }

  /// The pixels of a picture that is drawn large stand in the page at their places.
  void pngHasThePage() {
    FigureDescription figure = test::smallFigure();
    figure.representations.resize(1);
    figure.errorMaps = false;
    const FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const Raster page = decodedPng(textOf(figureFile(figure, measurement, FigureFormat::png, 254)));
    QCOMPARE(page.width, 1770);
    const auto pixel = [&](int x, int y) {
      return &page.rgba[4 * (std::size_t(y) * std::size_t(page.width) + std::size_t(x))];
    };
    const auto texts = FigureTexts{.rowNames = {"chrome", "blue rubber"}, .errorScale = {}, .insetNote = {}};
    const PageRectangle place = layOutFigure(figure, texts, cairoTextWidth(figure.font)).cells[1][1].picture;
    const int left = int(std::lround(10 * place.x)), middle = int(10 * (place.y + place.height / 2));
    const Raster raster = displayedOnWhite(measurement.rows[1].cells[0]->picture, figure.pictures);
    const std::uint8_t* expected = &raster.rgba[4 * (16 * 8)];
    for (const int c : {0, 2}) {
      QVERIFY(std::abs(pixel(left + 2, middle)[c] - expected[c]) <= 2);
      QCOMPARE(int(pixel(left - 2, middle)[c]), 255);
    }
    for (const int c : {0, 1, 2}) QCOMPARE(int(pixel(page.width - 1, page.height - 1)[c]), 255);
  }

  void formatsBySuffix() {
    QVERIFY(figureFormatOf("a/b.PDF") == FigureFormat::pdf);
    QVERIFY(figureFormatOf("b.svg") == FigureFormat::svg);
    try {
      figureFormatOf("b.eps");
      QFAIL("accepted");
    } catch (const Error& error) {
      QCOMPARE(std::string(error.what()), std::string("b.eps: found the suffix '.eps', expected .pdf, .svg or .png"));
    }
  }

  void csvHasAllNumbers() {
    const FigureDescription figure = test::smallFigure();
    const FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const io::CsvText csv = io::readCsvText(io::toCsv(figureCsv(figure, measurement)));
    QCOMPARE(csv.rows.size(), std::size_t(4));
    QCOMPARE(csv.comments[0], std::string("pictures: sphere-studio, 16 x 16, 4 samples"));
    for (std::size_t i = 0; i < 4; ++i) {
      const FigureRow& row = measurement.rows[i / 2];
      QCOMPARE(csv.rows[i].fields[csv.requiredColumn("material")], rowLabel(figure, measurement, i / 2));
      QCOMPARE(csv.rows[i].fields[csv.requiredColumn("label")], figure.representations[i % 2].shownLabel());
      const char* titles[] = {"snr [db]", "flip", "log", "size [b]"};
      for (std::size_t k = 0; k < 4; ++k)
        QCOMPARE(csv.number(csv.rows[i], csv.requiredColumn(titles[k])), row.cells[i % 2]->value(figure.numbers[k]));
    }
  }

  void latexTable() {
    FigureDescription figure = test::smallFigure();
    figure.materials[1].label = "50%_rubber & {more}";
    figure.numbers = {"rendered-snr", "mse"};
    FigureMeasurement measurement = test::madeUpMeasurement(figure);
    const double values[2][2] = {{std::numeric_limits<double>::infinity(), 1.25e-5}, {20, 0.5}};
    for (std::size_t cell = 0; cell < 2; ++cell)
      for (std::size_t k = 0; k < 2; ++k)
        test::setValue(measurement.rows[0].cells[cell], figure.numbers[k], values[cell][k]);
    const std::string latex = figureLatex(figure, measurement);
    QVERIFY(latex.find("\\begin{tabular}{llrr}\n\\toprule\n") != std::string::npos);
    QVERIFY(latex.find("Material & Representation & SNR [dB] & MSE \\\\\n") != std::string::npos);
    QVERIFY(latex.find("library:sgd/chrome & GGX & {\\boldmath\\textbf{$\\infty$}} & "
                       "{\\boldmath\\textbf{$1.25\\times10^{-5}$}} \\\\\n") != std::string::npos);
    QVERIFY(latex.find(" & PDV & 20.0 & 0.500 \\\\\n\\midrule\n50\\%\\_rubber \\& \\{more\\} & ") != std::string::npos);
    QVERIFY(latex.ends_with("\\bottomrule\n\\end{tabular}\n"));
    QCOMPARE(latexText("a\\b~c^d#e$"),
             std::string("a\\textbackslash{}b\\textasciitilde{}c\\textasciicircum{}d\\#e\\$"));
  }
};

GONIO_TEST(FigureFilesTest)
}  // namespace figure_files_test

#include "figure_files_test.moc"
