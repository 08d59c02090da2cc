// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/error_maps.h"

#include <QTest>

#include "core/math/round_number.h"
#include "tests/support/test_program.h"

namespace error_maps_test {
using namespace gonio;
using namespace gonio::rendering;

Image grey(float value, int side = 20) {
  Image image(side, side);
  image.pixels.assign(image.pixels.size(), glm::vec3(value));
  return image;
}

class ErrorMapsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// One scale for all: the difference of 0.4 has the last colour of 0.5, that of 0.1 a fifth.
  void oneScaleForAll() {
    const std::vector<Image> pictures{grey(0.6f), grey(0.9f), grey(0.5f)};
    const double range = errorRange(grey(0.5f), pictures);
    QCOMPARE(range, 0.5);
    const auto colourOf = [&](std::size_t i) {
      const auto map = errorMap(grey(0.5f), pictures[i], range);
      return DisplayColour{map[0], map[1], map[2]};
    };
    QCOMPARE(colourOf(0), viridis(double(0.1f) / 0.5));
    QCOMPARE(colourOf(1), viridis(double(0.4f) / 0.5));
    QCOMPARE(colourOf(2), viridis(0));
    QCOMPARE(errorMap(grey(0.5f), pictures[0], range).size(), std::size_t(4 * 20 * 20));
  }

  /// Few noisy pixels do not set the scale; the background has no colour.
  void outliersAndBackground() {
    Image reference = grey(0.5f), picture = grey(0.55f);
    reference.alpha.assign(reference.pixels.size(), 1);
    reference.alpha[1] = 0;
    picture.pixels[0] = glm::vec3(50);
    const double range = errorRange(reference, std::span(&picture, 1));
    QCOMPARE(range, 0.1);
    const auto map = errorMap(reference, picture, range);
    QCOMPARE(int(map[3]), 255);
    QCOMPARE(int(map[7]), 0);
  }

  void equalPicturesHaveNoScale() {
    const Image picture = grey(0.5f);
    QCOMPARE(errorRange(picture, std::span(&picture, 1)), 0.0);
    QCOMPARE(errorMap(picture, picture, 0)[0], viridis(0)[0]);
    QCOMPARE(errorRange(picture, {}), 0.0);
  }

  void roundsUp() {
    const std::pair<double, double> cases[] = {{0, 0},      {1, 1},      {1.01, 2},    {0.2, 0.2},
                                               {0.21, 0.5}, {0.51, 1.0}, {3e-5, 5e-5}, {70, 100}};
    for (const auto& [value, rounded] : cases) QCOMPARE(roundedUp(value), rounded);
  }
};

GONIO_TEST(ErrorMapsTest)

}  // namespace error_maps_test

#include "error_maps_test.moc"
