// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "app/gonio/study/study_window.h"
#include "core/formats/merl.h"
#include "core/io/atomic_file.h"
#include "core/models/registry.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace study_summary_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

/// Two tables, two fits.
const std::vector<std::string> fewNames{"table", "lambert", "ggx"};

enum Row { cellTable, trilinearTable, lambertFit, ggxFit };

struct Editor {
  QTemporaryDir folder;
  Document document;
  BackgroundTasks tasks;
  QStringList ids;
  std::optional<StudyWindow> window;

  /// Two grey materials, one that is not diffuse, and a file that cannot be read.
  explicit Editor(int samples = 4) {
    write("dark", *models::findModel("lambert").instantiate({{Rgb(0.1)}}));
    write("bright", *models::findModel("lambert").instantiate({{Rgb(0.6)}}));
    const models::Model& phong = models::findModel("phong");
    write("glossy", *phong.instantiate(models::defaultParameters(phong.spec())));
    ids << folder.filePath("broken.binary");
    QFile broken(ids.back());
    if (!broken.open(QIODevice::WriteOnly)) qFatal("cannot write");
    window.emplace(document, tasks);
    window->setMaterials(ids);
    study::StudyOptions options;
    options.picture = {.width = 16, .height = 16, .samples = samples};
    window->run().setOptions(options);
    window->choice().setNames(fewNames);
  }
  void write(const QString& name, const Brdf& brdf) {
    ids << folder.filePath(name + ".binary");
    io::writeFileAtomically(ids.back().toStdString(),
                            formats::encodeMerl(*bakeTable(brdf, HalfDifferenceGrid{12, 12, 12})));
  }
  StudyModel& model() { return window->run().model(); }
  QString text(int row, int column) { return model().index(row, column).data().toString(); }
  void measure() { window->run().measure({}); }
  bool finish() {
    return QTest::qWaitFor([&] { return !window->run().isRunning() && tasks.isIdle(); }, patienceMilliseconds);
  }
};

class StudySummaryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Each row is the median and the worst of what is measured; a broken file is named and holds nothing up.
  void summarisesSeveralMaterials() {
    Editor editor;
    StudyModel& model = editor.model();
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(editor.text(ggxFit, StudyModel::SnrColumn), "-");
    editor.measure();
    QVERIFY(editor.window->run().isRunning());
    QVERIFY(editor.finish());
    for (int row = 0; row < 4; ++row) QCOMPARE(editor.text(row, StudyModel::MaterialsColumn), "3");
    // The trilinear table is the material itself; Lambert's fit is exact for all but the glossy one.
    QCOMPARE(editor.text(trilinearTable, StudyModel::WorstSnrColumn), "∞");
    QCOMPARE(editor.text(lambertFit, StudyModel::WorstMaterialColumn), "glossy");
    const auto snr = [&](int column) { return -model.index(lambertFit, column).data(Qt::UserRole).toDouble(); };
    QVERIFY(snr(StudyModel::WorstSnrColumn) + 10 < snr(StudyModel::SnrColumn));
    QVERIFY2(editor.window->run().status().contains("3 of 4 materials are measured.") &&
                 editor.window->run().status().contains("broken is excluded"),
             qPrintable(editor.window->run().status()));
    for (std::size_t material = 0; material < 3; ++material) QVERIFY(model.missing(material).empty());
    const QStringList lines = editor.window->run().csv({0, 1, 2, 3}).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 5 + 1 + 4);
    QVERIFY(lines[5].endsWith("materials,min rendered SNR [dB],max rendered SNR [dB],worst material"));
    QVERIFY2(lines[6 + lambertFit].endsWith(",glossy"), qPrintable(lines[6 + lambertFit]));
    // Worse below, whatever the column.
    QAbstractItemModel& sorted = *editor.window->table().model();
    editor.window->table().sortByColumn(StudyModel::WorstSnrColumn, Qt::AscendingOrder);
    for (int row = 1; row < sorted.rowCount(); ++row)
      QVERIFY(sorted.index(row - 1, StudyModel::WorstSnrColumn).data(Qt::UserRole).toDouble() <=
              sorted.index(row, StudyModel::WorstSnrColumn).data(Qt::UserRole).toDouble());
  }

  /// Escape stops, what is measured stays, and the rest is measured from there.
  void stoppingKeepsWhatIsMeasured() {
    constexpr int manySamples = 300;  // so that it is stopped before it ends
    Editor editor(manySamples);
    StudyModel& model = editor.model();
    connect(&model, &QAbstractItemModel::dataChanged, &*editor.window, [&] {
      if (model.missing(1).size() == 2) QTest::keyClick(&*editor.window, Qt::Key_Escape);
    });
    editor.measure();
    QVERIFY(editor.finish());
    QTest::qWait(0);  // rows that were on their way
    QVERIFY(model.missing(0).empty() && !model.missing(2).empty());
    const QString first = editor.text(cellTable, StudyModel::MaterialsColumn);
    QVERIFY(first == "2");
    QObject::disconnect(&model, &QAbstractItemModel::dataChanged, &*editor.window, nullptr);
    editor.measure();
    QVERIFY(editor.finish());
    QCOMPARE(editor.text(ggxFit, StudyModel::MaterialsColumn), "3");
  }

  /// Columns of images and fits are those of one material; nothing of several can be shown or used.
  void theColumnsAreThoseOfSeveralMaterials() {
    Editor editor;
    editor.measure();
    QVERIFY(editor.finish());
    const QTreeView& table = editor.window->table();
    for (const int column : {StudyModel::MaterialsColumn, StudyModel::WorstSnrColumn, StudyModel::WorstMaterialColumn})
      QVERIFY(!table.isColumnHidden(column));
    for (const int column : {StudyModel::PlotColumn, StudyModel::ErrorColumn, StudyModel::WarningsColumn})
      QVERIFY(table.isColumnHidden(column));
    editor.window->show(ggxFit);
    QVERIFY(!editor.tasks.isRunning("study preview"));
  }

  /// The sheet has a row for each material that was measured; a broken file has none.
  void theSheetHasARowForEachMaterial() {
    Editor editor;
    editor.measure();
    QVERIFY(editor.finish());
    const widgets::ContactSheet& sheet = editor.window->sheet().sheet();
    QCOMPARE(sheet.columns(), 5);
    QCOMPARE(sheet.tiles().size(), std::size_t(3 * 5));
    QStringList first;
    for (std::size_t row = 0; row < 3; ++row) first << sheet.tiles()[5 * row].name;
    QCOMPARE(first, QStringList({"dark", "bright", "glossy"}));
    // All rows have the representations in the order of the results.
    for (std::size_t column = 1; column < 5; ++column)
      for (std::size_t row = 1; row < 3; ++row)
        QCOMPARE(sheet.tiles()[5 * row + column].name, sheet.tiles()[column].name);
  }

  /// Only what is missing is measured when other materials are selected; what is ticked no longer is dropped.
  void resultsOfMaterialsThatRemainStay() {
    Editor editor;
    editor.window->choice().setNames({"ggx"});
    editor.window->setMaterials(editor.ids.mid(0, 2));
    editor.measure();
    QVERIFY(editor.finish());
    const StudyModel::Studied bright = editor.model().studied(0, 1);
    QVERIFY(bright);
    editor.window->setMaterials({editor.ids[2], editor.ids[1]});
    QCOMPARE(editor.text(0, StudyModel::MaterialsColumn), "1");
    QVERIFY(editor.model().missing(0).size() == 1 && editor.model().missing(1).empty());
    QCOMPARE(editor.model().studied(0, 1), bright);
    editor.measure();
    QVERIFY(editor.finish());
    QCOMPARE(editor.model().studied(0, 1), bright);
    QCOMPARE(editor.text(0, StudyModel::MaterialsColumn), "2");
    // One of them alone: its pictures are those of one material.
    editor.window->setMaterials({editor.ids[1]});
    QVERIFY(!editor.model().index(0, StudyModel::NameColumn).data(Qt::DecorationRole).value<QIcon>().isNull());
    QVERIFY(editor.model().missing(0).empty());
    editor.window->choice().setNames({"lambert"});
    QVERIFY(editor.model().isEmpty());
  }

  /// A window that is closed takes its work with it.
  void closingStops() {
    Editor editor;
    editor.measure();
    editor.window.reset();
    QTRY_VERIFY_WITH_TIMEOUT(editor.tasks.isIdle(), patienceMilliseconds);
  }
};

GONIO_TEST(StudySummaryTest)
}  // namespace study_summary_test

#include "study_summary_test.moc"
