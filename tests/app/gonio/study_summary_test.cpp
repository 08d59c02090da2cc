// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "app/gonio/study/study_summary_window.h"
#include "core/formats/merl.h"
#include "core/io/atomic_file.h"
#include "core/models/registry.h"
#include "core/study/study_record.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace study_summary_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

/// Two tables, two fits.
study::RepresentationChoice fewRepresentations() {
  study::RepresentationChoice choice;
  choice.names = {"table", "lambert", "ggx"};
  return choice;
}

enum Row { nearestTable, trilinearTable, lambertFit, ggxFit };

struct Editor {
  QTemporaryDir folder;
  BackgroundTasks tasks;
  QStringList ids;
  std::optional<StudySummaryWindow> window;

  /// Two grey materials, one that is not diffuse, and a file that cannot be read.
  explicit Editor(int samples = 4) {
    write("dark", *models::findModel("lambert").instantiate({{Rgb(0.1)}}));
    write("bright", *models::findModel("lambert").instantiate({{Rgb(0.6)}}));
    const models::Model& phong = models::findModel("phong");
    write("glossy", *phong.instantiate(models::defaultParameters(phong.spec())));
    ids << folder.filePath("broken.binary");
    QFile broken(ids.back());
    if (!broken.open(QIODevice::WriteOnly)) qFatal("cannot write");
    window.emplace(tasks, ids, nullptr);
    study::StudyOptions options;
    options.picture = {.width = 16, .height = 16, .samples = samples};
    window->setChoice(fewRepresentations(), options);
  }
  void write(const QString& name, const Brdf& brdf) {
    ids << folder.filePath(name + ".binary");
    io::writeFileAtomically(ids.back().toStdString(),
                            formats::encodeMerl(*bakeTable(brdf, HalfDifferenceGrid{12, 12, 12})));
  }
  QString text(int row, int column) { return window->model().index(row, column).data().toString(); }
  bool finish() {
    return QTest::qWaitFor([&] { return !window->isRunning() && tasks.isIdle(); }, patienceMilliseconds);
  }
};

class StudySummaryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Each row is the median and the worst of what is measured; a broken file is named and holds nothing up.
  void summarisesSeveralMaterials() {
    Editor editor;
    StudySummaryModel& model = editor.window->model();
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(editor.text(ggxFit, StudySummaryModel::MedianSnrColumn), "-");
    editor.window->measure();
    QVERIFY(editor.window->isRunning());
    QVERIFY(editor.finish());
    for (int row = 0; row < 4; ++row) QCOMPARE(editor.text(row, StudySummaryModel::MaterialsColumn), "3");
    // The trilinear table is the material itself; Lambert's fit is exact for all but the glossy one.
    QCOMPARE(editor.text(trilinearTable, StudySummaryModel::WorstSnrColumn), "∞");
    QCOMPARE(editor.text(lambertFit, StudySummaryModel::WorstMaterialColumn), "glossy");
    const auto snr = [&](int column) { return -model.index(lambertFit, column).data(Qt::UserRole).toDouble(); };
    QVERIFY(snr(StudySummaryModel::WorstSnrColumn) + 10 < snr(StudySummaryModel::MedianSnrColumn));
    QVERIFY2(editor.window->status().contains("3 of 4 materials are measured.") &&
                 editor.window->status().contains("broken is excluded"),
             qPrintable(editor.window->status()));
    for (std::size_t material = 0; material < 3; ++material) QVERIFY(model.missing(material).empty());
    const QStringList lines = editor.window->csv().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 5 + 1 + 4);
    QVERIFY(lines[5].endsWith("materials,min rendered SNR [dB],max rendered SNR [dB],worst material"));
    QVERIFY2(lines[6 + lambertFit].endsWith(",glossy"), qPrintable(lines[6 + lambertFit]));
    // Worse below, whatever the column.
    QAbstractItemModel& sorted = *editor.window->table().model();
    editor.window->table().sortByColumn(StudySummaryModel::WorstSnrColumn, Qt::AscendingOrder);
    for (int row = 1; row < sorted.rowCount(); ++row)
      QVERIFY(sorted.index(row - 1, StudySummaryModel::WorstSnrColumn).data(Qt::UserRole).toDouble() <=
              sorted.index(row, StudySummaryModel::WorstSnrColumn).data(Qt::UserRole).toDouble());
  }

  /// Escape stops, what is measured stays, and the rest is measured from there.
  void stoppingKeepsWhatIsMeasured() {
    constexpr int manySamples = 300;  // so that it is stopped before it ends
    Editor editor(manySamples);
    StudySummaryModel& model = editor.window->model();
    connect(&model, &QAbstractItemModel::dataChanged, &*editor.window, [&] {
      if (model.missing(1).size() == 2) QTest::keyClick(&*editor.window, Qt::Key_Escape);
    });
    editor.window->measure();
    QVERIFY(editor.finish());
    QTest::qWait(0);  // rows that were on their way
    QVERIFY(model.missing(0).empty() && !model.missing(2).empty());
    const QString first = editor.text(nearestTable, StudySummaryModel::MaterialsColumn);
    QVERIFY(first == "2");
    QObject::disconnect(&model, &QAbstractItemModel::dataChanged, &*editor.window, nullptr);
    editor.window->measure();
    QVERIFY(editor.finish());
    QCOMPARE(editor.text(ggxFit, StudySummaryModel::MaterialsColumn), "3");
  }

  /// What is measured of kinds that stay ticked is kept.
  void kindsAreChosen() {
    Editor editor;
    const auto boxes = editor.window->findChildren<QCheckBox*>();
    const auto offered = study::familiesWithoutFurtherData(), chosen = study::defaultFamilies();
    QCOMPARE(boxes.size(), qsizetype(offered.size()));
    for (std::size_t i = 0; i < offered.size(); ++i)
      QCOMPARE(boxes[qsizetype(i)]->isChecked(), std::ranges::count(chosen, offered[i]) > 0);
    for (QCheckBox* box : boxes) box->setChecked(false);
    QCOMPARE(editor.window->model().rowCount(), 0);
    for (QPushButton* button : editor.window->findChildren<QPushButton*>()) QVERIFY(!button->isEnabled());
    boxes[0]->setChecked(true);
    QCOMPARE(editor.window->model().rowCount(), 2);
  }

  /// A window that is closed takes its work with it.
  void closingStops() {
    Editor editor;
    editor.window->measure();
    editor.window.reset();
    QTRY_VERIFY_WITH_TIMEOUT(editor.tasks.isIdle(), patienceMilliseconds);
  }
};

GONIO_TEST(StudySummaryTest)
}  // namespace study_summary_test

#include "study_summary_test.moc"
