// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_window.h"

#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>
#include <QTreeWidget>
#include <cmath>

#include "app/gonio/document/document_controller.h"
#include "core/models/registry.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "widgets/study/study_scatter.h"

namespace study_window_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

LoadedMaterialPtr material(const char* name, const Brdf& brdf) {
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = name;
  loaded->base = bakeTable(brdf, HalfDifferenceGrid{12, 12, 12});
  loaded->material.brdf = loaded->base;
  return loaded;
}

LoadedMaterialPtr material(const char* name, double value) {
  return material(name, *models::findModel("lambert").instantiate({{Rgb(value)}}));
}

/// Two tables, two fits.
const std::vector<std::string> fewNames{"table", "lambert", "ggx"};

struct Editor {
  Document document;
  BackgroundTasks tasks;
  DocumentController controller{document, tasks};
  StudyWindow window{document, tasks};
  explicit Editor(const std::vector<std::string>& names = fewNames) {
    study::StudyOptions options;
    options.picture = {.width = 16, .height = 16, .samples = 4};
    window.run().setOptions(options);
    window.choice().setNames(names);
  }
  QPushButton* button(const QString& text) const { return test::child<QPushButton>(window, text); }
  QString text(int row, int column) { return window.model().index(row, column).data().toString(); }
  bool finish() {
    return QTest::qWaitFor([&] { return !window.run().isRunning(); }, patienceMilliseconds);
  }
  bool measure() {
    window.measureOpen();
    return finish() && window.model().missing(0, true).empty();
  }
  QStringList shownNames() {
    QStringList texts;
    const QAbstractItemModel& sorted = *window.table().model();
    for (int row = 0; row < sorted.rowCount(); ++row)
      texts << sorted.index(row, 0).data().toString().section(" (", 0, 0);
    return texts;
  }
};

enum Row { cellTable, trilinearTable, lambertFit, ggxFit };

/// A result as of a study without times.
StudyModel::Studied fitResult(const char* id, double error, double snr) {
  study::MeasuredRepresentation one;
  one.record.representation = study::representationById(id);
  one.record.errors.assign(metrics::allBrdfMetrics().size(), error);
  one.record.renderedSnr = snr;
  one.record.frameMilliseconds = one.record.evaluation.median = NAN;
  one.fit.emplace();
  one.fit->model = &models::findModel(id);
  one.fit->parameters = models::defaultParameters(one.fit->model->spec());
  one.fit->errors = one.record.errors;
  return std::make_shared<const study::MeasuredRepresentation>(one);
}

class StudyWindowTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAMaterialThereIsNothingToMeasure() {
    Editor editor;
    QVERIFY(!editor.button("Measure")->isEnabled());
    QVERIFY(!editor.button("Copy as CSV")->isEnabled());
    editor.window.measureOpen();
    QVERIFY(!editor.window.run().isRunning());
    QVERIFY(editor.window.model().isEmpty());
  }

  /// The list has every row of the table that needs only the material; results stay as long as their row is ticked.
  void tickedRepresentations() {
    Editor editor(std::vector<std::string>{});
    std::size_t offered = 0;
    for (const study::RepresentationKind& kind : study::representationKinds()) offered += !kind.needsFurtherData;
    std::size_t listed = 0;
    const QTreeWidget& list = editor.window.choice();
    for (int i = 0; i < list.topLevelItemCount(); ++i)
      listed += std::size_t(std::max(1, list.topLevelItem(i)->childCount()));
    QCOMPARE(listed, offered);
    QCOMPARE(editor.window.model().rowCount(), 0);
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(!editor.button("Measure")->isEnabled());

    QVERIFY(Editor(study::defaultFamilies()).window.choice().names() == study::defaultFamilies());
    editor.window.choice().setNames({"table"});
    QCOMPARE(editor.window.model().rowCount(), 2);
    QVERIFY(editor.measure());
    QTreeWidgetItem* tables = list.topLevelItem(0);
    QCOMPARE(tables->checkState(0), Qt::Checked);
    for (int i = 0; i < list.topLevelItemCount(); ++i)
      if (list.topLevelItem(i)->text(0) == "Baselines") list.topLevelItem(i)->setCheckState(0, Qt::Checked);
    QVERIFY(editor.window.model().rowCount() > 20);
    QVERIFY(editor.window.model().isMeasured(0) && editor.window.model().isMeasured(1));
    tables->child(0)->setCheckState(0, Qt::Unchecked);
    QCOMPARE(tables->checkState(0), Qt::PartiallyChecked);
    QVERIFY((editor.window.choice().names() == std::vector<std::string>{"table-trilinear", "baselines"}));
    QVERIFY(editor.window.model().isMeasured(0) && !editor.window.model().isMeasured(1));
  }

  /// "-" until measured; then each number is one. What is measured again stays until its new result is there.
  void rowsFillAsTheyAreMeasured() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    StudyModel& model = editor.window.model();
    QCOMPARE(model.rowCount(), 4);
    const auto numbers = {StudyModel::SnrColumn,   StudyModel::ErrorColumn, StudyModel::EvaluationColumn,
                          StudyModel::FrameColumn, StudyModel::BytesColumn, StudyModel::EncodingColumn};
    for (int row = 0; row < 4; ++row)
      for (const int column : numbers) {
        QCOMPARE(editor.text(row, column), "-");
        QVERIFY(model.index(row, column).data(Qt::ForegroundRole).isValid());
      }
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QVERIFY(editor.measure());
    QVERIFY(changed.count() >= 4);
    for (int row = 0; row < 4; ++row) {
      for (const int column : numbers) QVERIFY(editor.text(row, column) != "-");
      QVERIFY(!model.index(row, 0).data(Qt::ForegroundRole).isValid());
      QVERIFY(model.toolTip(row).contains("<img src=\"data:image/png;base64,"));
    }
    QCOMPARE(editor.text(trilinearTable, StudyModel::SnrColumn), "∞");
    QCOMPARE(editor.text(trilinearTable, StudyModel::EncodingColumn), "none");
    QCOMPARE(editor.text(ggxFit, StudyModel::ParametersColumn), "8");
    QVERIFY(editor.button("Measure Again"));
    // Lines of what is measured, under five of where.
    QCOMPARE(editor.window.run().csv({0, 1, 2, 3}).count('\n'), 5 + 1 + 4);
    const auto first = model.studied(cellTable);
    editor.window.measureOpen();
    QCOMPARE(model.missing().size(), std::size_t(4));
    QVERIFY(model.isMeasured(ggxFit) && model.studied(cellTable) == first);
    QVERIFY(QTest::qWaitFor([&] { return model.missing().empty(); }, patienceMilliseconds));
    QVERIFY(model.studied(cellTable) != first);
  }

  /// Fits without times; the other rows are not measured, and times are measured later.
  void fitsAllAndUsesOne() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    editor.document.adoptFit(*fitResult("ggx", 0.1, 10)->fit);
    QObject::connect(&editor.window, &StudyWindow::useRequested, &editor.controller,
                     [&](const study::Representation& one) { editor.controller.chooseModel(*one.kind->model); });
    QSignalSpy rows(&editor.window.run(), &StudyRun::rowMeasured);
    editor.window.fitAll();
    QVERIFY(editor.window.run().isRunning());
    QVERIFY(editor.finish());
    StudyModel& model = editor.window.model();
    QCOMPARE(model.rowCount(), 2 + int(models::allModels().size()));
    QCOMPARE(rows.count(), int(models::allModels().size()));  // one after the other, as they were done
    QVERIFY(!model.isMeasured(cellTable));
    QCOMPARE(editor.text(lambertFit, StudyModel::FrameColumn), "-");
    QCOMPARE(editor.button("Measure the Rest")->isEnabled(), true);
    QCOMPARE(model.missing(0, true).size(), std::size_t(model.rowCount()));
    QCOMPARE(model.missing(0, false).size(), std::size_t(2));

    int lambert = -1;
    for (int row = 0; row < model.rowCount(); ++row)
      if (model.representation(row).kind->id == "lambert") lambert = row;
    const QAbstractItemModel& sorted = *editor.window.table().model();
    for (int i = 0; i < sorted.rowCount(); ++i)
      if (sorted.index(i, 0).data().toString().startsWith("Lambert"))
        Q_EMIT editor.window.table().doubleClicked(sorted.index(i, 0));
    QVERIFY(!editor.tasks.isRunning("fit"));  // it was stored
    QCOMPARE(modelEdit(editor.document)->model, &models::findModel("lambert"));
    QVERIFY(std::abs(modelEdit(editor.document)->fitted.values[0].x - 0.3) < 1e-3);
    QCOMPARE(editor.document.history().count(), 1);
    QVERIFY(editor.text(lambert, 0).contains("in use"));
    editor.document.history().undo();
    QCOMPARE(modelEdit(editor.document)->model, &models::findModel("ggx"));
  }

  /// Ticked fits are told in the order of the rows; another material unticks all.
  void tickedFitsArePlotted() {
    Editor editor({"table", "lambert", "ggx", "ward"});
    editor.document.setMaterial(material("grey", 0.3));
    StudyModel& model = editor.window.model();
    for (const char* id : {"lambert", "ggx", "ward"}) model.add(0, fitResult(id, 0.1, 10));
    const auto rowOf = [&](std::string_view id) {
      for (int row = 0; row < model.rowCount(); ++row)
        if (model.representation(row).kind->id == id) return row;
      return -1;
    };
    QSignalSpy plotted(&model, &StudyModel::plottedChanged);
    const QModelIndex tick = model.index(rowOf("ward"), StudyModel::PlotColumn);
    QVERIFY(model.flags(tick) & Qt::ItemIsUserCheckable);
    QVERIFY(!(model.flags(model.index(rowOf("ward"), 0)) & Qt::ItemIsUserCheckable));
    QVERIFY(!(model.flags(model.index(cellTable, StudyModel::PlotColumn)) & Qt::ItemIsUserCheckable));
    QVERIFY(model.setData(tick, Qt::Checked, Qt::CheckStateRole));
    QVERIFY(model.setData(model.index(rowOf("lambert"), StudyModel::PlotColumn), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(plotted.count(), 2);
    QCOMPARE(model.plotted().size(), std::size_t(2));
    QVERIFY(model.plotted()[0]->model == &models::findModel("lambert"));
    QVERIFY(model.plotted()[1]->model == &models::findModel("ward"));
    model.add(0, fitResult("ward", 0.05, 12));  // fitted anew: it stays
    QCOMPARE(plotted.count(), 3);
    QCOMPARE(model.plotted()[1]->errors[0], 0.05);
    editor.document.setMaterial(material("other", 0.4));
    QVERIFY(model.plotted().empty() && plotted.count() == 4);
  }

  /// Results of the material before stay in view, but cannot be used, until there is one of the new material.
  void resultsStayUntilThereAreNewOnes() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    editor.document.setMaterial(material("other", 0.5));
    StudyModel& model = editor.window.model();
    QVERIFY(model.isOutdated() && model.isMeasured(ggxFit) && editor.text(ggxFit, StudyModel::SnrColumn) != "-");
    QVERIFY(model.index(ggxFit, 0).data(Qt::ForegroundRole).isValid());
    QCOMPARE(editor.window.run().title(), "grey");
    QVERIFY(editor.window.run().status().contains("results of grey"));
    QCOMPARE(model.missing().size(), std::size_t(4));
    QVERIFY(!editor.button("Use This Representation")->isEnabled());
    editor.window.show(ggxFit);
    QVERIFY(!editor.tasks.isRunning("study preview"));
    QSignalSpy rows(&editor.window.run(), &StudyRun::rowMeasured);
    editor.window.measureOpen();
    QVERIFY(rows.wait(patienceMilliseconds));
    QVERIFY(!model.isOutdated() && model.isMeasured(cellTable));
    QVERIFY(editor.finish() && model.missing().empty());
    QCOMPARE(editor.window.run().title(), "other");
  }

  /// A slider that moves shows what it does: what was shown instead goes.
  void anEditShowsTheMaterialAgain() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    editor.window.show(ggxFit);
    QTRY_VERIFY_WITH_TIMEOUT(editor.window.subject(), patienceMilliseconds);
    const models::Model& model = models::findModel("lambert");
    editor.document.replaceEdits({{editing::DifferentialEdit{&model, {{Rgb(0.3)}}, {{Rgb(0.5)}}}}}, "Brighter");
    QVERIFY(!editor.window.subject());
  }

  void sortsByEachColumn() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    const QAbstractItemModel& sorted = *editor.window.table().model();
    for (int column = StudyModel::SnrColumn; column < StudyModel::ColumnCount; ++column) {
      if (column == StudyModel::WorstMaterialColumn) continue;
      editor.window.table().sortByColumn(column, Qt::AscendingOrder);
      for (int row = 1; row < sorted.rowCount(); ++row)
        QVERIFY(sorted.index(row - 1, column).data(Qt::UserRole).toDouble() <=
                sorted.index(row, column).data(Qt::UserRole).toDouble());
    }
    editor.window.table().sortByColumn(StudyModel::SnrColumn, Qt::AscendingOrder);
    QVERIFY(sorted.index(0, StudyModel::SnrColumn).data().toString() == "∞");
  }

  /// Best first by the column, what is no number last; the table, the sheet and the legend have one order.
  void oneOrderEverywhere() {
    Editor editor({"lambert", "ggx", "ward"});
    editor.document.setMaterial(material("grey", 0.3));
    StudyModel& model = editor.window.model();
    model.add(0, fitResult("lambert", 0.3, 10));
    model.add(0, fitResult("ggx", NAN, 30));
    model.add(0, fitResult("ward", 0.1, NAN));
    QTreeView& view = editor.window.table();
    const auto name = [](const char* id) { return QString::fromUtf8(models::findModel(id).spec().name.data()); };
    view.sortByColumn(StudyModel::ErrorColumn, Qt::AscendingOrder);
    QCOMPARE(editor.shownNames(), (QStringList{name("ward"), name("lambert"), name("ggx")}));
    view.sortByColumn(StudyModel::SnrColumn, Qt::AscendingOrder);
    QCOMPARE(editor.shownNames(), (QStringList{name("ggx"), name("lambert"), name("ward")}));

    editor.window.choice().setNames(fewNames);
    QVERIFY(editor.measure());
    for (const int column : {StudyModel::SnrColumn, StudyModel::BytesColumn, StudyModel::NameColumn}) {
      view.sortByColumn(column, Qt::DescendingOrder);
      const QStringList shown = editor.shownNames();
      QStringList sheet;
      for (const widgets::SheetTile& tile : editor.window.sheet().sheet().tiles()) sheet << tile.name;
      QCOMPARE(sheet.value(0), "grey");
      QCOMPARE(sheet.mid(1), shown);
      const std::vector<study::StudyRecord> records = editor.window.scatter().records();
      for (qsizetype i = 0; i < shown.size(); ++i)
        QCOMPARE(QString::fromStdString(records[std::size_t(i)].representation.shortLabel()), shown[i]);
    }
  }

  /// A row is shown; the same again, Escape, or another material, and the material is.
  void aRowIsShownAndTakenBack() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    editor.window.show(ggxFit);
    QVERIFY(!editor.window.subject());  // not measured yet
    QVERIFY(editor.measure());
    QSignalSpy changed(&editor.window, &StudyWindow::subjectChanged);
    const auto shows = [&](int row) {
      editor.window.show(row);
      return QTest::qWaitFor([&] { return editor.window.subject().has_value(); }, patienceMilliseconds);
    };
    QVERIFY(shows(ggxFit));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(editor.window.shownName(), "GGX");
    QVERIFY(editor.text(ggxFit, 0).startsWith("GGX (shown"));
    QVERIFY(formOf<TabulatedBrdf>(*editor.window.subject()->base())->grid() ==
            editor.document.material()->table()->grid());
    editor.window.show(ggxFit);
    QVERIFY(!editor.window.subject());
    QCOMPARE(changed.count(), 2);

    QVERIFY(shows(lambertFit));
    QTest::keyClick(&editor.window.scatter(), Qt::Key_Escape);
    QVERIFY(!editor.window.subject());
    QVERIFY(shows(lambertFit));
    QTest::keyClick(&editor.window.table(), Qt::Key_Escape);
    QVERIFY(!editor.window.subject());
    QVERIFY(shows(trilinearTable));
    QVERIFY(editor.window.subject()->base() == editor.document.material()->table());
    editor.document.setMaterial(material("other", 0.5));
    QVERIFY(!editor.window.subject() && editor.window.shownName().isEmpty());
  }

  void keysShowAndUseARow() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    QTreeView& table = editor.window.table();
    table.setCurrentIndex(table.model()->index(0, 0));
    QVERIFY(editor.window.scatter().current() >= 0);
    QTest::keyClick(&table, Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return editor.window.subject().has_value(); }, patienceMilliseconds));
    QSignalSpy used(&editor.window, &StudyWindow::useRequested);
    QTest::keyClick(&table, Qt::Key_Return);
    QCOMPARE(used.count(), 1);
    QVERIFY(editor.window.subject());  // a table is used by showing it
  }

  void theBudgetChoosesAndIsUsed() {
    Editor editor;
    const models::Model& phong = models::findModel("phong");  // that no fit of the two matches exactly
    editor.document.setMaterial(material("glossy", *phong.instantiate(models::defaultParameters(phong.spec()))));
    QVERIFY(editor.measure());
    QSignalSpy useRequested(&editor.window, &StudyWindow::useRequested);
    QPushButton& use = *editor.button("Use This Representation");
    QVERIFY(use.isEnabled());
    // 12 bytes: only three numbers fit.
    editor.window.findChild<StudyBudgetBar*>()->setBudget({.frameMilliseconds = {}, .renderedSnr = {}, .bytes = 100});
    QVERIFY(editor.text(lambertFit, 0).endsWith("(best)") || editor.text(ggxFit, 0).endsWith("(best)"));
    use.click();
    QCOMPARE(useRequested.count(), 1);
    QCOMPARE(useRequested[0][0].value<study::Representation>().kind->use, study::RepresentationUse::editModel);
    editor.window.findChild<StudyBudgetBar*>()->setBudget({.frameMilliseconds = {}, .renderedSnr = 200, .bytes = 100});
    QVERIFY(!use.isEnabled());
  }

  /// What is done stays, and the rest goes on from there.
  void stoppingKeepsWhatIsMeasured() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    StudyModel& model = editor.window.model();
    connect(&model, &QAbstractItemModel::dataChanged, &editor.window, [&] {
      if (model.missing().size() == 3 && editor.window.run().isRunning()) editor.tasks.cancelTopmost();
    });
    editor.window.measureOpen();
    QVERIFY(editor.finish());
    QTest::qWait(0);  // rows that were on their way
    const std::size_t left = model.missing().size();
    QVERIFY(left < 4);
    const auto first = model.studied(cellTable);
    if (left > 0) {
      QVERIFY(editor.button("Measure the Rest"));
      QVERIFY(editor.measure());
    }
    QVERIFY(first && model.studied(cellTable) == first);
  }

  /// Everything closes while it is measured, after none, one and two rows: the work ends and lets the material go.
  void closingWhileMeasuring() {
    for (int rows = 0; rows < 3; ++rows) {
      std::weak_ptr<const LoadedMaterial> held;
      {
        Editor editor({"fits"});
        const LoadedMaterialPtr loaded = material("grey", 0.3);
        held = loaded;
        editor.document.setMaterial(loaded);
        QSignalSpy measured(&editor.window.run(), &StudyRun::rowMeasured);
        editor.window.fitAll();
        QTRY_VERIFY_WITH_TIMEOUT(measured.count() >= rows, patienceMilliseconds);
        QVERIFY(editor.window.run().isRunning());
      }
      QTRY_VERIFY_WITH_TIMEOUT(held.expired(), patienceMilliseconds);
    }
  }

  /// The ticks and the times are those of the last session.
  void settingsAreSaved() {
    QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    const Editor first;
    first.window.saveState(settings);
    settings.setValue("study/size", QSize(9000, 9000));  // of a larger screen
    Editor second(study::defaultFamilies());
    second.window.restoreState(settings);
    QVERIFY(second.window.choice().names() == fewNames);
    const QSize available = second.window.screen()->availableSize();
    QCOMPARE(second.window.size().boundedTo(available), second.window.size());
  }
};

GONIO_TEST(StudyWindowTest)
}  // namespace study_window_test

#include "study_window_test.moc"
