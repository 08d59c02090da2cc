// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/curves/residual_strip.h"

#include <QTest>
#include <algorithm>

#include "tests/support/test_program.h"
#include "widgets/curves/curve_editor.h"

namespace residual_strip_test {
using namespace gonio::widgets;

class ResidualStripTest : public QObject {
  Q_OBJECT
 private:
  CurveEditor m_editor;

  QString reported(std::vector<double> fractions) {
    ResidualStrip strip(m_editor);
    strip.setFractions(fractions, "1 term");
    return strip.accessibleDescription();
  }

 private Q_SLOTS:
  void initTestCase() {
    const std::vector<double> curve(3, 1.0);
    m_editor.setCurves({0, 0.5, 1}, {curve, curve, curve}, {});
  }

  /// Two digits or so of any fraction, none with an exponent.
  void sharesAreWrittenForPeople() {
    for (const auto& [fraction, text] : {std::pair(1.0, "100 %"),
                                         {2.34, "234 %"},
                                         {0.5, "50 %"},
                                         {0.123, "12 %"},
                                         {0.036, "3.6 %"},
                                         {0.01, "1 %"},
                                         {0.00071, "0.07 %"},
                                         {0.0, "0 %"}})
      QVERIFY2(reported({0, fraction, 0}).contains(QString("at most %1,").arg(text)),
               qPrintable(reported({0, fraction, 0})));
  }

  /// The scale is a round share above the largest.
  void theScaleHoldsTheLargest() {
    ResidualStrip strip(m_editor);
    for (const auto& [largest, scale] : {std::pair(0.004, 0.01), {0.05, 0.05}, {0.051, 0.1}, {0.7, 1.0}, {3.0, 1.0}}) {
      strip.setFractions({0, largest, 0}, "1 term");
      QCOMPARE(strip.scale(), scale);
    }
  }

  /// The area ends at the fraction of the scale; what is above 1 at the frame's top.
  void theAreaHasTheHeightOfTheFractions() {
    ResidualStrip strip(m_editor);
    strip.resize(m_editor.width(), 100);
    const double top = strip.fontMetrics().height(), bottom = strip.height() - 3;
    const QColor paper = PlotStyle::of(strip.palette()).background;
    for (const double fraction : {0.25, 0.5, 0.75, 3.0}) {
      strip.setFractions({1, fraction, 1}, "1 term");
      const QImage picture = strip.grab().toImage();
      const int x = int(m_editor.toX(0.5));
      const double edge = bottom - std::min(1.0, fraction) * (bottom - top);
      QVERIFY(picture.pixelColor(x, int(edge) + 6) != paper && picture.pixelColor(x, int(bottom) - 4) != paper);
      if (fraction < 1) QCOMPARE(picture.pixelColor(x, int(edge) - 6), paper);
    }
  }
};

GONIO_TEST(ResidualStripTest)
}  // namespace residual_strip_test

#include "residual_strip_test.moc"
