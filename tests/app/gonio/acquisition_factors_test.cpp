// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>

#include "app/gonio/acquisition/acquisition_charts.h"
#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/factor_page.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/gonio/acquisition_test_support.h"
#include "tests/support/test_program.h"
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
};

class AcquisitionFactorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutMaterialNothingIsMeasured() {
    Editor editor;
    QVERIFY(editor.settle());
    QVERIFY(!editor.page.result() && !editor.page.openButton().isEnabled());
    QVERIFY(editor.page.numbers().isEmpty() && editor.page.warnings().isEmpty());
    QVERIFY(editor.page.curves().content().angles.empty());
  }

  /// Curves and prediction are those of core; the page shows readings, pictures and errors.
  void measuresTheOpenMaterial() {
    Editor editor;
    QVERIFY(editor.open());
    const FactorResult& result = *editor.page.result();
    const auto table = materials::readMaterial(editor.library.subject.toStdString()).tabulated();
    const auto expected = acquisition::measureFactors(*table, editor.page.settings().plan);
    QVERIFY(result.curves.along == expected.along && result.curves.across == expected.across);
    QCOMPARE(editor.page.curves().content().angles.size(), expected.angles.size());
    QVERIFY(std::abs(editor.page.curves().content().angles.back() - 89) < 1e-9);
    QCOMPARE(editor.page.view().squares().size(), 3);
    QVERIFY(editor.page.numbers().contains("rendered SNR") && editor.page.numbers().contains("readings"));
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
    QVERIFY(editor.page.curves().content().distances == editor.page.result()->curves.distances);
    editor.page.axesBox().setCurrentIndex(int(acquisition::FactorAxes::halfDifference));
    Q_EMIT editor.page.axesBox().activated(0);
    QVERIFY(editor.settle() && editor.page.result());
    const double last = editor.page.result()->curves.distances.back();
    QVERIFY(std::abs(editor.page.curves().content().distances.back() - last * 180 / pi) < 1e-9);
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
      editor.page.axesBox().setCurrentIndex(int(acquisition::FactorAxes::projectedDeviation));
      Q_EMIT editor.page.axesBox().activated(0);
    }));
    QVERIFY(editor.page.result()->curves.axes == acquisition::FactorAxes::projectedDeviation);
    QVERIFY(change([&] {
      editor.page.fixedAngle().setValue(radians(20));
      Q_EMIT editor.page.fixedAngle().valueEdited(radians(20));
    }));
    QVERIFY(std::abs(editor.page.result()->curves.fixedAngle - radians(20)) < 1e-9);
    const double bounded = editor.snr();
    QVERIFY(change([&] { editor.page.boundBox().click(); }));
    QVERIFY(editor.page.settings().bound == acquisition::FactorBound::none);
    QVERIFY2(editor.snr() < bounded, qPrintable(QString("%1 %2").arg(editor.snr()).arg(bounded)));
    QVERIFY(editor.page.warnings().contains("Unreliable for"));
    QVERIFY(change([&] { Q_EMIT editor.panel.controls().noiseEdited(); }));
  }

  /// The prediction becomes the material of the document: one undo step.
  void opensThePrediction() {
    Editor editor;
    QVERIFY(editor.open());
    QCOMPARE(editor.page.resultName(), QString("subject from two curves"));
    const auto predicted = editor.page.result()->table;
    editor.page.openButton().click();
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
