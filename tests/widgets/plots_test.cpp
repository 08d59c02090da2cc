// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QXmlStreamReader>
#include <cmath>

#include "core/plots/albedo_curve.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "widgets/plots/albedo_plot.h"
#include "widgets/plots/cartesian_plot.h"
#include "widgets/plots/lobe_plot.h"
#include "widgets/plots/plot_export.h"
#include "widgets/plots/polar_plot.h"
#include "widgets/plots/slice_plot.h"

using namespace gonio;
using namespace gonio::widgets;
using plots::CosineFactor;

namespace {

const PlotSettings settings{.cosine = CosineFactor::outgoing, .thetaI = radians(30)};

/// Lambert of reflectance 1 and 0.5, times cos theta_o.
template <class Compute>
auto twoSeries(Compute compute) {
  PlotSeriesList<decltype(compute(testing::lambert(Rgb(1))))> list;
  list.push_back({SeriesRole::measured, "measured", compute(testing::lambert(Rgb(1)))});
  list.push_back({SeriesRole::edited, "edited", compute(testing::lambert(Rgb(0.5)))});
  return list;
}
plots::Curve lobeCurve(const Brdf& brdf) { return plots::polarLobe(brdf, settings.thetaI, settings.cosine); }

/// Shown with data and settings; the offscreen platform lays it out.
template <class AnyPlot>
std::unique_ptr<AnyPlot> shown(std::unique_ptr<AnyPlot> plot) {
  plot->setSource("chalk");
  plot->setSettings(settings);
  plot->resize(600, 320);
  plot->show();
  QTest::qWait(20);
  return plot;
}
std::unique_ptr<PolarPlot> polarPlot() {
  auto plot = std::make_unique<PolarPlot>();
  plot->setSeries(twoSeries(lobeCurve));
  return shown(std::move(plot));
}
std::unique_ptr<CartesianPlot> cartesianPlot(plots::SectionAxis axis = plots::SectionAxis::thetaO) {
  const plots::Section section{
      .axis = axis, .thetaI = settings.thetaI, .thetaD = radians(20), .cosine = settings.cosine};
  auto plot = std::make_unique<CartesianPlot>();
  plot->setSection(section, twoSeries([&](const Brdf& brdf) { return plots::sectionCurve(brdf, section); }));
  return shown(std::move(plot));
}
std::unique_ptr<SlicePlot> slicePlot() {
  auto plot = std::make_unique<SlicePlot>();
  plot->setSeries(twoSeries([](const Brdf& brdf) {
    return plots::halfDifferenceSlice(brdf, 0.3, plots::ThetaHSpacing::squareRoot, settings.cosine);
  }));
  return shown(std::move(plot));
}
std::unique_ptr<AlbedoPlot> albedoPlot() {
  auto plot = std::make_unique<AlbedoPlot>();
  plot->setSeries(twoSeries([](const Brdf& brdf) { return plots::albedoCurve(brdf, 5, 64); }));
  return shown(std::move(plot));
}
std::unique_ptr<LobePlot> lobePlot() {
  auto plot = std::make_unique<LobePlot>();
  plot->setSeries(
      twoSeries([](const Brdf& brdf) { return plots::lobeSurface(brdf, settings.thetaI, settings.cosine); }));
  return shown(std::move(plot));
}

std::vector<std::unique_ptr<Plot>> allPlots() {
  std::vector<std::unique_ptr<Plot>> all;
  all.push_back(polarPlot());
  all.push_back(cartesianPlot());
  all.push_back(slicePlot());
  all.push_back(albedoPlot());
  all.push_back(lobePlot());
  return all;
}

/// The widget that gets the mouse: a chart inside the plot, or the plot itself.
QWidget* target(Plot& plot) {
  for (QWidget* child : plot.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (!qobject_cast<QLabel*>(child)) return child;
  return &plot;
}
void moveTo(Plot& plot, const QPointF& position, Qt::MouseButtons buttons) {
  QWidget* widget = target(plot);
  QMouseEvent event(QEvent::MouseMove, position, widget->mapToGlobal(position), Qt::NoButton, buttons, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}
void drag(Plot& plot, const QPointF& from, const QPointF& to) {
  QTest::mousePress(target(plot), Qt::LeftButton, {}, from.toPoint());
  moveTo(plot, to, Qt::LeftButton);
  QTest::mouseRelease(target(plot), Qt::LeftButton, {}, to.toPoint());
}
QString readout(Plot& plot) {
  for (const QLabel* label : plot.findChildren<QLabel*>())
    if (label->isVisible() && label->autoFillBackground()) return label->text();
  return {};
}

/// Contrast of WCAG 2.1.
double contrast(const QColor& a, const QColor& b) {
  const auto light = [](const QColor& colour) {
    const auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return luminance({linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())}) + 0.05;
  };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

QList<QByteArray> dataLines(const QByteArray& csv) {
  QList<QByteArray> lines;
  for (const QByteArray& line : csv.trimmed().split('\n'))
    if (!line.startsWith('#')) lines << line;
  return lines;
}

}  // namespace

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

  void exportedFilesAreReadBack() {
    const QTemporaryDir folder;
    for (const auto& plot : allPlots()) {
      const QString stem = folder.filePath(plot->title());
      for (const char* suffix : {".svg", ".png", ".csv"}) exportPlot(*plot, stem + suffix);
      QFile svg(stem + ".svg");
      QVERIFY(svg.open(QIODevice::ReadOnly));
      QXmlStreamReader reader(&svg);
      int shapes = 0;
      QString texts;
      while (!reader.atEnd()) {
        reader.readNext();
        if (!reader.isStartElement()) continue;
        if (reader.name() == QLatin1String("text"))
          texts += reader.readElementText() + '\n';
        else if (QStringList{"polyline", "path", "image", "polygon"}.contains(reader.name()))
          ++shapes;
      }
      QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
      QVERIFY(shapes > 2);
      QVERIFY2(texts.contains("measured") && texts.contains("edited"), qPrintable(texts));
      const QImage png(stem + ".png");
      QCOMPARE(png.size(), plot->size() * 2);
      QCOMPARE(png.pixelColor(1, png.height() - 2), QColor(Qt::white));  // on paper, whatever the theme
      const QByteArray csv = plotAsCsv(*plot);
      QFile written(stem + ".csv");
      QVERIFY(written.open(QIODevice::ReadOnly));
      QCOMPARE(written.readAll(), csv);
      QVERIFY(csv.contains("chalk") && csv.contains("convention: unit directions") && csv.contains("degrees"));
    }
  }

  /// SVG files do not clip: every corner of a zoomed chart's curves lies between the axes.
  void zoomedCurvesEndAtTheAxes() {
    const auto plot = cartesianPlot();
    const QPointF at = QRectF(plot->rect()).center();
    QWidget* widget = target(*plot);
    QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, 600}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(widget, &wheel);
    QXmlStreamReader reader(plotAsSvg(*plot));
    int corners = 0;
    while (!reader.atEnd()) {
      reader.readNext();
      if (!reader.isStartElement() || reader.name() != QLatin1String("polyline")) continue;
      for (const QString& point : reader.attributes().value("points").toString().split(' ', Qt::SkipEmptyParts)) {
        const double x = point.section(',', 0, 0).toDouble(), y = point.section(',', 1, 1).toDouble();
        QVERIFY2(x > -1 && y > -1 && x < 601 && y < 321, qPrintable(point));
        ++corners;
      }
    }
    QVERIFY(corners > 10);
    QVERIFY(plot->series().front().data.angles.size() > 700);
  }

  /// A column a curve: the numbers of a Lambert lobe times cos theta_o.
  void csvHoldsTheShownNumbers() {
    const auto plot = polarPlot();
    const QByteArray csv = plotAsCsv(*plot);
    QVERIFY(csv.contains("luminance of f cos theta_o, 1/sr"));
    QVERIFY(csv.contains("theta_i = 30 degrees"));
    const QList<QByteArray> lines = dataLines(csv);
    QCOMPARE(lines.first(), QByteArray("theta_o [degrees],measured [1/sr],edited [1/sr]"));
    QVERIFY(lines.size() > 100);
    for (qsizetype i = 1; i < lines.size(); ++i) {
      const QList<QByteArray> fields = lines[i].split(',');
      QCOMPARE(fields.size(), 3);
      const double expected = std::cos(radians(fields[0].toDouble())) / pi;
      QVERIFY(std::abs(fields[1].toDouble() - expected) < 1e-12);
      QVERIFY(std::abs(fields[2].toDouble() - expected / 2) < 1e-12);
    }
    // Cells below the horizon are empty.
    bool empty = false;
    for (const QByteArray& line : dataLines(plotAsCsv(*slicePlot()))) empty = empty || line.endsWith(",,");
    QVERIFY(empty);
  }

  void exportErrorsNameTheFile() {
    const auto plot = polarPlot();
    for (const QString path : {"/no/such/folder/lobe.svg", "/tmp/lobe.jpg"}) {
      try {
        exportPlot(*plot, path);
        QFAIL("no error");
      } catch (const Error& error) {
        QVERIFY2(QString(error.what()).startsWith(path), error.what());
      }
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

QTEST_MAIN(PlotsTest)
#include "plots_test.moc"
