// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/fit_ranking_panel.h"

#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <cmath>

#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace fit_ranking_panel_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

struct Editor {
  Document document;
  BackgroundTasks tasks;
  DocumentController controller{document, tasks};
  FitRankingPanel panel{document, controller, tasks};
};

LoadedMaterialPtr greyMaterial() {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "grey";
  const HalfDifferenceGrid grid{12, 12, 12};
  loaded->base = bakeTable(*models::findModel("lambert").instantiate({{Rgb(0.3)}}), grid);
  loaded->material.brdf = loaded->base;
  return loaded;
}

study::RankedFit ranked(const char* id, double error, double snr) {
  study::RankedFit row;
  row.fit.model = &models::findModel(id);
  row.fit.parameters = models::defaultParameters(row.fit.model->spec());
  row.fit.errors.assign(metrics::allBrdfMetrics().size(), error);
  row.renderedSnr = snr;
  return row;
}

QStringList names(const QAbstractItemModel& model) {
  QStringList texts;
  for (int row = 0; row < model.rowCount(); ++row) texts << model.index(row, 0).data().toString();
  return texts;
}

class FitRankingPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Best first by the column: the smallest error, the largest SNR; what is no number last.
  void sortsByEachColumn() {
    Editor editor;
    FitRankingModel& model = editor.panel.model();
    model.add(ranked("lambert", 0.3, 10));
    model.add(ranked("ggx", NAN, 30));
    model.add(ranked("ward", 0.1, NAN));
    QTreeView* view = editor.panel.view();
    view->sortByColumn(FitRankingModel::ErrorColumn, Qt::AscendingOrder);
    const auto name = [](const char* id) { return QString::fromUtf8(models::findModel(id).spec().name.data()); };
    QCOMPARE(names(*view->model()), (QStringList{name("ward"), name("lambert"), name("ggx")}));
    view->sortByColumn(FitRankingModel::SnrColumn, Qt::AscendingOrder);
    QCOMPARE(names(*view->model()), (QStringList{name("ggx"), name("lambert"), name("ward")}));
    // The same model again takes the place of its row.
    model.add(ranked("ggx", 0.01, 30));
    QCOMPARE(model.rowCount(), 3);
  }

  /// Ticked fits are reported in the order of the rows; a tick takes no fit into use; another material unticks all.
  void tickedFitsArePlotted() {
    Editor editor;
    FitRankingModel& model = editor.panel.model();
    for (const char* id : {"lambert", "ggx", "ward"}) model.add(ranked(id, 0.1, 10));
    QSignalSpy plotted(&model, &FitRankingModel::plottedChanged);
    const QModelIndex tick = model.index(2, FitRankingModel::PlotColumn);
    QVERIFY(model.flags(tick) & Qt::ItemIsUserCheckable);
    QVERIFY(!(model.flags(model.index(2, 0)) & Qt::ItemIsUserCheckable));
    QVERIFY(model.setData(tick, Qt::Checked, Qt::CheckStateRole));
    QVERIFY(model.setData(model.index(0, FitRankingModel::PlotColumn), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(plotted.count(), 2);
    QCOMPARE(model.plotted().size(), std::size_t(2));
    QVERIFY(model.plotted()[0]->model == &models::findModel("lambert"));
    QVERIFY(model.plotted()[1]->model == &models::findModel("ward"));
    model.add(ranked("ward", 0.05, 12));  // fitted anew: it stays
    QCOMPARE(plotted.count(), 3);
    QCOMPARE(model.plotted()[1]->errors[0], 0.05);
    model.clear();
    QVERIFY(model.plotted().empty() && plotted.count() == 4);
  }

  /// A fit of all, a click on a row, undo: one step each way, and no fit is made again.
  void fitsAllAndTakesAClickedRow() {
    Editor editor;
    editor.document.setMaterial(greyMaterial());
    editor.document.adoptFit(ranked("ggx", 0.1, 10).fit);
    QSignalSpy rows(&editor.panel.model(), &QAbstractItemModel::rowsInserted);
    editor.panel.fitAll();
    QVERIFY(editor.panel.isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(!editor.panel.isRunning(), patienceMilliseconds);
    QTRY_COMPARE(editor.panel.model().rowCount(), int(models::allModels().size()));
    QCOMPARE(rows.count(), int(models::allModels().size()));  // one after the other, as they were done

    QTreeView* view = editor.panel.view();
    int lambert = -1;
    for (int row = 0; row < view->model()->rowCount(); ++row)
      if (view->model()->index(row, 0).data().toString().startsWith("Lambert")) lambert = row;
    QVERIFY(lambert >= 0);
    Q_EMIT view->clicked(view->model()->index(lambert, 0));
    QVERIFY(!editor.tasks.isRunning("fit"));
    QCOMPARE(modelEdit(editor.document)->model, &models::findModel("lambert"));
    QVERIFY(std::abs(modelEdit(editor.document)->fitted.values[0].x - 0.3) < 1e-3);
    QCOMPARE(editor.document.history().count(), 1);
    QVERIFY(view->model()->index(lambert, 0).data().toString().contains("in use"));
    editor.document.history().undo();
    QCOMPARE(modelEdit(editor.document)->model, &models::findModel("ggx"));
  }

  /// Stopping keeps the rows that are done; another material takes them away.
  void stopsAndForgets() {
    Editor editor;
    editor.document.setMaterial(greyMaterial());
    editor.panel.fitAll();
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.model().rowCount() >= 1, patienceMilliseconds);
    editor.tasks.cancelTopmost();
    QTRY_VERIFY_WITH_TIMEOUT(!editor.panel.isRunning(), patienceMilliseconds);
    QVERIFY(editor.panel.model().rowCount() >= 1);
    editor.document.setMaterial(greyMaterial());
    QCOMPARE(editor.panel.model().rowCount(), 0);
  }

  /// Everything closes while a fit runs, after none, one and two rows: the work ends and lets the material go.
  void closingWhileFitting() {
    for (int rows = 0; rows < 3; ++rows) {
      std::weak_ptr<const LoadedMaterial> material;
      {
        Editor editor;
        const LoadedMaterialPtr loaded = greyMaterial();
        material = loaded;
        editor.document.setMaterial(loaded);
        editor.panel.fitAll();
        QTRY_VERIFY_WITH_TIMEOUT(editor.panel.model().rowCount() >= rows, patienceMilliseconds);
        QVERIFY(editor.panel.isRunning());
      }
      QTRY_VERIFY_WITH_TIMEOUT(material.expired(), patienceMilliseconds);
    }
  }
};

GONIO_TEST(FitRankingPanelTest)
}  // namespace fit_ranking_panel_test

#include "fit_ranking_panel_test.moc"
