// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/figures/figure_layout.h"

#include <QTest>

#include "core/support/error.h"
#include "tests/core/figures/small_figure.h"
#include "tests/support/test_program.h"

namespace figure_layout_test {
using namespace gonio;
using namespace gonio::figures;

/// Every character half as wide as the font is high.
double halfWidth(std::string_view text, double size, bool) {
  return 0.5 * size * millimetresPerPoint * double(text.size());
}

FigureDescription figureOf(std::size_t representations, FigureWidth width, bool inset, bool errorMaps) {
  FigureDescription figure = test::smallFigure();
  figure.title = "A title";
  figure.width = width;
  figure.representations.resize(representations, figure.representations[0]);
  if (inset) figure.inset = FigureInset{};
  figure.errorMaps = errorMaps;
  return figure;
}

FigureTexts texts() {
  return {
      .rowNames = {"red-metallic-paint", "chrome"}, .errorScale = "0.05 luminance error", .insetNote = "Insets: 2x"};
}

/// All rectangles of a layout.
std::vector<PageRectangle> rectanglesOf(const FigureLayout& layout) {
  std::vector<PageRectangle> all;
  if (layout.title) all.push_back(layout.title->place);
  for (const auto* labels : {&layout.columnLabels, &layout.rowLabels})
    for (const LabelLayout& label : *labels) all.push_back(label.place);
  for (const auto& row : layout.cells)
    for (const CellLayout& cell : row) {
      all.push_back(cell.picture);
      all.push_back(cell.caption);
      if (cell.inset) all.push_back(*cell.inset);
      if (cell.errorMap) all.push_back(*cell.errorMap);
    }
  if (layout.legend) all.push_back(layout.legend->place);
  return all;
}

bool overlap(const PageRectangle& a, const PageRectangle& b) {
  constexpr double tolerance = 1e-9;
  return a.x + tolerance < b.right() && b.x + tolerance < a.right() && a.y + tolerance < b.bottom() &&
         b.y + tolerance < a.bottom();
}

class FigureLayoutTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nothingOverlapsOrLeavesThePage() {
    for (std::size_t representations = 1; representations <= 6; ++representations)
      for (const FigureWidth width : {FigureWidth::oneColumn, FigureWidth::twoColumns})
        for (int parts = 0; parts < 4; ++parts) {
          const FigureLayout layout =
              layOutFigure(figureOf(representations, width, parts & 1, parts & 2), texts(), halfWidth);
          const std::vector<PageRectangle> all = rectanglesOf(layout);
          QCOMPARE(layout.cells.size(), std::size_t(2));
          QCOMPARE(layout.cells[0].size(), representations + 1);
          QCOMPARE(layout.legend.has_value(), parts > 0);
          for (std::size_t i = 0; i < all.size(); ++i) {
            QVERIFY(all[i].x >= -1e-9 && all[i].right() <= layout.width + 1e-9);
            QVERIFY(all[i].y >= -1e-9 && all[i].bottom() <= layout.height + 1e-9);
            for (std::size_t j = 0; j < i; ++j)
              QVERIFY2(!overlap(all[i], all[j]),
                       qPrintable(QStringLiteral("%1 and %2 of %3").arg(i).arg(j).arg(representations)));
          }
        }
  }

  /// Lines are in their places and no wider than these.
  void labelsFit() {
    const FigureLayout layout = layOutFigure(figureOf(6, FigureWidth::oneColumn, true, true), texts(), halfWidth);
    for (const LabelLayout& label : layout.columnLabels)
      for (std::size_t i = 0; i < label.lines.size(); ++i) {
        QVERIFY(halfWidth(label.lines[i], layout.fontSize, true) <= label.place.width + 1e-9);
        QVERIFY(label.at[i].y > label.place.y && label.at[i].y < label.place.bottom());
      }
    for (const LabelLayout& label : layout.rowLabels)
      for (const std::string& line : label.lines)
        QVERIFY(halfWidth(line, layout.fontSize, true) <= label.place.height + 1e-9);
    const LegendLayout& legend = *layout.legend;
    QVERIFY(legend.errorScale.x + halfWidth(texts().errorScale, layout.fontSize, false) <= layout.width);
  }

  void picturesAreSquareAndAligned() {
    const FigureLayout layout = layOutFigure(figureOf(3, FigureWidth::twoColumns, true, true), texts(), halfWidth);
    for (const auto& row : layout.cells)
      for (std::size_t column = 0; column < row.size(); ++column) {
        const CellLayout& cell = row[column];
        QCOMPARE(cell.picture.width, cell.picture.height);
        QCOMPARE(cell.picture.x, layout.cells[0][column].picture.x);
        QCOMPARE(cell.picture.y, row[0].picture.y);
        QCOMPARE(cell.inset->width, cell.errorMap->width);
        QCOMPARE(cell.inset->x, cell.picture.x);
        QCOMPARE(cell.errorMap->right(), cell.picture.right());
      }
    QCOMPARE(layout.width, 177.0);
    QCOMPARE(layout.fontSize, 8.0);
    QCOMPARE(layout.cells[0].back().picture.right(), layout.width);
  }

  void tooManyColumnsAreRefused() {
    try {
      layOutFigure(figureOf(12, FigureWidth::oneColumn, false, false), texts(), halfWidth);
      QFAIL("accepted");
    } catch (const Error& error) {
      QVERIFY(std::string(error.what()).find("12 representations in a figure 84 mm wide, expected fewer") !=
              std::string::npos);
    }
    layOutFigure(figureOf(12, FigureWidth::twoColumns, false, false), texts(), halfWidth);
  }

  /// By hand: characters are 1 mm wide.
  void lines() {
    const double size = 2 / millimetresPerPoint;
    const auto broken = [&](const char* text, double most) { return brokenLines(text, most, size, halfWidth); };
    using Lines = std::vector<std::string>;
    QVERIFY(broken("PDV factors, three", 18) == Lines{"PDV factors, three"});
    QVERIFY(broken("PDV factors, three", 12) == (Lines{"PDV factors,", "three"}));
    QVERIFY(broken("red-metallic_paint", 10) == (Lines{"red-", "metallic_", "paint"}));
    QVERIFY(broken("abcdefgh ij", 3) == (Lines{"abc", "def", "gh", "ij"}));
    QVERIFY(broken("", 3) == Lines{""});
    // Characters are never cut: two bytes each.
    QVERIFY(broken("äöü", 4) == (Lines{"äö", "ü"}));
  }

  void bothWidthsHaveTheirFont() {
    FigureDescription figure = figureOf(2, FigureWidth::oneColumn, false, true);
    QCOMPARE(layOutFigure(figure, texts(), halfWidth).width, 84.0);
    QCOMPARE(layOutFigure(figure, texts(), halfWidth).fontSize, 7.0);
    figure.fontSize = 6;
    QCOMPARE(layOutFigure(figure, texts(), halfWidth).fontSize, 6.0);
  }
};

GONIO_TEST(FigureLayoutTest)
}  // namespace figure_layout_test

#include "figure_layout_test.moc"
