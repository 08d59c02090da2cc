// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <algorithm>

#include "app/gonio/acquisition/acquisition_charts.h"
#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/factor_page.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/gonio/acquisition_test_support.h"
#include "tests/support/test_program.h"
#include "tests/widgets/child.h"
#include "widgets/acquisition/factor_curves.h"
#include "widgets/acquisition/reconstruction_view.h"
#include "widgets/inputs/number_field.h"

namespace acquisition_factors_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

/// The acquisition panel at its page of two curves.
struct Editor {
  SmallLibrary library;
  BackgroundTasks tasks;
  Document document;
  AcquisitionPanel panel{document, tasks};
  QSignalSpy failed{&panel, &AcquisitionPanel::failed};
  FactorPage& page = panel.factors();

  Editor() {
    QObject::connect(&panel, &AcquisitionPanel::materialMade, &document, &Document::replaceMaterial);
    panel.resize(1400, 520);
    panel.show();
    panel.session().referenceReader().setPicture(smallPicture());
    panel.pages().setCurrentIndex(AcquisitionPanel::factorPage);
  }
  bool settle() {
    return QTest::qWaitFor([&] { return tasks.isIdle() && panel.isSettled(); }, patienceMilliseconds);
  }
  bool open() {
    document.setMaterial(loadMaterial(library.subject.toStdString()));
    return settle() && page.result();
  }
  double snr() const { return page.result()->error->renderedSnr; }
  QString path(const QString& name) const { return library.folder.filePath(name); }
  QComboBox& axes() const { return *test::child<QComboBox>(page, "Axes"); }
  widgets::NumberField& fixedAngle() const { return *test::child<widgets::NumberField>(page, "Fixed angle"); }
  widgets::NumberField& readingCount() const { return *test::child<widgets::NumberField>(page, "Readings per curve"); }
  QCheckBox& bound() const { return *page.findChild<QCheckBox*>(); }
  QPushButton& button(const QString& text) const { return *test::child<QPushButton>(page, text); }
  QString text(const QString& label) const { return page.findChild<QLabel*>(label)->text(); }
  const widgets::FactorCurves::Content& curves() const { return page.findChild<widgets::FactorCurves*>()->content(); }
  qsizetype pictureCount() const { return page.findChild<widgets::ReconstructionView*>()->squares().size(); }
  /// The file of the readings; empty: they are simulated.
  QString readingsName() const {
    if (!button("Simulate Readings").isEnabled()) return {};
    return text("numbers").section("readings from ", 1).section(" · ", 0, 0);
  }
  void chooseAxes(acquisition::FactorAxes axes) {
    this->axes().setCurrentIndex(int(axes));
    Q_EMIT this->axes().activated(int(axes));
  }
  /// Opens a file that cannot be used; returns the error.
  QString errorOf(const QString& readings) {
    failed.clear();
    page.openReadings(path(readings));
    return failed.isEmpty() ? QString() : failed.takeFirst().at(1).toString();
  }
  /// Writes readings of the subject with the functions of core, as goniotool does.
  acquisition::FactorReadings write(const QString& name, const acquisition::FactorPlanOptions& options) {
    const auto table = materials::readMaterial(library.subject.toStdString()).tabulated();
    acquisition::FactorReadings readings{acquisition::planFactors(options), {}};
    readings.values = acquisition::measure(*table, readings.plan.plan);
    acquisition::writeFactorReadings(readings.plan, readings.values, path(name).toStdString());
    return readings;
  }
  void writeText(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  }
};

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Equal up to the six decimals of degrees in files.
bool areClose(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < 1e-6; });
}
bool areClose(const acquisition::FactorMeasurement& a, const acquisition::FactorMeasurement& b) {
  bool close = a.axes == b.axes && areClose(a.angles, b.angles) && areClose(a.distances, b.distances);
  for (std::size_t channel = 0; channel < 3; ++channel)
    close = close && areClose(a.along[channel], b.along[channel]) && areClose(a.across[channel], b.across[channel]);
  return close;
}

class AcquisitionFactorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutMaterialNothingIsMeasured() {
    Editor editor;
    QVERIFY(editor.settle());
    QVERIFY(!editor.page.result() && !editor.button("Open as Material").isEnabled());
    QVERIFY(editor.text("numbers").isEmpty() && editor.text("warnings").isEmpty());
    QVERIFY(editor.curves().angles.empty());
  }

  /// Curves and prediction are those of core; the page shows readings, pictures and errors.
  void measuresTheOpenMaterial() {
    Editor editor;
    QVERIFY(editor.open());
    const FactorResult& result = *editor.page.result();
    const auto table = materials::readMaterial(editor.library.subject.toStdString()).tabulated();
    const auto expected = acquisition::measureFactors(*table, editor.page.settings().plan);
    QVERIFY(result.curves.along == expected.along && result.curves.across == expected.across);
    QCOMPARE(editor.curves().angles.size(), expected.angles.size());
    QVERIFY(std::abs(editor.curves().angles.back() - 89) < 1e-9);
    QCOMPARE(editor.pictureCount(), 3);
    QVERIFY(editor.text("numbers").contains("rendered SNR") && editor.text("numbers").contains("readings"));
    // Adaptive axes are the default.
    QVERIFY(expected.axes == acquisition::FactorAxes::adaptive && editor.text("numbers").contains("at further angles"));
    QVERIFY(std::abs(result.error->logError - metrics::brdfError(metrics::BrdfMetric::log, *table, *result.table)) <
            1e-12);
    QVERIFY(editor.panel.charts().isHidden());
    editor.panel.pages().setCurrentIndex(AcquisitionPanel::samplesPage);
    QVERIFY(!editor.panel.charts().isHidden());
    QVERIFY(editor.failed.isEmpty());
  }

  /// A distance that is an angle is shown in degrees.
  void showsAnglesInDegrees() {
    Editor editor;
    QVERIFY(editor.open());
    QVERIFY(editor.curves().distances == editor.page.result()->curves.distances);
    editor.axes().setCurrentIndex(int(acquisition::FactorAxes::halfDifference));
    Q_EMIT editor.axes().activated(0);
    QVERIFY(editor.settle() && editor.page.result());
    const double last = editor.page.result()->curves.distances.back();
    QVERIFY(std::abs(editor.curves().distances.back() - last * 180 / pi) < 1e-9);
  }

  void eachChangeMeasuresAgain() {
    Editor editor;
    QVERIFY(editor.open());
    const auto change = [&](const std::function<void()>& act) {
      const FactorResultPtr before = editor.page.result();
      act();
      return editor.settle() && editor.page.result() && editor.page.result() != before;
    };
    QVERIFY(change([&] {
      editor.axes().setCurrentIndex(int(acquisition::FactorAxes::projectedDeviation));
      Q_EMIT editor.axes().activated(0);
    }));
    QVERIFY(editor.page.result()->curves.axes == acquisition::FactorAxes::projectedDeviation);
    QVERIFY(change([&] {
      editor.fixedAngle().setValue(radians(20));
      Q_EMIT editor.fixedAngle().valueEdited(radians(20));
    }));
    QVERIFY(std::abs(editor.page.result()->curves.fixedAngle - radians(20)) < 1e-9);
    const double bounded = editor.snr();
    QVERIFY(change([&] { editor.bound().click(); }));
    QVERIFY(editor.page.settings().bound == acquisition::FactorBound::none);
    QVERIFY2(editor.snr() < bounded, qPrintable(QString("%1 %2").arg(editor.snr()).arg(bounded)));
    QVERIFY(editor.text("warnings").contains("Unreliable for"));
    QVERIFY(change([&] { Q_EMIT editor.panel.controls().noiseEdited(); }));
  }

  /// The file is that of goniotool; opening it restores settings, curves and prediction.
  void savesAndOpensReadings() {
    Editor editor;
    QVERIFY(editor.open());
    editor.fixedAngle().setValue(radians(40));
    editor.readingCount().setValue(30);
    editor.chooseAxes(acquisition::FactorAxes::halfDifference);
    QVERIFY(editor.settle() && editor.page.result());
    const FactorResultPtr saved = editor.page.result();
    const int undoSteps = editor.document.history().index();
    QSignalSpy exported(&editor.panel, &AcquisitionPanel::exported);
    editor.page.saveReadings(editor.path("saved.csv"));
    QCOMPARE(exported.size(), 1);
    acquisition::FactorPlanOptions options{
        .axes = acquisition::FactorAxes::halfDifference, .fixedAngle = radians(40), .angles = 30, .distances = 30};
    editor.write("expected.csv", options);
    QCOMPARE(bytesOf(editor.path("saved.csv")), bytesOf(editor.path("expected.csv")));

    editor.fixedAngle().setValue(radians(60));
    editor.readingCount().setValue(90);
    editor.chooseAxes(acquisition::FactorAxes::symmetricDeviation);
    QVERIFY(editor.settle() && !areClose(editor.page.result()->curves, saved->curves));
    editor.page.openReadings(editor.path("saved.csv"));
    QVERIFY(editor.settle() && editor.failed.isEmpty() && editor.page.result());
    QCOMPARE(editor.readingsName(), QString("saved.csv"));
    QVERIFY(editor.page.settings().plan.axes == options.axes);
    QVERIFY(std::abs(editor.fixedAngle().value() - options.fixedAngle) < 1e-7);
    QCOMPARE(editor.readingCount().value(), 30.0);
    QVERIFY(areClose(editor.page.result()->curves, saved->curves));
    QVERIFY(editor.curves().along == editor.page.result()->curves.along);
    QVERIFY(std::abs(editor.snr() - saved->error->renderedSnr) < 0.01);
    QVERIFY(editor.text("numbers").contains("readings from saved.csv"));
    QCOMPARE(editor.page.resultName(), QString("saved from two curves"));
    QCOMPARE(editor.document.history().index(), undoSteps);

    // Settings of the file are fixed, and noise has no effect, until the readings are simulated again.
    QVERIFY(!editor.fixedAngle().isEnabled() && !editor.readingCount().isEnabled());
    QVERIFY(editor.fixedAngle().toolTip().contains("saved.csv"));
    const FactorResultPtr opened = editor.page.result();
    Q_EMIT editor.panel.controls().noiseEdited();
    QVERIFY(editor.settle() && editor.page.result() == opened);
    editor.bound().click();
    QVERIFY(editor.settle() && editor.page.result() != opened);
    QVERIFY(areClose(editor.page.result()->curves, saved->curves));
    editor.button("Simulate Readings").click();
    QVERIFY(editor.settle() && editor.readingsName().isEmpty());
    QVERIFY(editor.fixedAngle().isEnabled() && editor.readingCount().isEnabled());
    QVERIFY(areClose(editor.page.result()->curves, saved->curves));
    QVERIFY(!editor.text("numbers").contains("saved.csv"));
  }

  /// Readings of a rig need no material; with a material, the prediction is compared with it.
  void opensReadingsWithoutMaterial() {
    Editor editor;
    const auto written = editor.write("rig.csv", {});
    editor.page.openReadings(editor.path("rig.csv"));
    QVERIFY(editor.settle() && editor.failed.isEmpty());
    const FactorResultPtr alone = editor.page.result();
    QVERIFY(alone && !alone->error && editor.button("Open as Material").isEnabled());
    QVERIFY(areClose(alone->curves, acquisition::factorMeasurement(written.plan, written.values)));
    QCOMPARE(editor.pictureCount(), 1);
    QVERIFY(editor.open());
    QVERIFY(editor.page.result()->error && editor.readingsName() == "rig.csv");
    QCOMPARE(editor.pictureCount(), 3);
    QVERIFY(areClose(editor.page.result()->curves, alone->curves));
  }

  /// Readings with a fixed viewer serve all axes but one, which is refused: the previous axes stay.
  void openedReadingsOverOtherAxes() {
    using acquisition::FactorAxes;
    Editor editor;
    editor.write("rig.csv", {.axes = FactorAxes::projectedDeviation});
    QVERIFY(editor.open());
    editor.page.openReadings(editor.path("rig.csv"));
    QVERIFY(editor.settle());
    editor.chooseAxes(FactorAxes::symmetricDeviation);
    QVERIFY(editor.settle() && editor.failed.isEmpty());
    QVERIFY(editor.page.result()->curves.axes == FactorAxes::symmetricDeviation);
    editor.page.saveReadings(editor.path("symmetric.csv"));
    QVERIFY(bytesOf(editor.path("symmetric.csv")).startsWith("# method: factors, symmetric-deviation\n"));
    editor.chooseAxes(FactorAxes::halfOut);
    QVERIFY(editor.settle() && editor.failed.isEmpty());
    editor.chooseAxes(FactorAxes::symmetricDeviation);
    QVERIFY(editor.settle());
    const FactorResultPtr before = editor.page.result();
    editor.chooseAxes(FactorAxes::halfDifference);
    QVERIFY(editor.settle());
    QCOMPARE(editor.failed.size(), 1);
    QVERIFY(editor.failed[0][1].toString().contains("rig.csv: sample"));
    QVERIFY(editor.page.settings().plan.axes == FactorAxes::symmetricDeviation);
    QVERIFY(editor.page.result() == before);
  }

  /// An error names the file, what was found and what was expected; the previous readings stay.
  void unusableReadingsAreReported() {
    using acquisition::FactorAxes;
    Editor editor;
    QVERIFY(editor.open());
    const FactorResultPtr before = editor.page.result();
    const auto readings = editor.write("rig.csv", {.axes = FactorAxes::halfDifference});
    const QByteArray text = bytesOf(editor.path("rig.csv"));
    QVERIFY(editor.errorOf("absent.csv").contains("absent.csv: cannot be opened"));
    acquisition::writeFactorReadings(readings.plan, {}, editor.path("directions.csv").toStdString());
    QVERIFY(editor.errorOf("directions.csv").contains("directions.csv: line 2: found the columns index, curve"));
    editor.writeText("curve.csv", QByteArray(text).replace("across", "beside"));
    QVERIFY(
        editor.errorOf("curve.csv").contains("found 'beside' in the column curve, expected along, across or further"));
    editor.writeText("axes.csv", QByteArray(text).replace("half-difference", "half-out"));
    QString error = editor.errorOf("axes.csv");
    QVERIFY2(error.contains("axes.csv: sample") && !error.contains("Select the axes"), qPrintable(error));
    // Without the comment the selected axes are used.
    editor.writeText("unnamed.csv", QByteArray(text).remove(0, text.indexOf('\n') + 1));
    error = editor.errorOf("unnamed.csv");
    QVERIFY2(error.contains("unnamed.csv: sample") && error.contains("Select the axes"), qPrintable(error));
    QVERIFY(editor.settle() && editor.page.result() == before && editor.readingsName().isEmpty());
    editor.chooseAxes(FactorAxes::halfDifference);
    QVERIFY(editor.errorOf("unnamed.csv").isEmpty());
    QVERIFY(editor.settle() && editor.readingsName() == "unnamed.csv");
    editor.page.saveReadings(editor.path("no-folder/saved.csv"));
    QCOMPARE(editor.failed.size(), 1);
    QVERIFY(editor.failed[0][1].toString().contains("no-folder/saved.csv"));
  }

  /// Buttons without effect are disabled, and state why.
  void buttonsAreEnabledWhereTheyHaveAnEffect() {
    Editor editor;
    QVERIFY(editor.settle());
    QVERIFY(editor.button("Open Readings...").isEnabled());
    QVERIFY(!editor.button("Save Readings...").isEnabled() && !editor.button("Simulate Readings").isEnabled());
    QVERIFY(editor.button("Save Readings...").toolTip().startsWith("Available when"));
    QVERIFY(editor.button("Simulate Readings").toolTip().startsWith("Available when"));
    QVERIFY(editor.open());
    QVERIFY(editor.button("Save Readings...").isEnabled() && !editor.button("Simulate Readings").isEnabled());
    QVERIFY(editor.button("Save Readings...").toolTip().startsWith("Saves"));
    editor.page.saveReadings(editor.path("saved.csv"));
    editor.page.openReadings(editor.path("saved.csv"));
    QVERIFY(editor.settle() && editor.button("Simulate Readings").isEnabled());
  }

  /// The dialogs start in the folder of the last file of an acquisition.
  void dialogsRememberTheFolder() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    Editor editor;
    QVERIFY(editor.open());
    const auto choose = [&](QPushButton& button, const QString& name) {
      button.click();
      auto* dialog = editor.panel.findChild<QFileDialog*>();
      QVERIFY(dialog);
      if (dialog->acceptMode() == QFileDialog::AcceptSave)
        QCOMPARE(QFileInfo(dialog->selectedFiles().value(0)).fileName(), QString("subject readings.csv"));
      else
        QCOMPARE(dialog->directory().path(), QDir(editor.library.folder.path()).path());
      Q_EMIT dialog->fileSelected(editor.path(name));
      delete dialog;
    };
    choose(editor.button("Save Readings..."), "chosen.csv");
    QVERIFY(QFile::exists(editor.path("chosen.csv")));
    choose(editor.button("Open Readings..."), "chosen.csv");
    QVERIFY(editor.settle() && editor.readingsName() == "chosen.csv");
  }

  /// The prediction becomes the material of the document: one undo step.
  void opensThePrediction() {
    Editor editor;
    QVERIFY(editor.open());
    QCOMPARE(editor.page.resultName(), QString("subject from two curves"));
    const auto predicted = editor.page.result()->table;
    editor.button("Open as Material").click();
    QVERIFY(editor.settle());
    QVERIFY(editor.failed.isEmpty());
    QVERIFY(editor.document.name().startsWith("subject from two curves"));
    QVERIFY(metrics::brdfSignalToNoiseRatio(*predicted, *editor.document.base()) > 80);
    editor.document.history().undo();
    QCOMPARE(editor.document.name(), QString("subject"));
  }
};

GONIO_TEST(AcquisitionFactorsTest)
}  // namespace acquisition_factors_test

#include "acquisition_factors_test.moc"
