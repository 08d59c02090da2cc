// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/plots/plots_panel.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "core/models/model.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"
#include "widgets/plots/curve_chart.h"
#include "widgets/plots/polar_plot.h"

namespace plots_panel_test {
using namespace gonio;
using namespace gonio::app;
using widgets::SeriesRole;

/// A Lambertian table of reflectance 0.5, whose fit is Lambert as well.
LoadedMaterialPtr chalk() {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "chalk";
  loaded->base = bakeTable(test::lambert(Rgb(0.5)), {30, 30, 30});
  return loaded;
}
fitting::FitResult lambertFit() {
  fitting::FitResult fit;
  fit.model = &models::findModel("lambert");
  fit.parameters = {{Rgb(0.5)}};
  return fit;
}
editing::DifferentialEdit editTo(double reflectance) {
  editing::DifferentialEdit edit = identityEdit(lambertFit());
  edit.edited.values[0] = Rgb(reflectance);
  return edit;
}

struct Panel {
  BackgroundTasks tasks;
  Document document;
  PlotsPanel panel{document, tasks};

  template <class AnyPlot>
  const auto& curves() {
    return panel.findChild<AnyPlot*>()->series();
  }
  void open() {
    document.setMaterial(chalk());
    document.adoptFit(lambertFit());
  }
};

class PlotsPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Measured, fit and edit of the same Lambert: three known constants in every kind of plot.
  void everyKindOfPlotHasTheThreeSeries() {
    for (const PlotKind kind : allPlotKinds) {
      PlotRequest request{.kind = kind, .material = chalk(), .edits = {{editTo(0.8)}}, .fit = editTo(0.8)};
      const PlotData data = computePlot(request);
      const auto check = [kind](const auto& list, const auto& values) {
        QCOMPARE(list.size(), std::size_t(3));
        const double expected[] = {0.5, 0.5, 0.8};
        for (std::size_t i = 0; i < 3; ++i) {
          QCOMPARE(int(list[i].role), int(i));
          const double scale = kind == PlotKind::albedo ? 1 : pi;
          // In the middle, where no cell is lost to the horizon.
          const double value = values(list[i].data).x * scale;
          QVERIFY2(std::abs(value - expected[i]) < 0.01, qPrintable(QString("%1 %2").arg(int(kind)).arg(value)));
        }
      };
      if (kind == PlotKind::slice)
        check(data.slices, [](const plots::Slice& slice) { return slice.cells.values[slice.index(40, 40)]; });
      else if (kind == PlotKind::lobe)
        check(data.lobes, [](const plots::LobeSurface& lobe) { return lobe.points.values[lobe.index(10, 0)]; });
      else
        check(data.curves, [kind](const plots::Curve& curve) {
          return curve.points.values[kind == PlotKind::albedo ? 0 : curve.angles.size() / 2];
        });
      request.edits = {{editTo(0.5)}};  // the identity: what is edited is what was measured
      const PlotData same = computePlot(request);
      QCOMPARE(same.curves.size() + same.slices.size() + same.lobes.size(), std::size_t(2));
    }
  }

  /// Any number of fits beside the one in use, each by its own name and look; the one in use is not drawn twice.
  void otherFitsAreDrawnToo() {
    const models::Model &lambert = models::findModel("lambert"), &ggx = models::findModel("ggx");
    for (const PlotKind kind : allPlotKinds) {
      PlotRequest request{.kind = kind, .material = chalk(), .edits = {{editTo(0.8)}}, .fit = editTo(0.8)};
      request.otherFits = {{&lambert, {{Rgb(0.5)}}}, {&ggx, models::defaultParameters(ggx.spec())}};
      for (int i = 0; i < 2; ++i) request.otherFits.push_back({&models::findModel(i ? "ward" : "blinn-phong"), {}});
      for (int i = 2; i < 4; ++i)
        request.otherFits[std::size_t(i)].parameters =
            models::defaultParameters(request.otherFits[std::size_t(i)].model->spec());
      const PlotData data = computePlot(request);
      const auto check = [](const auto& list) {
        QCOMPARE(list.size(), std::size_t(6));
        for (int i = 0; i < 3; ++i) {
          QVERIFY(list[std::size_t(2 + i)].role == widgets::otherFit(i));
          QVERIFY(list[std::size_t(2 + i)].name.startsWith("fit ("));
        }
        QVERIFY(list.back().role == SeriesRole::edited);
      };
      if (kind == PlotKind::slice)
        check(data.slices);
      else if (kind == PlotKind::lobe)
        check(data.lobes);
      else
        check(data.curves);
    }
  }

  /// While a slider moves, albedos that cannot have changed are kept; another fit or quality computes them anew.
  void albedosOfMeasurementAndFitAreKept() {
    PlotRequest request{
        .kind = PlotKind::albedo, .material = chalk(), .edits = {{editTo(0.8)}}, .fit = editTo(0.8), .coarse = true};
    request.known = computePlot(request).known;
    auto marked = std::make_shared<KnownAlbedo>(*request.known);
    QCOMPARE(marked->curves.size(), std::size_t(2));
    for (auto& [fit, curve] : marked->curves) curve.points.values[0] = Rgb(7);
    request.known = marked;
    request.edits = {{editTo(0.3)}};
    PlotData data = computePlot(request);
    QCOMPARE(data.curves[0].data.points.values[0].x, 7.0);
    QCOMPARE(data.curves[1].data.points.values[0].x, 7.0);
    QVERIFY(std::abs(data.curves[2].data.points.values[0].x - 0.3) < 0.01);
    request.coarse = false;
    data = computePlot(request);
    QVERIFY(std::abs(data.curves[0].data.points.values[0].x - 0.5) < 0.01);
  }

  void aHiddenPanelComputesNothing() {
    Panel p;
    p.open();
    QTest::qWait(30);
    QVERIFY(p.tasks.isIdle());
    QVERIFY(p.curves<widgets::PolarPlot>().empty());
    p.panel.show();
    QTRY_COMPARE(p.curves<widgets::PolarPlot>().size(), std::size_t(2));
    QVERIFY(p.curves<widgets::CartesianPlot>().empty());  // only the shown one
    QTRY_VERIFY(p.panel.isSettled());
  }

  /// However fast the changes come, the newest is shown in the end.
  void theNewestEditWins() {
    Panel p;
    p.panel.show();
    p.open();
    for (int i = 0; i <= 40; ++i) {
      setParameter(p.document, 0, Rgb(0.5 + i * 0.01));
      if (i < 30) QTest::qWait(1);  // the last ones come while the first of them is still being plotted
    }
    QTRY_VERIFY(p.panel.isSettled());
    const auto& curves = p.curves<widgets::PolarPlot>();
    QCOMPARE(curves.size(), std::size_t(3));
    QVERIFY(std::abs(curves[2].data.points.values[360].x * pi - 0.9) < 0.01);
    p.document.setMaterial(nullptr);
    QVERIFY(p.curves<widgets::PolarPlot>().empty());
  }

  void showAtOpensTheDockAtPlotAndAngle() {
    QMainWindow window;
    Panel* p = new Panel;
    auto* dock = new QDockWidget(&window);
    dock->setWidget(&p->panel);
    window.addDockWidget(Qt::BottomDockWidgetArea, dock);
    dock->hide();
    window.show();
    p->panel.showAt(PlotKind::albedo, radians(80));
    QVERIFY(dock->isVisible());
    QCOMPARE(p->panel.controls().choices().kind, PlotKind::albedo);
    QCOMPARE(p->panel.currentPlot().settings().thetaI, radians(80));
    p->panel.setThetaI(radians(95));
    QCOMPARE(p->panel.currentPlot().settings().thetaI, widgets::maxThetaI);
    delete p;
  }

  /// The angle is one for all plots: what is dragged in one, the others have.
  void allPlotsShareTheAngle() {
    Panel p;
    Q_EMIT p.panel.findChild<widgets::PolarPlot*>()->thetaIEdited(0.3);
    QCOMPARE(p.panel.findChild<widgets::CartesianPlot*>()->settings().thetaI, 0.3);
    QCOMPARE(p.panel.controls().choices().section().thetaD, 0.3);
  }

  /// Lobes and slices are logarithmic unless the user says otherwise, others linear; each kind keeps its own choice.
  void eachKindHasItsOwnAxis() {
    Panel p;
    const auto isLogarithmic = [&](const widgets::Plot* plot) { return plot->settings().logarithmic; };
    const auto* polar = p.panel.findChild<widgets::PolarPlot*>();
    const auto* cartesian = p.panel.findChild<widgets::CartesianPlot*>();
    QVERIFY(isLogarithmic(polar) && !isLogarithmic(cartesian));
    auto* box = p.panel.controls().findChild<QCheckBox*>("logarithmic");
    QVERIFY(box && box->isChecked());
    PlotChoices choices = p.panel.controls().choices();
    choices.kind = PlotKind::cartesian;
    p.panel.controls().setChoices(choices);
    QVERIFY(!box->isChecked());
    box->click();
    QVERIFY(isLogarithmic(polar) && isLogarithmic(cartesian));
  }

  void choicesAreRemembered() {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    PlotChoices choices;
    choices.kind = PlotKind::slice;
    choices.settings.channel = plots::Channel::blue;
    choices.settings.cosine = plots::CosineFactor::incident;
    choices.logarithmic[std::size_t(PlotKind::slice)] = false;
    choices.logarithmic[std::size_t(PlotKind::lobe)] = false;
    choices.axis = plots::SectionAxis::thetaH;
    choices.spacing = plots::ThetaHSpacing::linear;
    choices.coordinates = plots::SliceCoordinates::halfOut;
    {
      Panel p;
      p.panel.controls().setChoices(choices);
      p.panel.saveState(settings);
    }
    Panel p;
    p.panel.restoreState(settings);
    QVERIFY(p.panel.controls().choices() == choices);
    // Nonsense in the file is not taken.
    settings.setValue("plots/kind", 99);
    p.panel.restoreState(settings);
    QCOMPARE(p.panel.controls().choices().kind, PlotKind::lobe);
  }
};

GONIO_TEST(PlotsPanelTest)
}  // namespace plots_panel_test

#include "plots_panel_test.moc"
