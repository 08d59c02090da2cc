// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_plan.h"

#include <QTest>
#include <cmath>

#include "core/acquisition/factor_prediction.h"
#include "tests/core/acquisition/factor_oracles.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace factor_readings_file_test {
using namespace gonio;
using namespace gonio::acquisition;
using acquisition::FactorAxes;

const std::string good =
    "index,curve,theta_i,phi_i,theta_o,phi_o,r,g,b\n"
    "1,along,30,180,30,0,0.5,0.4,0.3\n2,along,60,180,60,0,1,0.9,0.8\n"
    "3,across,60,180,60,0,1,0.9,0.8\n4,across,20,180,60,0,0.1,0.1,0.1\n";

std::string readingsError(const std::string& text) {
  return test::errorOf([&] {
    const FactorReadings readings = parseFactorReadings(text, FactorAxes::projectedDeviation);
    acquisition::factorMeasurement(readings.plan, readings.values);
  });
}

std::string with(std::string_view what, std::string_view by) {
  std::string text = good;
  text.replace(text.find(what), what.size(), by);
  return text;
}

class FactorReadingsFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Values to the last bit, angles to 1e-6 degrees; the curves are those of the simulated readings.
  void roundTrip() {
    const auto material = test::productOfCurves(FactorAxes::projectedDeviation);
    const acquisition::FactorPlan plan = acquisition::planFactors({.fixedAngle = 0.7});
    const acquisition::MeasuredValues values = acquisition::measure(material, plan.plan, {.relative = 0.01});
    const auto path = test::outputPath("factors/readings.csv");
    writeFactorReadings(plan, values, path);
    const FactorReadings found = readFactorReadings(path, FactorAxes::projectedDeviation);
    QVERIFY(found.values.rgb == values.rgb && found.values.noise == values.noise);
    QVERIFY(found.plan.curves == plan.curves);
    QCOMPARE(found.plan.plan.method, plan.plan.method);
    for (std::size_t i = 0; i < plan.curves.size(); ++i)
      QVERIFY(acquisition::armTravel(found.plan.plan.samples[i].directions, plan.plan.samples[i].directions) < 4e-8);
    const auto expected = acquisition::factorMeasurement(plan, values);
    const auto again = acquisition::factorMeasurement(found.plan, found.values);
    QVERIFY(again.along == expected.along && again.across == expected.across);
  }

  /// Without values: a list of directions, which a plan is.
  void directionsToMeasure() {
    const acquisition::FactorPlan plan = acquisition::planFactors();
    const std::string text = factorReadingsCsv(plan);
    QVERIFY(text.starts_with("# method: factors, projected-deviation\nindex,curve,theta_i"));
    QVERIFY(text.find(",r,g,b") == std::string::npos);
    QVERIFY(test::contains(readingsError(text), "column"));
  }

  void smallFile() {
    const FactorReadings readings = parseFactorReadings(good, FactorAxes::symmetricDeviation);
    const auto m = acquisition::factorMeasurement(readings.plan, readings.values);
    QCOMPARE(m.angles.size(), std::size_t(2));
    QVERIFY(std::abs(m.along[0][1] - std::log(2.0)) < 1e-12);
    QVERIFY(std::abs(m.distances[1] - (std::sin(radians(60)) - std::sin(radians(20)))) < 1e-9);
    QVERIFY(readingsError(good).empty());
  }

  void badFilesAreRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("error");
    const auto row = [](const char* name, const std::string& text, const char* error) {
      QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(error);
    };
    row("curve", with("4,across", "4,sideways"),
        "line 5: found 'sideways' in the column curve, expected along, across or further");
    row("no curves", with("index,curve", "index,kind"), "curve");
    row("angle", with("20,180,60", "95,180,60"), "line 5: found 95 for theta_i");
    row("value", with("1,0.9,0.8\n3", "-1,0.9,0.8\n3"), "line 3: found -1 for r");
    row("not a number", with("0.5,0.4", "x,0.4"), "line 2");
    row("index twice", with("2,along", "1,along"), "line 3: found the index 1 a second time");
    row("off the mirror", with("1,along,30,180", "1,along,40,180"),
        "sample 1: found the distance 0.1428 from the mirror");
    row("another angle", with("4,across,20,180,60", "4,across,20,180,50"),
        "sample 4: found the angle 50 degrees on the curve \"across\", expected 60");
    row("same place", with("1,along,30,180,30", "1,along,60,180,60"),
        "sample 2: found the same position on the curve as sample 1");
    row("no curve along", with("1,along", "1,across"), "sample");
    row("empty", "", "");
  }
  void badFilesAreRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, error);
    const std::string found = readingsError(text.toStdString());
    QVERIFY2(!found.empty() && test::contains(found, error.constData()), found.c_str());
  }

  void errorsNameTheFile() {
    const std::string bad = with("4,across", "4,up");
    const auto path = test::writeFile("factors/bad.csv", std::as_bytes(std::span(bad)));
    QVERIFY(test::contains(test::errorOf([&] { readFactorReadings(path, FactorAxes::projectedDeviation); }),
                           path.string() + ": line 5"));
  }
};

GONIO_TEST(FactorReadingsFileTest)
}  // namespace factor_readings_file_test

#include "factor_readings_file_test.moc"
