// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"
#include "tests/widgets/pixels.h"
#include "tests/widgets/pointer.h"
#include "widgets/acquisition/error_curve.h"
#include "widgets/acquisition/half_difference_chart.h"
#include "widgets/acquisition/hemisphere_chart.h"
#include "widgets/acquisition/reconstruction_view.h"

namespace acquisition_charts_test {
using namespace gonio;
using namespace gonio::widgets;

DirectionPair pair(double thetaI, double phiI, double thetaO, double phiO) {
  return {fromSpherical(radians(thetaI), radians(phiI)), fromSpherical(radians(thetaO), radians(phiO))};
}

/// Apart from one another in both charts.
std::vector<DirectionPair> samples() {
  return {pair(45, 0, 45, 180), pair(30, 90, 60, 45), fromHalfDifference(radians(22.5), radians(60), radians(90))};
}

HalfDifferenceSlice slice(int thetaHCount, int thetaDCount) {
  HalfDifferenceSlice slice{.thetaHCount = thetaHCount, .thetaDCount = thetaDCount, .states = {}, .deviations = {}};
  slice.states.resize(std::size_t(thetaHCount * thetaDCount));
  return slice;
}

template <class Chart>
struct Shown {
  Chart chart;
  Shown() {
    chart.resize(420, 400);
    chart.show();
    chart.setSamples(samples());
  }
  QColor colourAt(const QPointF& place) { return chart.grab().toImage().pixelColor(place.toPoint()); }
};

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

class AcquisitionChartsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// While there is no reconstruction, the hint stands above the picture of the material, not on it.
  void theHintIsAboveThePicture() {
    ReconstructionView view;
    view.resize(300, 300);
    QImage picture(64, 64, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    view.setContent({.reference = picture, .referenceName = "red"});
    const double unhinted = view.squares().front().top();
    view.setHint(QStringLiteral("Press Start to choose directions and to reconstruct the material from its values."));
    const QRectF square = view.squares().front();
    QVERIFY(square.top() > unhinted && square.top() >= 2 * view.fontMetrics().height());
    QVERIFY(square.bottom() < view.height());
    const QImage shown = view.grab().toImage();
    QVERIFY(shown.pixelColor(square.center().toPoint()) == QColor(Qt::red));
    view.setHint({});
    QCOMPARE(view.squares().front().top(), unhinted);
  }

  /// The polar angle is even along the radius, the azimuth turns against the clock.
  void theHemisphereIsSeenFromAbove() {
    Shown<HemisphereChart> shown;
    const QPointF pole = shown.chart.placeOf({0, 0, 1});
    const QPointF rim = shown.chart.placeOf({1, 0, 0}), up = shown.chart.placeOf({0, 1, 0});
    const double radius = rim.x() - pole.x();
    QVERIFY(radius > 100);
    QVERIFY(std::abs(rim.y() - pole.y()) < 1e-9 && std::abs(up.x() - pole.x()) < 1e-9);
    QVERIFY(std::abs(pole.y() - up.y() - radius) < 1e-9);
    const QList<QPointF> first = shown.chart.places(0);
    QVERIFY(distance(first[0], pole + QPointF(radius / 2, 0)) < 1e-6);
    QVERIFY(distance(first[1], pole - QPointF(radius / 2, 0)) < 1e-6);
    const double diagonal = radius * 60 / 90 / std::sqrt(2.0);
    QVERIFY(distance(shown.chart.places(1)[1], pole + QPointF(diagonal, -diagonal)) < 1e-6);
    QVERIFY(QRectF(shown.chart.rect()).contains(QRectF(pole - QPointF(radius, radius), QSizeF(2, 2) * radius)));
  }

  /// Light and viewer are drawn at places(), in different colours, with a line between them.
  void bothDotsAndTheirLineAreDrawn() {
    Shown<HemisphereChart> shown;
    const QList<QPointF> at = shown.chart.places(1);
    const QColor light = shown.colourAt(at[0]), viewer = shown.colourAt(at[1]);
    QVERIFY(light != viewer);
    const QImage with = shown.chart.grab().toImage();
    shown.chart.setSamples({});
    const QImage without = shown.chart.grab().toImage();
    const auto changed = [&](const QPointF& place) {
      int count = 0;
      for (const QPoint& by : {QPoint(0, 0), QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
        count += with.pixel(place.toPoint() + by) != without.pixel(place.toPoint() + by);
      return count > 0;
    };
    QVERIFY(changed(at[0]) && changed(at[1]));
    for (const double fraction : {0.25, 0.5, 0.75}) QVERIFY(changed(at[0] + fraction * (at[1] - at[0])));
    QVERIFY(!changed(at[1] + 0.25 * (at[1] - at[0])));
  }

  void theLimitOfTheRigIsShaded() {
    Shown<HemisphereChart> shown;
    shown.chart.setSamples({});
    const QImage before = shown.chart.grab().toImage();
    shown.chart.setMaxPolarAngle(radians(70));
    const QImage after = shown.chart.grab().toImage();
    const QPointF pole = shown.chart.placeOf({0, 0, 1}), rim = shown.chart.placeOf({1, 0, 0});
    int changedInside = 0, changedBeyond = 0;
    for (int y = 0; y < int(pole.y()); ++y)
      for (int x = 0; x < before.width(); ++x) {
        if (before.pixel(x, y) == after.pixel(x, y)) continue;
        const double fraction = distance({x + 0.5, y + 0.5}, pole) / (rim.x() - pole.x());
        (fraction < 70 / 90.0 - 0.01 ? changedInside : changedBeyond) += 1;
      }
    QCOMPARE(changedInside, 0);
    QVERIFY(changedBeyond > 100);
  }

  /// theta_d to the right, theta_h upward by its square root.
  void halfDifferenceAnglesHaveTheSpacingOfTables() {
    Shown<HalfDifferenceChart> shown;
    HalfDifferenceChart& chart = shown.chart;
    const QPointF corner = chart.placeOf(0, 0), opposite = chart.placeOf(halfPi, halfPi);
    const double width = opposite.x() - corner.x(), height = corner.y() - opposite.y();
    QVERIFY(width > 150 && height > 150);
    QVERIFY(distance(chart.places(2)[0], corner + QPointF(width * 60 / 90, -height * 0.5)) < 1e-6);
    // Mirror directions: theta_h = 0 but for rounding, of which the axis takes the root.
    QVERIFY(distance(chart.places(0)[0], corner + QPointF(width / 2, 0)) < 1e-3);
    // Whose phi_d is 90 degrees, and whose has none, lies in the slice at 90; at another slice only the latter.
    QVERIFY(chart.isInSlice(0) && chart.isInSlice(2));
    HalfDifferenceSlice other = slice(4, 4);
    other.phiD = radians(30);
    chart.setSlice(other);
    QVERIFY(chart.isInSlice(0) && !chart.isInSlice(2));
    // phi_d has the period pi: 175 degrees lie beside 0.
    chart.setSamples({fromHalfDifference(radians(20), radians(20), radians(175))});
    other.phiD = 0;
    chart.setSlice(other);
    QVERIFY(chart.isInSlice(0));
  }

  void cellsAreShadedByTheirState() {
    Shown<HalfDifferenceChart> shown;
    HalfDifferenceChart& chart = shown.chart;
    chart.setSamples({});
    HalfDifferenceSlice cells = slice(4, 5);
    chart.setSlice(cells);
    const QImage before = chart.grab().toImage();
    const auto changed = [&](int i, int j) {
      const QImage now = chart.grab().toImage();
      int count = 0;
      const QPoint at = chart.cellCentre(i, j).toPoint();
      for (int y = -15; y <= 15; ++y)
        for (int x = -15; x <= 15; ++x) count += now.pixel(at + QPoint(x, y)) != before.pixel(at + QPoint(x, y));
      return count;
    };
    int covered[4];
    for (const int state : {1, 2, 3, 4}) {
      cells.states.assign(cells.states.size(), CellState::measurable);
      cells.states[1 * 5 + 3] = CellState(state);
      chart.setSlice(cells);
      QCOMPARE(changed(0, 3), 0);
      QCOMPARE(changed(2, 3), 0);
      QCOMPARE(changed(1, 2), 0);
      covered[state - 1] = changed(1, 3);
      QVERIFY(covered[state - 1] > 50);
    }
    // By four different hatchings.
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) QVERIFY(covered[a] != covered[b]);
    QCOMPARE(chart.cellAt(chart.cellCentre(1, 3)), 1 * 5 + 3);
    QCOMPARE(chart.cellAt(QPointF(1, 1)), -1);
  }

  void deviationsHaveTheColoursOfTheScale() {
    Shown<HalfDifferenceChart> shown;
    HalfDifferenceChart& chart = shown.chart;
    chart.setSamples({});
    HalfDifferenceSlice cells = slice(2, 2);
    const float none = std::nanf("");
    cells.deviations = {0, 0.5f, 7, none};
    chart.setSlice(cells);
    chart.setRange(1);
    const QColor paper = chart.palette().color(QPalette::Base);
    const QColor least = shown.colourAt(chart.cellCentre(0, 0)), most = shown.colourAt(chart.cellCentre(1, 0));
    const QColor middle = shown.colourAt(chart.cellCentre(0, 1));
    QCOMPARE(least, QColor(68, 1, 84));
    QCOMPARE(most, QColor(253, 231, 37));
    QVERIFY(middle.lightness() > least.lightness() && middle.lightness() < most.lightness());
    QCOMPARE(shown.colourAt(chart.cellCentre(1, 1)), paper);
  }

  void thePointerAndTheKeysGoFromSampleToSample() {
    Shown<HemisphereChart> shown;
    QSignalSpy moved(&shown.chart, &SampleChart::currentChanged), chosen(&shown.chart, &SampleChart::chosen);
    test::pointAt(shown.chart, (shown.chart.places(1)[1] + QPointF(2, 1)).toPoint());
    QCOMPARE(shown.chart.current(), 1);
    test::pointAt(shown.chart, shown.chart.placeOf({0, 0, 1}).toPoint());
    QCOMPARE(shown.chart.current(), 1);  // between samples the mark stays
    QCOMPARE(moved.count(), 1);
    QTest::keyClick(&shown.chart, Qt::Key_Right);
    QTest::keyClick(&shown.chart, Qt::Key_Right);
    QCOMPARE(shown.chart.current(), 2);
    QTest::keyClick(&shown.chart, Qt::Key_Home);
    QCOMPARE(moved.last()[0].toInt(), 0);
    QTest::keyClick(&shown.chart, Qt::Key_Return);
    QCOMPARE(chosen.last()[0].toInt(), 0);
    QTest::mouseClick(&shown.chart, Qt::LeftButton, {}, shown.chart.places(2)[0].toPoint());
    QCOMPARE(chosen.last()[0].toInt(), 2);
    // On nothing: no mark.
    QTest::mouseClick(&shown.chart, Qt::LeftButton, {}, shown.chart.placeOf({0, 0, 1}).toPoint());
    QCOMPARE(shown.chart.current(), -1);
    shown.chart.setSamples({});
    QTest::keyClick(&shown.chart, Qt::Key_Right);
    QCOMPARE(shown.chart.current(), -1);
  }

  void aMarkedSampleIsDrawnOtherwise() {
    Shown<HalfDifferenceChart> shown;
    const QPointF at = shown.chart.places(2)[0];
    const PlotStyle style = PlotStyle::of(shown.chart.palette());
    QCOMPARE(shown.colourAt(at), style.text);
    shown.chart.setCurrent(2);
    QCOMPARE(shown.colourAt(at), style.accent);
    shown.chart.setCurrent(-1);
    QCOMPARE(shown.colourAt(at), style.text);
    shown.chart.setSamples({samples()[0]});
    QCOMPARE(shown.chart.current(), -1);
  }

  void sampleTextTellsAllAngles() {
    const QString text = sampleText(7, pair(30, 0, 30, 180));
    QCOMPARE(text, "7: light θi 30.0°, φi 0.0° · viewer θo 30.0°, φo 180.0° · θh 0.0°, θd 30.0°, φd 0.0°");
  }

  void theCurveGoesUpWithItsValues() {
    ErrorCurve curve;
    curve.resize(400, 300);
    curve.show();
    curve.setPoints({{40, 30}, {5, 10}, {20, 20}, {60, std::nan("")}}, "rendered SNR [dB]");
    QTest::qWait(0);
    QVERIFY(curve.place(0)->x() < curve.place(1)->x() && curve.place(1)->x() < curve.place(2)->x());
    QVERIFY(curve.place(0)->y() > curve.place(1)->y() && curve.place(1)->y() > curve.place(2)->y());
    QVERIFY(!curve.place(3) && !curve.place(4) && !curve.place(-1));
    QCOMPARE(curve.pointAt(*curve.place(1) + QPointF(3, -2)), 1);
    QCOMPARE(curve.pointAt((*curve.place(1) + *curve.place(2)) / 2), -1);
    QTest::qWait(0);
    // Each point is a dot in the colour of fits; that of 20 samples gets a ring in the accent's colour, no other does.
    const PlotStyle style = PlotStyle::of(curve.palette());
    const auto ringed = [&](int point) { return test::colouredAround(curve, *curve.place(point), 7.5, style.accent); };
    for (const int point : {0, 1, 2}) {
      const QColor dot = curve.grab().toImage().pixelColor(curve.place(point)->toPoint());
      QVERIFY(test::isNear(dot, style.colour(SeriesRole::fit)));
      QVERIFY(ringed(point) < 0.4);  // where the line crosses
    }
    curve.setMarked(20);
    QTest::qWait(0);
    QVERIFY(ringed(1) > 0.9 && ringed(0) < 0.4 && ringed(2) < 0.4);
  }
};

GONIO_TEST(AcquisitionChartsTest)
}  // namespace acquisition_charts_test

#include "acquisition_charts_test.moc"
