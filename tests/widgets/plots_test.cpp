// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QSignalSpy>
#include <QWheelEvent>
#include <cmath>

#include "tests/support/test_program.h"
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

  void everyPlotDrawsItsCurves() {
    for (const auto& plot : allPlots()) {
      const QImage picture = plot->grab().toImage();
      QSet<QRgb> colours;
      for (int y = 0; y < picture.height(); y += 2)
        for (int x = 0; x < picture.width(); x += 2) colours << picture.pixel(x, y);
      QVERIFY2(colours.size() > 8, qPrintable(plot->title()));
    }
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
