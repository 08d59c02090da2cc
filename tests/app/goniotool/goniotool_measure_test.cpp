// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/factor_prediction.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/goniotool/goniotool_runner.h"
#include "tests/support/test_program.h"

namespace goniotool_measure_test {
using namespace gonio;
using namespace gonio::test;
using namespace gonio::acquisition;

/// goniotool measure --factors: two curves of a material, the prediction and its error.
class GoniotoolMeasureTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    folder_.writeTable("paint.binary", "ggx", plastic, smallGrid);
    paint_ = folder_.path("paint.binary");
    table_ = readTable(paint_);
  }

  /// The command gives what the library gives.
  void predictsAsTheLibrary_data() {
    QTest::addColumn<QString>("axes");
    QTest::addColumn<QString>("bound");
    QTest::newRow("published") << "projected-deviation"
                               << "none";
    QTest::newRow("symmetric") << "symmetric-deviation"
                               << "readings";
    QTest::newRow("half-out") << "half-out"
                              << "readings";
    QTest::newRow("adaptive") << "adaptive"
                              << "readings";
  }
  void predictsAsTheLibrary() {
    QFETCH(QString, axes);
    QFETCH(QString, bound);
    const QString readings = folder_.path("readings.csv"), out = folder_.path("predicted.binary");
    const ToolResult found =
        runJson({"measure", paint_,        "--factors", axes,      "--fixed-angle", "40",      "--angles",
                 "50",      "--distances", "60",        "--bound", bound,           "--noise", "0.01",
                 "--seed",  "7",           "--out",     readings,  "--predict",     out,       "--force"});
    VERIFY_SUCCESS(found);
    const FactorPlanOptions options{
        .axes = factorAxesNamed(axes.toStdString()), .fixedAngle = radians(40), .angles = 50, .distances = 60};
    const FactorMeasurement curves = measureFactors(*table_, options, {.relative = 0.01, .seed = 7});
    const auto predicted = predictFromFactors(curves, factorBoundNamed(bound.toStdString()));
    QCOMPARE(found.json["along"].get<std::size_t>(), curves.angles.size());
    QCOMPARE(found.json["across"].get<std::size_t>(), curves.distances.size());
    QCOMPARE(found.json["samples"].get<int>() + found.json["blocked"].get<int>(), 110);
    QCOMPARE(found.json["further"].get<int>() > 0, axes == "adaptive");
    QCOMPARE(found.json["support"]["warnings"].size(), supportOf(curves).warnings.size());
    QVERIFY(std::abs(found.json["brdfSnr"].get<double>() - metrics::brdfSignalToNoiseRatio(*table_, *predicted)) <
            1e-9);
    QVERIFY(found.json["renderedSnr"].is_number() && found.json["errors"].contains("log"));
    QVERIFY(metrics::brdfSignalToNoiseRatio(*bakeTable(*predicted), *readTable(out)) > 100);
    // The readings in the file predict the same material, without the material.
    const QString again = folder_.path("again.binary");
    const ToolResult fromFile =
        runJson({"measure", "--factors", axes, "--bound", bound, "--values", readings, "--predict", again, "--force"});
    VERIFY_SUCCESS(fromFile);
    QVERIFY(!fromFile.json.contains("brdfSnr"));
    QVERIFY(metrics::brdfSignalToNoiseRatio(*readTable(out), *readTable(again)) > 100);
  }

  /// Over theta_R and |Dp| without bound, the factors are the two curves: one term. With bound they approximate.
  void factorsOfThePrediction() {
    const QString out = folder_.path("predicted.pdv");
    const QStringList command{"measure", paint_, "--factors", "projected-deviation", "--predict", out, "--force"};
    const ToolResult exact = runJson(command + QStringList{"--bound", "none"});
    VERIFY_SUCCESS(exact);
    QCOMPARE(exact.json["terms"].get<int>(), 1);
    QVERIFY(!exact.json.contains("factorsSnr"));
    const auto curves = measureFactors(*table_, {.fixedAngle = radians(60)});
    const auto factors = materials::readMaterial(out.toStdString()).brdf;
    const DirectionPair pair{fromSpherical(0.7, 0.3), fromSpherical(0.9, 2)};
    const double expected = predictFromFactors(curves, FactorBound::none)->evaluate(pair.wi, pair.wo).x;
    QVERIFY(std::abs(factors->evaluate(pair.wi, pair.wo).x / expected - 1) < 1e-4);
    const ToolResult bounded = runJson(command);
    VERIFY_SUCCESS(bounded);
    QCOMPARE(bounded.json["terms"].get<int>(), 10);
    QVERIFY(bounded.json["factorsSnr"].get<double>() > 10);
  }

  /// Without material: the directions of both curves, which a rig measures.
  void directionsToMeasure() {
    const QString out = folder_.path("directions.csv");
    const ToolResult found = runJson({"measure", "--factors", "half-difference", "--fixed-angle", "30", "--out", out});
    VERIFY_SUCCESS(found);
    QVERIFY(
        bytesOf(out).startsWith("# method: factors, half-difference\nindex,curve,theta_i,phi_i,theta_o,phi_o,order\n"));
    QCOMPARE(bytesOf(out).count('\n'), qsizetype(found.json["samples"].get<int>() + 2));
    const ToolResult noValues = runTool({"measure", "--factors", "half-difference", "--values", out});
    QCOMPARE(noValues.code, 1);
    QVERIFY(noValues.error.contains("directions.csv") && noValues.errorLines() == 1);
  }

  void unreliablePredictionsAreReported() {
    const ToolResult found = runTool({"measure", "library:rgl/acrylic_felt_green", "--factors", "projected-deviation"});
    VERIFY_SUCCESS(found);
    QVERIFY2(found.out.contains("warning: Unreliable for"), qPrintable(found.out));
  }

  void wrongUse() {
    const QString out = folder_.path("x.csv");
    for (const QStringList& wrong :
         {QStringList{"--plan", out, "--factors", "half-out"}, QStringList{"--factors", "pdv"},
          QStringList{"--out", out, "--fixed-angle", "30"}, QStringList{"--out", out},
          QStringList{"--factors", "half-out", "--values", out, "--out", out},
          QStringList{"--factors", "half-out", "--fixed-angle", "90"},
          QStringList{"--factors", "half-out", "--bound", "some"},
          QStringList{"--factors", "half-out", "--angles", "1"}})
      QVERIFY2(runTool(QStringList{"measure", paint_} + wrong).code == 2, qPrintable(wrong.join(' ')));
    QCOMPARE(runTool({"measure", "--factors", "half-out"}).code, 2);
    QCOMPARE(runTool({"measure", "--plan", out, "--out", folder_.path("y.csv")}).code, 2);
    const ToolResult same = runTool({"measure", paint_, "--factors", "half-out", "--predict", paint_});
    QVERIFY(same.code == 1 && same.error.contains("the command reads this file"));
    const ToolResult suffix = runTool({"measure", paint_, "--factors", "half-out", "--predict", folder_.path("x.txt")});
    QVERIFY(suffix.code == 1 && suffix.error.contains(".binary"));
  }

  void zEveryKeyIsDocumented() { QCOMPARE(undocumentedKeys(), QString()); }

 private:
  TestFolder folder_{"goniotool-measure"};
  QString paint_;
  std::shared_ptr<const TabulatedBrdf> table_;
};

GONIO_TEST(GoniotoolMeasureTest)
}  // namespace goniotool_measure_test

#include "goniotool_measure_test.moc"
