// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_side.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"

namespace material_estimator_test {
using namespace gonio;
using widgets::MaterialEstimator;

widgets::PreviewSubject ggx(double roughness) {
  const models::Model& model = models::findModel("ggx");
  models::ParameterValues parameters = models::defaultParameters(model.spec());
  parameters.values[*model.spec().find("roughness")] = Rgb(roughness);
  return {widgets::StandaloneModel{&model, parameters}};
}

class MaterialEstimatorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Of many requests the last one is reported, once: what came between is left out.
  void theNewestRequestWins() {
    MaterialEstimator estimator;
    QSignalSpy reported(&estimator, &MaterialEstimator::estimated);
    for (const double roughness : {0.9, 0.5, 0.3, 0.05}) estimator.request(ggx(roughness));
    QVERIFY(estimator.isBusy());
    QTRY_VERIFY(!estimator.isBusy());
    QCOMPARE(reported.count(), 1);
    const auto estimate = reported.front().front().value<widgets::MaterialEstimate>();
    QVERIFY(areSimilar(*estimate.density, TabulatedDensity(*widgets::subjectBrdf(ggx(0.05)))));
    QVERIFY(!areSimilar(*estimate.density, TabulatedDensity(*widgets::subjectBrdf(ggx(0.9)))));
  }

  void cancelledRequestsAreNotTold() {
    MaterialEstimator estimator;
    QSignalSpy reported(&estimator, &MaterialEstimator::estimated);
    estimator.request(ggx(0.3));
    estimator.cancel();
    QTRY_VERIFY(!estimator.isBusy());
    QCOMPARE(reported.count(), 0);
    estimator.request({});  // nothing to estimate
    QVERIFY(!estimator.isBusy());
  }

  /// What cannot be estimated is reported, and the next request gets its chance.
  void aFailureIsTold() {
    widgets::PreviewSubject wrong = ggx(0.3);
    std::get<widgets::StandaloneModel>(wrong.shown).parameters.values.clear();
    {
      MaterialEstimator estimator;
      estimator.request(wrong);  // destroyed with the failure
    }
    MaterialEstimator estimator;
    QSignalSpy reported(&estimator, &MaterialEstimator::estimated), failures(&estimator, &MaterialEstimator::failed);
    estimator.request(wrong);
    QTRY_COMPARE(failures.count(), 1);
    QVERIFY(!failures[0][0].toString().isEmpty() && !estimator.isBusy());
    estimator.request(ggx(0.3));
    QTRY_COMPARE(reported.count(), 1);
    QCOMPARE(failures.count(), 1);
  }

  /// Destroyed while it works: it waits until no thread uses the material, and reports nothing.
  void mayBeDestroyedWhileBusy() {
    const std::shared_ptr<const Brdf> brdf = models::findModel("lambert").instantiate({{Rgb(0.3)}});
    int reports = 0;
    for (int i = 0; i < 20; ++i) {
      MaterialEstimator estimator;
      connect(&estimator, &MaterialEstimator::estimated, this, [&reports] { ++reports; });
      connect(&estimator, &MaterialEstimator::failed, this, [&reports] { ++reports; });
      estimator.request(widgets::measuredSubject(brdf));
      QVERIFY(estimator.isBusy());
    }
    QCOMPARE(brdf.use_count(), 1L);
    QCoreApplication::processEvents();
    QCOMPARE(reports, 0);
  }
};

GONIO_TEST(MaterialEstimatorTest)
}  // namespace material_estimator_test

#include "material_estimator_test.moc"
