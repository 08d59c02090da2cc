// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QFile>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <cmath>

#include "core/support/error.h"
#include "tests/support/test_program.h"
#include "tests/widgets/plot_test_support.h"
#include "widgets/plots/plot.h"

namespace plot_export_test {
using namespace gonio;
using namespace gonio::widgets;
using namespace gonio::widgets::test_support;

QList<QByteArray> dataLines(const QByteArray& csv) {
  QList<QByteArray> lines;
  for (const QByteArray& line : csv.trimmed().split('\n'))
    if (!line.startsWith('#')) lines << line;
  return lines;
}

/// What is written of plots, read back.
class PlotExportTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
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
      QCOMPARE(QImage::fromData(plotAsPng(*plot, {640, 400})).size(), QSize(1280, 800));
      QVERIFY(plotAsSvg(*plot, {640, 400}).contains("viewBox=\"0 0 640 400\""));
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
    QVERIFY(csv.contains("rho cos theta_o, luminance [1/sr]"));
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
};

GONIO_TEST(PlotExportTest)
}  // namespace plot_export_test

#include "plot_export_test.moc"
