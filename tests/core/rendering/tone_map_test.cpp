// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/tone_map.h"

#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"

namespace tone_map_test {
using namespace gonio;
using namespace gonio::rendering;

class ToneMapTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void clampIsLinearUpToOne() {
    QCOMPARE(toneMapped(Rgb(0.25, 0.5, 3), 0, ToneMap::clamp), Rgb(0.25, 0.5, 1));
    QCOMPARE(toneMapped(Rgb(0.25, 0.1, 0), 1, ToneMap::clamp), Rgb(0.5, 0.2, 0));
    QCOMPARE(toneMapped(Rgb(0.25), -2, ToneMap::clamp), Rgb(0.0625));
  }

  void filmicRisesFromZeroToOne() {
    double last = -1;
    for (double x = 0; x < 50; x = x * 1.1 + 1e-4) {
      const double y = toneMapped(Rgb(x), 0, ToneMap::filmic).x;
      QVERIFY(y >= last && y >= 0 && y <= 1);
      last = y;
    }
    QCOMPARE(toneMapped(Rgb(0), 0, ToneMap::filmic), Rgb(0));
    QVERIFY(std::abs(toneMapped(Rgb(1), 0, ToneMap::filmic).x - 2.54 / 3.16) < 1e-12);
  }

  void radianceIsTheInverse() {
    for (const ToneMap toneMap : {ToneMap::clamp, ToneMap::filmic})
      for (const double stops : {-1.5, 0.0, 2.0})
        for (double x = 0; x < 0.2; x += 1e-3)
          QVERIFY(std::abs(radianceOf(toneMapped(Rgb(x), stops, toneMap).x, stops, toneMap) - x) < 1e-9);
    QCOMPARE(toneMapped(Rgb(radianceOf(1, 0, ToneMap::filmic) + 1e-9), 0, ToneMap::filmic).x, 1.0);
    QVERIFY(toneMapped(Rgb(radianceOf(1, 0, ToneMap::filmic) - 1e-3), 0, ToneMap::filmic).x < 1);
  }

  void hardCase42UndefinedRadianceIsBlackAndInfiniteIsWhite() {
    for (const ToneMap toneMap : {ToneMap::clamp, ToneMap::filmic}) {
      QCOMPARE(toneMapped(Rgb(double(NAN), -1, -0.0), 0, toneMap), Rgb(0));
      QCOMPARE(toneMapped(Rgb(1e30, 1e300, double(INFINITY)), 10, toneMap), Rgb(1));
    }
  }

  void srgbHasItsPublishedValuesAndInverse() {
    QCOMPARE(toSrgb(0), 0.0);
    QVERIFY(std::abs(toSrgb(1) - 1) < 1e-12);
    QVERIFY(std::abs(toSrgb(0.214041) - 0.5) < 1e-6);
    QVERIFY(std::abs(toSrgb(0.0031308) - 12.92 * 0.0031308) < 1e-9);
    // The standard's rounded constants leave a step of 3e-8 where the two pieces meet.
    for (double x = 0; x <= 1; x += 1e-3) QVERIFY(std::abs(fromSrgb(toSrgb(x)) - x) < 1e-7);
  }

  void bytesAreStraightAlpha() {
    Image image(2, 1);
    image.pixels = {glm::vec3(0.5f, 0.25f, 0), glm::vec3(0.125f)};
    const auto opaque = toDisplayBytes(image, 0, ToneMap::clamp);
    QCOMPARE(opaque, (std::vector<std::uint8_t>{188, 137, 0, 255, 99, 99, 99, 255}));
    image.alpha = {0.5f, 0};
    const auto transparent = toDisplayBytes(image, 0, ToneMap::clamp);
    QCOMPARE(transparent, (std::vector<std::uint8_t>{255, 188, 0, 128, 0, 0, 0, 0}));
  }
};

GONIO_TEST(ToneMapTest)
}  // namespace tone_map_test

#include "tone_map_test.moc"
