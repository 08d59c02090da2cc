// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTest>

#include "app/gonio/acquisition/acquisition_charts.h"
#include "app/gonio/acquisition/acquisition_files.h"
#include "app/gonio/acquisition/reconstruction_page.h"
#include "app/gonio/acquisition/samples_page.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"
#include "tests/app/gonio/acquisition_test_support.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "tests/widgets/pointer.h"
#include "widgets/acquisition/error_curve.h"
#include "widgets/acquisition/forbidden_regions_editor.h"
#include "widgets/acquisition/half_difference_chart.h"
#include "widgets/acquisition/hemisphere_chart.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/number_field.h"

namespace acquisition_panel_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

struct Editor {
  SmallLibrary library;
  BackgroundTasks tasks;
  Document document;
  AcquisitionPanel panel{document, tasks};
  QSignalSpy failed{&panel, &AcquisitionPanel::failed};

  Editor() {
    QObject::connect(&panel, &AcquisitionPanel::materialMade, &document, &Document::replaceMaterial);
    panel.resize(1400, 420);
    panel.show();
    panel.session().referenceReader().setPicture(smallPicture());
    panel.controls().training().setTraining(library.training);
    panel.controls().directions().setSamples(8);
  }
  bool settle() {
    return QTest::qWaitFor([&] { return tasks.isIdle() && panel.isSettled(); }, patienceMilliseconds);
  }
  void open(const QString& path) { document.setMaterial(loadMaterial(path.toStdString())); }
  bool acquire() {
    open(library.subject);
    panel.startButton().click();
    return settle() && panel.session().result();
  }
  QPushButton* button(const QString& text) const { return test::child<QPushButton>(panel, text); }
  QString failure() { return failed.isEmpty() ? QString() : failed.takeLast()[1].toString(); }
};

class AcquisitionPanelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anEmptyPanelSaysWhatToDo() {
    Editor editor;
    QCOMPARE(editor.panel.status(), "Press Start to choose directions.");
    for (const char* name : {"Copy", "Save Plan...", "Paste Values", "Open Values...", "Open as Material"})
      QVERIFY2(!editor.button(name)->isEnabled(), name);
    QVERIFY(editor.panel.startButton().isEnabled());
  }

  void startGoesAllTheWay() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    QVERIFY(editor.acquire());
    QVERIFY2(editor.failed.isEmpty(), qPrintable(editor.failure()));
    QCOMPARE(panel.charts().hemisphere().samples().size(), std::size_t(8));
    QCOMPARE(panel.charts().chart().samples().size(), std::size_t(8));
    QCOMPARE(panel.samples().table().model()->rowCount(), 8);
    for (int column = 0; column < AcquisitionSampleModel::ColumnCount; ++column)
      QVERIFY(!panel.samples().table().model()->index(3, column).data().toString().isEmpty());
    QCOMPARE(panel.pages().currentIndex(), int(AcquisitionPanel::reconstructionPage));
    QCOMPARE(panel.reconstruction().findChild<widgets::ReconstructionView*>()->squares().size(), 3);
    QVERIFY(panel.reconstruction().findChild<QLabel*>("numbers")->text().contains("rendered SNR"));
    QVERIFY(!panel.charts().chart().slice().deviations.empty());
    QCOMPARE(panel.curve().curve().points().size(), curveCounts(8).size());
    QCOMPARE(panel.status(), "Values: simulated from subject");
    panel.controls().directions().setSamples(9);
    Q_EMIT panel.controls().planSettingsEdited();
    QCOMPARE(panel.status(), "The settings have changed. Press Start again.");
    QVERIFY(editor.button("Start"));
  }

  void theButtonCancels() {
    Editor editor;
    editor.open(editor.library.subject);
    editor.panel.startButton().click();
    QVERIFY(editor.button("Cancel"));
    editor.panel.startButton().click();
    QVERIFY(editor.settle());
    QVERIFY(!editor.panel.session().planner().hasPlan() && editor.button("Start"));
    QCOMPARE(editor.panel.charts().hemisphere().samples().size(), std::size_t(0));
  }

  /// A plan whose reconstruction was stopped stays, and the panel says so.
  void aStoppedReconstructionIsTold() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    const auto stop = connect(&panel.session(), &AcquisitionSession::progressed, &panel, [&panel] {
      if (panel.session().step() == AcquisitionSession::Step::reconstructing) panel.session().cancel();
    });
    editor.open(editor.library.subject);
    panel.startButton().click();
    QVERIFY(editor.settle());
    QVERIFY(panel.session().planner().hasPlan() && !panel.session().result());
    QCOMPARE(panel.status(), "Stopped before the material was reconstructed. Press Start to try again.");
    QVERIFY(editor.button("Start") && editor.button("Save Plan...")->isEnabled());
    disconnect(stop);
    panel.startButton().click();
    QVERIFY(editor.settle());
    QVERIFY(panel.session().result());
  }

  /// A mark in either chart or in the table is one in all three; a click shows the slice of the sample.
  void marksAreKeptTogether() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    QVERIFY(editor.acquire());
    test::pointAt(panel.charts().hemisphere(), panel.charts().hemisphere().places(5)[0].toPoint());
    const int marked = panel.charts().hemisphere().current();
    QVERIFY(marked >= 0);
    QCOMPARE(panel.charts().chart().current(), marked);
    QCOMPARE(panel.samples().table().currentIndex().row(), marked);
    QTest::keyClick(&panel.charts().chart(), Qt::Key_Home);
    QCOMPARE(panel.charts().hemisphere().current(), 0);
    QCOMPARE(panel.samples().table().currentIndex().row(), 0);
    panel.samples().table().setCurrentIndex(panel.samples().table().model()->index(7, 2));
    QCOMPARE(panel.charts().hemisphere().current(), 7);
    QCOMPARE(panel.charts().chart().current(), 7);
    QTest::keyClick(&panel.charts().chart(), Qt::Key_Return);
    QVERIFY(panel.charts().chart().isInSlice(7));
    const DirectionPair& pair = panel.charts().chart().samples()[7];
    QVERIFY(std::abs(panel.charts().chart().slice().phiD - foldPhiD(toHalfDifference(pair.wi, pair.wo).phiD)) < 1e-6);
  }

  void thePlanIsAFile() {
    Editor editor;
    QVERIFY(editor.acquire());
    const auto plan = acquisition::parsePlan(editor.panel.files().planText().toStdString());
    QCOMPARE(plan.samples.size(), std::size_t(8));
    const QString path = editor.library.folder.filePath("plan.csv");
    QSignalSpy exported(&editor.panel, &AcquisitionPanel::exported);
    editor.panel.files().savePlan(path);
    QCOMPARE(exported.count(), 1);
    QCOMPARE(acquisition::readPlan(path.toStdString()).samples[3].order,
             editor.panel.session().planner().samplingPlan().samples[3].order);
    editor.panel.files().savePlan("/nowhere/plan.csv");
    QVERIFY(editor.failure().contains("/nowhere/plan.csv"));
    // Read again, also by another editor: the same cells in the same order.
    const auto cells = editor.panel.session().planner().selection().cells;
    editor.panel.controls().directions().setSamples(5);
    editor.panel.controls().directions().methodBox().setCurrentIndex(4);
    editor.panel.files().readPlan(path);
    QVERIFY(editor.settle());
    QCOMPARE(editor.panel.session().planner().selection().cells, cells);
    QCOMPARE(editor.panel.controls().planSettings().samples, 8);
    QVERIFY(editor.panel.session().result() && editor.panel.session().curve().size() == curveCounts(8).size());
    editor.panel.files().readPlan("/nowhere/plan.csv");
    QVERIFY(editor.failure().contains("/nowhere/plan.csv"));
    QVERIFY(editor.panel.session().planner().hasPlan());
  }

  /// What is wrong with a value is reported with its line; the values that were there stay.
  void pastedValuesAreChecked() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    QVERIFY(editor.acquire());
    const auto& plan = panel.session().planner().samplingPlan();
    QString text = QString::fromStdString(acquisition::valuesCsv(plan, panel.session().values()));
    QStringList lines = text.split('\n', Qt::SkipEmptyParts);
    const auto line =
        qsizetype(std::ranges::find_if(lines, [](const QString& one) { return one.startsWith("3,"); }) - lines.begin());
    const auto with = [&](const QString& row) {
      QStringList changed = lines;
      changed[line] = row;
      return changed.join('\n');
    };
    const QString place = QStringLiteral("line %1").arg(line + 1);
    const std::pair<QString, QString> bad[] = {{with("3,-0.1,0.1,0.1"), place},
                                               {with("3,nan,0.1,0.1"), place},
                                               {with("4,0.1,0.1,0.1"), "4"},
                                               {with("99,0.1,0.1,0.1"), place},
                                               {QStringLiteral(" \n"), "clipboard"}};
    for (const auto& [pasted, reported] : bad) {
      panel.files().paste(pasted);
      const QString failure = editor.failure();
      QVERIFY2(failure.contains(reported), qPrintable(failure));
      QVERIFY(panel.session().isSimulated());
    }
    // With tabs, as spreadsheets copy them.
    panel.files().paste(with("3,0.25,0.1,0.1").replace(',', '\t'));
    QVERIFY2(editor.failed.isEmpty(), qPrintable(editor.failure()));
    QVERIFY(!panel.session().isSimulated());
    QCOMPARE(panel.session().values().rgb[2].r, 0.25);
    QVERIFY(editor.settle());
    QCOMPARE(panel.status(), "Values: pasted");
    panel.files().readValues("/nowhere/values.csv");
    QVERIFY(editor.failure().contains("/nowhere/values.csv"));
  }

  /// The rig's limits are seen at once, and no sample lies beyond them.
  void limitsOfTheRigAreKept() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    widgets::ForbiddenRegionsEditor& forbidden = panel.controls().directions().forbidden();
    const QTableWidget& ranges = *forbidden.findChild<QTableWidget*>();
    const auto shaded = [&] {
      return std::ranges::count(panel.charts().chart().slice().states, widgets::CellState::forbidden);
    };
    QCOMPARE(shaded(), 0);
    test::child<QPushButton>(forbidden, "Add")->click();
    QVERIFY(shaded() > 0);
    ranges.item(0, 0)->setText("50");
    ranges.item(0, 1)->setText("nonsense");
    QCOMPARE(ranges.item(0, 1)->text(), "90");
    QVERIFY(editor.acquire());
    const acquisition::MeasurableDirections measurable = panel.controls().planSettings().measurable;
    QCOMPARE(measurable.forbidden.size(), std::size_t(1));
    QVERIFY(std::abs(measurable.forbidden[0].thetaI.lowest - radians(50)) < 1e-12);
    for (const DirectionPair& pair : panel.charts().hemisphere().samples())
      QVERIFY(polarAngle(pair.wi) < radians(50) + 1e-9);
    test::child<QPushButton>(forbidden, "Remove")->click();
    QVERIFY(panel.controls().planSettings().measurable.forbidden.empty());
  }

  /// What is opened does not take the place of what is measured.
  void theResultIsOpened() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    QVERIFY(editor.acquire());
    const auto result = panel.session().result();
    test::child<QPushButton>(panel.reconstruction(), "Open as Material")->click();
    QVERIFY(editor.settle());
    QVERIFY(editor.document.name().startsWith("subject from 8 samples"));
    QVERIFY(editor.document.history().canUndo());
    QCOMPARE(panel.session().result(), result);
    QCOMPARE(panel.session().referenceReader().name(), "subject");
    QCOMPARE(panel.controls().measuredMaterial().choice(), MeasuredMaterialRows::Choice::chosen);
    QCOMPARE(panel.controls().measuredMaterial().box().currentText(), "subject");
    editor.document.history().undo();
    QCOMPARE(editor.document.name(), "subject");
  }

  void anotherMaterialIsMeasuredAtTheSamePlaces() {
    Editor editor;
    AcquisitionPanel& panel = editor.panel;
    QVERIFY(editor.acquire());
    const auto cells = panel.session().planner().selection().cells;
    const double snr = panel.session().result()->error->renderedSnr;
    panel.measure(editor.library.training.ids[1]);
    QVERIFY(editor.settle());
    QCOMPARE(panel.session().planner().selection().cells, cells);
    QVERIFY(panel.session().result()->error->renderedSnr != snr);
    QVERIFY2(panel.status().contains("is in the training set"), qPrintable(panel.status()));
    const auto choose = [&](int index) {
      auto* box = test::child<QComboBox>(panel.controls(), "Reconstruct by");
      box->setCurrentIndex(index);
      Q_EMIT box->activated(index);
    };
    choose(3);
    QVERIFY(editor.settle());
    QVERIFY(panel.session().reconstructionOptions().equalNoise);
    QCOMPARE(panel.session().result()->reconstruction->ridge, acquisition::publishedRidge);
    QVERIFY(panel.session().result()->reconstruction->components <= int(cells.size()));
    choose(4);
    QVERIFY(editor.settle());
    QVERIFY(panel.session().result()->reconstruction->standardDeviation.empty());
    QVERIFY(panel.charts().chart().slice().deviations.empty());
  }
};

GONIO_TEST(AcquisitionPanelTest)
}  // namespace acquisition_panel_test

#include "acquisition_panel_test.moc"
