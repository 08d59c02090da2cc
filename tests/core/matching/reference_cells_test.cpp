// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/reference_cells.h"

#include <QTest>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace reference_cells_test {
using namespace gonio;
using namespace gonio::matching;
using enum ReferenceCells::Known;

/// A ramp along x, whose mean over any range is its value in the middle.
ReferencePicture ramp() {
  Image image(100, 80);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x) image.at(x, y) = glm::vec3(float(x) + 0.5f, 1.f, float(y) + 0.5f);
  return {std::move(image), {50.3, 40.6, 30}};
}

class ReferenceCellsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The ramps' means are their values in the middle of the cells.
  void cellsAreMeansOfTheirPixels() {
    const ReferenceCells cells = referenceCells(ramp(), 10);
    QCOMPARE(cells.side, 11);
    QCOMPARE(cells.values.size(), std::size_t(121));
    std::size_t used = 0;
    for (int row = 0; row < 11; ++row)
      for (int column = 0; column < 11; ++column) {
        const std::size_t cell = std::size_t(11 * row + column);
        // The middle of the cell in pixels, and relative to the disc.
        const double x = 20 + 6 * (column + 0.5), y = 10 + 6 * (row + 0.5);
        const glm::dvec2 place =
            cells.centre + cells.halfSize * glm::dvec2((column + 0.5) / 5.5 - 1, 1 - (row + 0.5) / 5.5);
        QVERIFY(glm::length(glm::dvec2(x - 50.3, 40.6 - y) / 30.0 - place) < 1e-12);
        QCOMPARE(cells.isUsed(cell), std::hypot(std::abs(x - 50.3) + 3, std::abs(y - 40.6) + 3) <= 0.97 * 30);
        if (!cells.isUsed(cell)) continue;
        ++used;
        QCOMPARE(cells.values[cell], Rgb(x, 1, y));
      }
    QVERIFY(used > 40);
  }

  void clippedValuesAreLowerBounds() {
    ReferencePicture picture = ramp();
    picture.clip = 60;
    for (glm::vec3& pixel : picture.image.pixels) pixel = glm::min(pixel, glm::vec3(60));
    const ReferenceCells cells = referenceCells(picture, 10);
    // In row 5: the columns begin at 50, 56 and 62.
    QVERIFY(cells.known[60] == (std::array{yes, yes, yes}));
    QVERIFY(cells.known[61] == (std::array{no, yes, yes}));
    QVERIFY(cells.known[62] == (std::array{atLeast, yes, yes}));
  }

  void whatIsNotFiniteIsNotKnown() {
    ReferencePicture picture = ramp();
    picture.image.at(50, 40).y = std::numeric_limits<float>::quiet_NaN();
    const ReferenceCells cells = referenceCells(picture, 10);
    QCOMPARE(std::ranges::count(cells.known, std::array{no, no, no}),
             std::ranges::count(referenceCells(ramp(), 10).known, std::array{no, no, no}) + 1);
  }

  void unsuitablePicturesAreRefused() {
    ReferencePicture picture = ramp();
    picture.disc = {500, 40, 30};
    QVERIFY_THROWS_EXCEPTION(Error, referenceCells(picture, 10));
    picture.disc = {50, 40, 30};
    picture.image = Image(100, 80);
    QVERIFY_THROWS_EXCEPTION(Error, referenceCells(picture, 10));
  }
};

GONIO_TEST(ReferenceCellsTest)
}  // namespace reference_cells_test

#include "reference_cells_test.moc"
