// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QSignalSpy>
#include <QWheelEvent>
#include <cmath>

#include "tests/support/test_program.h"
#include "tests/widgets/pixels.h"
#include "tests/widgets/plot_test_support.h"

namespace plots_test {
using namespace gonio;
using namespace gonio::widgets;
using namespace gonio::widgets::test_support;

/// Contrast of WCAG 2.1.
double contrast(const QColor& a, const QColor& b) {
  const auto light = [](const QColor& colour) {
    const auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return luminance({linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())}) + 0.05;
  };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

class PlotsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void emptyPlotsShowTheirHint() {
    PolarPlot plot;
    plot.setHint("Open a material.");
    plot.show();
    QVERIFY(plot.isEmpty());
    QVERIFY(plot.findChildren<QLabel*>().last()->isVisible());
    plot.setSeries(twoSeries(lobeCurve));
    QVERIFY(!plot.findChildren<QLabel*>().last()->isVisible());
  }

  /// Reflectances of 1 and 1/2: in the direction of the normal one lobe is twice as long as the other.
  void polarCurvesAreAsLongAsTheirValues() {
    const auto plot = polarPlot();
    const PolarGeometry place = PolarGeometry::filling(plot->size(), plot->fontMetrics().height());
    const QImage picture = plot->grab().toImage();
    const auto length = [&](SeriesRole role) {
      const QColor colour = PlotStyle::of(plot->palette()).colour(role);
      double longest = 0;
      for (int y = 0; y < int(place.centre.y()) - 5; ++y)
        for (int x = -12; x <= 12; ++x)  // the lines are broken
          if (const QPoint at(int(place.centre.x()) + x, y);
              place.fractionOf(at) <= 1 && test::isNear(picture.pixelColor(at), colour))
            longest = std::max(longest, place.fractionOf(at));
      return longest;
    };
    const double measured = length(SeriesRole::measured), edited = length(SeriesRole::edited);
    QVERIFY2(edited > 0.1 && std::abs(measured / edited - 2) < 0.1,
             qPrintable(QString("%1 %2").arg(measured).arg(edited)));
  }

  /// In each column the curve of the larger reflectance is the higher one; both cross the chart.
  void largerValuesAreHigher() {
    for (Plot* plot : {static_cast<Plot*>(cartesianPlot().release()), static_cast<Plot*>(albedoPlot().release())}) {
      const std::unique_ptr<Plot> owner(plot);
      const QImage picture = plot->grab().toImage();
      const PlotStyle style = PlotStyle::of(plot->palette());
      int columns = 0;
      for (int x = picture.width() / 5; x < picture.width() * 3 / 5; ++x) {
        std::optional<int> measured, edited;
        for (int y = 0; y < picture.height() * 4 / 5; ++y) {  // the legend is above the curves
          if (test::isNear(picture.pixelColor(x, y), style.colour(SeriesRole::measured))) measured = y;
          if (test::isNear(picture.pixelColor(x, y), style.colour(SeriesRole::edited))) edited = y;
        }
        if (!measured || !edited) continue;
        ++columns;
        QVERIFY2(*measured < *edited, qPrintable(plot->title()));
      }
      QVERIFY2(columns > 40, qPrintable(QString("%1 %2").arg(plot->title()).arg(columns)));
    }
  }

  /// The larger reflectance is the brighter slice; below the horizon there is nothing.
  void slicesAreAsBrightAsTheirValues() {
    const auto slice = slicePlot();
    const QImage picture = slice->grab().toImage();
    const auto at = [&](std::size_t panel, double thetaH, double thetaD) {
      return picture.pixelColor(slice->position(panel, radians(thetaH), radians(thetaD)).toPoint());
    };
    for (const double thetaD : {5.0, 20.0, 35.0})
      QVERIFY(at(0, 10, thetaD).lightness() > at(1, 10, thetaD).lightness());
    QVERIFY(at(0, 80, 80) != at(0, 10, 20));
    QCOMPARE(at(0, 80, 80), at(1, 80, 80));
  }

  /// Side by side at one scale, a lobe of half the values covers less.
  void lobesAreAsLargeAsTheirValues() {
    const auto lobe = lobePlot();
    const QImage picture = lobe->grab().toImage();
    const QColor paper = PlotStyle::of(lobe->palette()).background;
    const auto covered = [&](int left) {
      int count = 0;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = left; x < left + picture.width() / 2; ++x) count += !test::isNear(picture.pixelColor(x, y), paper);
      return count;
    };
    const double ratio = double(covered(0)) / covered(picture.width() / 2);
    QVERIFY2(ratio > 1.5 && ratio < 5, qPrintable(QString::number(ratio)));
  }

  void arrowKeysTurnTheAngleOfIncidence() {
    for (const auto& plot : allPlots()) {
      QSignalSpy edited(plot.get(), &Plot::thetaIEdited);
      QTest::keyClick(plot.get(), Qt::Key_Right);
      QTest::keyClick(plot.get(), Qt::Key_Left, Qt::ShiftModifier);
      QCOMPARE(edited.count(), 2);
      QVERIFY(std::abs(edited[0][0].toDouble() - radians(31)) < 1e-12);
      QVERIFY(std::abs(edited[1][0].toDouble() - radians(29.9)) < 1e-12);
    }
  }

  void theLightIsDragged() {
    const auto plot = polarPlot();
    QSignalSpy edited(plot.get(), &Plot::thetaIEdited);
    const PolarGeometry place = PolarGeometry::filling(plot->size(), plot->fontMetrics().height());
    QVERIFY(std::abs(place.angleOf(place.at(-0.4, 0.7)) + 0.4) < 1e-12);
    drag(*plot, plot->handle(), place.at(radians(-60), 0.8));
    QVERIFY(edited.count() > 0);
    QVERIFY(std::abs(edited.last()[0].toDouble() - radians(60)) < radians(0.5));
    drag(*plot, plot->handle(), place.at(radians(20), 0.8));  // beyond the normal
    QCOMPARE(edited.last()[0].toDouble(), 0.0);
    edited.clear();
    drag(*plot, place.at(radians(50), 0.5), place.at(radians(60), 0.5));  // elsewhere: pans
    QCOMPARE(edited.count(), 0);
  }

  void theLineIsDragged() {
    for (auto plot :
         {static_cast<CurveChart*>(cartesianPlot().release()), static_cast<CurveChart*>(albedoPlot().release())}) {
      const std::unique_ptr<CurveChart> owner(plot);
      QSignalSpy edited(plot, &Plot::thetaIEdited);
      drag(*plot, plot->handle(), plot->handle() + QPointF(40, 5));
      QCOMPARE(edited.count(), 1);
      QVERIFY(edited[0][0].toDouble() > radians(32));
    }
    const auto slice = slicePlot();
    QSignalSpy edited(slice.get(), &Plot::thetaIEdited);
    drag(*slice, slice->position(0, 0.5, radians(30)), slice->position(0, 0.5, radians(70)));
    QCOMPARE(edited.count(), 1);
    QVERIFY(std::abs(edited[0][0].toDouble() - radians(70)) < radians(1));
  }

  void theValueUnderThePointerIsShownWithItsUnit() {
    const auto polar = polarPlot();
    const PolarGeometry place = PolarGeometry::filling(polar->size(), polar->fontMetrics().height());
    moveTo(*polar, place.at(0, 0.5), Qt::NoButton);
    QVERIFY2(readout(*polar).contains("θo = 0.0°") && readout(*polar).contains("measured: 0.3183 1/sr"),
             qPrintable(readout(*polar)));
    const auto cartesian = cartesianPlot();
    moveTo(*cartesian, QRectF(cartesian->rect()).center(), Qt::NoButton);
    QVERIFY2(readout(*cartesian).contains("1/sr"), qPrintable(readout(*cartesian)));
    const auto slice = slicePlot();
    moveTo(*slice, slice->position(1, radians(10), radians(20)), Qt::NoButton);
    QVERIFY2(readout(*slice).contains("θd = 20") && readout(*slice).contains("1/sr"), qPrintable(readout(*slice)));
    moveTo(*slice, slice->position(1, radians(80), radians(80)), Qt::NoButton);
    QVERIFY2(readout(*slice).contains("below the horizon"), qPrintable(readout(*slice)));
    const auto lobe = lobePlot();
    moveTo(*lobe, {150, 190}, Qt::NoButton);
    QVERIFY2(readout(*lobe).contains("measured") && readout(*lobe).contains("1/sr"), qPrintable(readout(*lobe)));
  }

  void theLobeTurnsAndComesBack() {
    const auto lobe = lobePlot();
    const LobeView before = lobe->view();
    drag(*lobe, {100, 100}, {160, 80});
    QVERIFY(lobe->view().yaw < before.yaw && lobe->view().pitch < before.pitch);
    QTest::keyClick(lobe.get(), Qt::Key_Left, Qt::ControlModifier);
    QTest::keyClick(lobe.get(), Qt::Key_Plus);
    QVERIFY(lobe->view().zoom > 1);
    QTest::mouseDClick(lobe.get(), Qt::LeftButton);
    QVERIFY(lobe->view().yaw == before.yaw && lobe->view().pitch == before.pitch && lobe->view().zoom == 1);
    const Direction toEye = before.toEye(), right = before.right(), up = before.up();
    QVERIFY(std::abs(glm::dot(toEye, right)) < 1e-12 && std::abs(glm::dot(toEye, up)) < 1e-12 && up.z > 0);
    QVERIFY(std::abs(glm::length(up) - 1) < 1e-12);
  }

  void wheelZoomsAndDoubleClickResets() {
    for (const auto& plot : allPlots()) {
      const QImage before = plot->grab().toImage();
      QWidget* widget = target(*plot);
      const QPointF at = QRectF(plot->rect()).center() - QPointF(80, 0);
      QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                        false);
      QApplication::sendEvent(widget, &wheel);
      QTest::qWait(5);
      QVERIFY2(plot->grab().toImage() != before, qPrintable(plot->title()));
      QTest::mouseDClick(widget, Qt::LeftButton, {}, {5, 5});
      QTest::qWait(5);
      QEvent leave(QEvent::Leave);
      QApplication::sendEvent(plot.get(), &leave);
      QVERIFY2(plot->grab().toImage() == before, qPrintable(plot->title()));
    }
  }

  void coloursAreLegibleInBothThemes() {
    QPalette dark, light;
    dark.setColor(QPalette::Base, QColor("#212121"));
    dark.setColor(QPalette::Text, QColor("#e4e4e4"));
    light.setColor(QPalette::Base, QColor("#fafafa"));
    light.setColor(QPalette::Text, QColor("#1c1c1c"));
    for (const PlotStyle& style : {PlotStyle::of(dark), PlotStyle::of(light), PlotStyle::paper()}) {
      QVERIFY(contrast(style.text, style.background) >= 4.5);
      QList<QList<qreal>> patterns;
      for (const auto role : {SeriesRole::measured, SeriesRole::fit, SeriesRole::edited}) {
        QVERIFY(contrast(style.colour(role), style.background) >= 4.5);
        QVERIFY(!patterns.contains(style.pen(role).dashPattern()));  // not by colour alone
        patterns << style.pen(role).dashPattern();
      }
    }
  }
};

GONIO_TEST(PlotsTest)
}  // namespace plots_test

#include "plots_test.moc"
