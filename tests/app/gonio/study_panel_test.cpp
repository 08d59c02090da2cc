// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_panel.h"

#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <cmath>

#include "app/gonio/study/study_view.h"
#include "core/models/registry.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"
#include "widgets/study/study_scatter.h"

namespace study_panel_test {
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
study::RepresentationChoice fewRepresentations() {
  study::RepresentationChoice choice;
  choice.names = {"table", "lambert", "ggx"};
  return choice;
}

struct Editor {
  Document document;
  BackgroundTasks tasks;
  StudyPanel panel{document, tasks};
  Editor() {
    study::StudyOptions options;
    options.picture = {.width = 16, .height = 16, .samples = 4};
    panel.run().setChoice(fewRepresentations(), options);
  }
  QPushButton* button(const QString& text) const {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
      if (one->text().remove('&') == text) return one;
    return nullptr;
  }
  QString text(int row, int column) { return panel.model().index(row, column).data().toString(); }
  bool measure() {
    panel.measure();
    return QTest::qWaitFor([&] { return !panel.run().isRunning() && panel.model().missing().empty(); },
                           patienceMilliseconds);
  }
};

enum Row { nearestTable, trilinearTable, lambertFit, ggxFit };

class StudyPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAMaterialThereIsNothingToMeasure() {
    Editor editor;
    QCOMPARE(editor.panel.model().rowCount(), 0);
    QVERIFY(!editor.button("Measure")->isEnabled());
    QVERIFY(!editor.button("Copy as CSV")->isEnabled());
    editor.panel.measure();
    QVERIFY(!editor.panel.run().isRunning());
  }

  /// The menu starts with the kinds of the run; results stay as long as their kind is selected.
  void kindsOfRepresentations() {
    Document document;
    BackgroundTasks tasks;
    StudyPanel panel(document, tasks);
    document.setMaterial(material("grey", 0.3));
    const QMenu* menu = panel.findChild<QMenu*>();
    const auto action = [&](const char* family) {
      for (QAction* one : menu->actions())
        if (one->data().toString() == family) return one;
      return static_cast<QAction*>(nullptr);
    };
    QVERIFY(action("table")->isChecked());
    QVERIFY(!action("baselines")->isChecked());
    QVERIFY(!action("components"));
    for (QAction* one : menu->actions()) one->setChecked(one->data().toString() == "table");
    QCOMPARE(panel.model().rowCount(), 2);
    panel.measure();
    QVERIFY(QTest::qWaitFor([&] { return !panel.run().isRunning() && panel.model().missing().empty(); },
                            patienceMilliseconds));
    action("baselines")->setChecked(true);
    QVERIFY(panel.model().rowCount() > 20);
    QCOMPARE(panel.model().measuredRows(), (std::vector<int>{0, 1}));
    action("table")->setChecked(false);
    QVERIFY(panel.model().measuredRows().empty());
    action("baselines")->setChecked(false);
    QCOMPARE(panel.model().rowCount(), 0);
    for (const QPushButton* button : panel.findChildren<QPushButton*>())
      QVERIFY(!button->text().contains("Measure") || !button->isEnabled());
  }

  /// "-" until measured; then each number is one.
  void rowsFillAsTheyAreMeasured() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    StudyModel& model = editor.panel.model();
    QCOMPARE(model.rowCount(), 4);
    for (int row = 0; row < 4; ++row)
      for (int column = 1; column < StudyModel::ColumnCount; ++column) {
        QCOMPARE(editor.text(row, column), "-");
        QVERIFY(model.index(row, column).data(Qt::ForegroundRole).isValid());
      }
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QVERIFY(editor.measure());
    QVERIFY(changed.count() >= 4);
    for (int row = 0; row < 4; ++row) {
      for (int column = 1; column < StudyModel::ColumnCount; ++column) QVERIFY(editor.text(row, column) != "-");
      QVERIFY(!model.index(row, 0).data(Qt::ForegroundRole).isValid());
      QVERIFY(model.toolTip(row).contains("<img src=\"data:image/png;base64,"));
    }
    QCOMPARE(editor.text(trilinearTable, StudyModel::SnrColumn), "∞");
    QCOMPARE(editor.text(trilinearTable, StudyModel::EncodingColumn), "none");
    QVERIFY(editor.button("Re-measure"));
    // Lines of what is measured, under five of where.
    QCOMPARE(editor.panel.run().csv().count('\n'), 5 + 1 + 4);
    // Anew: all rows are empty again at first.
    editor.panel.measure();
    QCOMPARE(model.missing().size(), std::size_t(4));
    QVERIFY(QTest::qWaitFor([&] { return model.missing().empty(); }, patienceMilliseconds));
  }

  /// A slider that moves shows what it does: what was shown instead goes.
  void anEditShowsTheMaterialAgain() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    editor.panel.show(ggxFit);
    QTRY_VERIFY_WITH_TIMEOUT(editor.panel.subject(), patienceMilliseconds);
    const models::Model& model = models::findModel("lambert");
    editor.document.replaceEdits({{editing::DifferentialEdit{&model, {{Rgb(0.3)}}, {{Rgb(0.5)}}}}}, "Brighter");
    QVERIFY(!editor.panel.subject());
  }

  void sortsByEachColumn() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    const QAbstractItemModel& sorted = *editor.panel.view().table().model();
    for (int column = 1; column < StudyModel::ColumnCount; ++column) {
      editor.panel.view().table().sortByColumn(column, Qt::AscendingOrder);
      for (int row = 1; row < sorted.rowCount(); ++row)
        QVERIFY(sorted.index(row - 1, column).data(Qt::UserRole).toDouble() <=
                sorted.index(row, column).data(Qt::UserRole).toDouble());
    }
    editor.panel.view().table().sortByColumn(StudyModel::SnrColumn, Qt::AscendingOrder);
    QVERIFY(sorted.index(0, StudyModel::SnrColumn).data().toString() == "∞");
  }

  /// A row is shown; the same again, Escape, or another material, and the material is.
  void aRowIsShownAndTakenBack() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    editor.panel.show(ggxFit);
    QVERIFY(!editor.panel.subject());  // not measured yet
    QVERIFY(editor.measure());
    QSignalSpy changed(&editor.panel, &StudyPanel::subjectChanged);
    const auto shows = [&](int row) {
      editor.panel.show(row);
      return QTest::qWaitFor([&] { return editor.panel.subject().has_value(); }, patienceMilliseconds);
    };
    QVERIFY(shows(ggxFit));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(editor.panel.shownName(), "GGX, 8 numbers");
    QVERIFY(editor.text(ggxFit, 0).startsWith("GGX, 8 numbers (shown"));
    QVERIFY(formOf<TabulatedBrdf>(*editor.panel.subject()->base())->grid() ==
            editor.document.material()->table()->grid());
    editor.panel.show(ggxFit);
    QVERIFY(!editor.panel.subject());
    QCOMPARE(changed.count(), 2);

    QVERIFY(shows(lambertFit));
    QTest::keyClick(&editor.panel.view().scatter(), Qt::Key_Escape);
    QVERIFY(!editor.panel.subject());
    QVERIFY(shows(lambertFit));
    QTest::keyClick(&editor.panel.view().table(), Qt::Key_Escape);
    QVERIFY(!editor.panel.subject());
    QVERIFY(shows(trilinearTable));
    QVERIFY(editor.panel.subject()->base() == editor.document.material()->table());
    editor.document.setMaterial(material("other", 0.5));
    QVERIFY(!editor.panel.subject() && editor.panel.shownName().isEmpty());
    QCOMPARE(editor.panel.model().missing().size(), std::size_t(4));
  }

  void keysShowARow() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    QVERIFY(editor.measure());
    editor.panel.view().table().setCurrentIndex(editor.panel.view().table().model()->index(0, 0));
    QVERIFY(editor.panel.view().scatter().current() >= 0);
    QTest::keyClick(&editor.panel.view().table(), Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return editor.panel.subject().has_value(); }, patienceMilliseconds));
  }

  void theBudgetChoosesAndIsTaken() {
    Editor editor;
    const models::Model& phong = models::findModel("phong");  // that no fit of the two matches exactly
    editor.document.setMaterial(material("glossy", *phong.instantiate(models::defaultParameters(phong.spec()))));
    QVERIFY(editor.measure());
    QSignalSpy useRequested(&editor.panel, &StudyPanel::useRequested);
    QPushButton& use = editor.panel.budgetBar().useButton();
    QVERIFY(use.isEnabled());
    // 12 bytes: only three numbers fit.
    editor.panel.budgetBar().setBudget({.frameMilliseconds = {}, .renderedSnr = {}, .bytes = 100});
    QVERIFY(editor.text(lambertFit, 0).endsWith("(best)") || editor.text(ggxFit, 0).endsWith("(best)"));
    use.click();
    QCOMPARE(useRequested.count(), 1);
    QCOMPARE(useRequested[0][0].value<study::Representation>().kind->use, study::RepresentationUse::editModel);
    editor.panel.budgetBar().setBudget({.frameMilliseconds = {}, .renderedSnr = 200, .bytes = 100});
    QVERIFY(!use.isEnabled());
  }

  /// What is done stays, and the rest goes on from there.
  void stoppingKeepsWhatIsMeasured() {
    Editor editor;
    editor.document.setMaterial(material("grey", 0.3));
    StudyModel& model = editor.panel.model();
    connect(&model, &QAbstractItemModel::dataChanged, &editor.panel, [&] {
      if (model.missing().size() == 3 && editor.panel.run().isRunning()) editor.tasks.cancelTopmost();
    });
    editor.panel.measure();
    QVERIFY(QTest::qWaitFor([&] { return !editor.panel.run().isRunning(); }, patienceMilliseconds));
    QTest::qWait(0);  // rows that were on their way
    const std::size_t left = model.missing().size();
    QVERIFY(left < 4);
    const auto first = model.studied(nearestTable);
    if (left > 0) {
      QVERIFY(editor.button("Measure"));
      QVERIFY(editor.measure());
    }
    QVERIFY(first && model.studied(nearestTable) == first);
  }
};

GONIO_TEST(StudyPanelTest)
}  // namespace study_panel_test

#include "study_panel_test.moc"
