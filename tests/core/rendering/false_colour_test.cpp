// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/error_maps.h"

#include <QTest>
#include <cmath>

#include "core/rendering/tone_map.h"
#include "tests/support/test_program.h"

namespace false_colour_test {
using namespace gonio;
using namespace gonio::rendering;

/// Relative luminance of a display colour.
double lightness(const DisplayColour& colour) {
  return 0.2126 * fromSrgb(colour[0] / 255.0) + 0.7152 * fromSrgb(colour[1] / 255.0) +
         0.0722 * fromSrgb(colour[2] / 255.0);
}

class FalseColourTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The published ends of viridis, and its reason of being: the value can be read from the lightness alone.
  void viridisGrowsLighter() {
    QCOMPARE(viridis(0), (DisplayColour{68, 1, 84}));
    QCOMPARE(viridis(1), (DisplayColour{253, 231, 37}));
    for (int i = 0; i < 64; ++i) QVERIFY(lightness(viridis((i + 1) / 64.0)) > lightness(viridis(i / 64.0)));
  }

  /// Darkest at 0, lighter with the magnitude, bluer below and redder above.
  void signedColourTellsSignAndMagnitude() {
    for (int i = 0; i < 32; ++i) {
      const double x = i / 32.0, next = (i + 1) / 32.0;
      QVERIFY(lightness(signedColour(next)) > lightness(signedColour(x)));
      QVERIFY(lightness(signedColour(-next)) > lightness(signedColour(-x)));
      QVERIFY(signedColour(next)[0] > signedColour(next)[2] && signedColour(-next)[2] > signedColour(-next)[0]);
    }
  }

  void valuesBeyondTheRangeAreCut() {
    QCOMPARE(viridis(-3), viridis(0));
    QCOMPARE(viridis(7), viridis(1));
    QCOMPARE(viridis(NAN), viridis(0));
    QCOMPARE(signedColour(-7), signedColour(-1));
    QCOMPARE(signedColour(7), signedColour(1));
  }
};

GONIO_TEST(FalseColourTest)
}  // namespace false_colour_test

#include "false_colour_test.moc"
