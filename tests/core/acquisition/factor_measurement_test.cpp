// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_prediction.h"

#include <QTest>
#include <cmath>

#include "core/support/error.h"
#include "tests/core/acquisition/factor_oracles.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace factor_measurement_test {
using namespace gonio;
using namespace gonio::acquisition;
using test::productOfCurves;

class FactorMeasurementTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The curves of z = (1 + angle) / (1 + 2 distance), by the closed form.
  void curvesOfAProduct_data() {
    QTest::addColumn<int>("axes");
    for (int axes = 0; axes < test::productAxes; ++axes)
      QTest::newRow(factorAxesNames[std::size_t(axes)].data()) << axes;
  }
  void curvesOfAProduct() {
    QFETCH(int, axes);
    const auto which = FactorAxes(axes);
    const FactorMeasurement m = measureFactors(productOfCurves(which), {.axes = which, .fixedAngle = 0.6});
    QVERIFY(m.unscaled == (std::array<bool, 3>{false, false, true}));
    QVERIFY(std::abs(m.fixedAngle - 0.6) < 1e-12);
    for (std::size_t i = 0; i < m.angles.size(); ++i) QVERIFY(std::abs(m.along[0][i] - (1 + m.angles[i])) < 1e-9);
    for (std::size_t j = 0; j < m.distances.size(); ++j) {
      // The `along` curve, by which symmetricDeviation divides, is interpolated.
      const double tolerance = which == FactorAxes::symmetricDeviation ? 2e-3 : 1e-9;
      // Beside retro-reflection theta_d lies before the first reading in the mirror direction.
      if (which == FactorAxes::symmetricDeviation && std::abs(m.distances[j] - 2 * std::sin(0.6)) < 0.1) continue;
      QVERIFY(std::abs(m.across[0][j] * (1 + 2 * m.distances[j]) - 1) < tolerance);
    }
    QVERIFY(std::abs(m.highest[0] - (1 + m.angles.back())) < 1e-9);
    QVERIFY(std::abs(m.highest[1] - 0.3) < 1e-9 && m.highest[2] == 0);
  }

  /// A channel whose mirror direction is black at the fixed angle cannot be scaled: the `across` curve is kept.
  void hardCase20NothingToScaleBy() {
    const test::FunctionBrdf material([](const Direction& wi, const Direction& wo) {
      return Rgb(toProjectedDeviation(wi, wo).deviation < 0.05 ? 1e-13 : 0.5);
    });
    const FactorMeasurement m = measureFactors(material);
    QVERIFY(m.unscaled == (std::array<bool, 3>{true, true, true}));
    QVERIFY(std::abs(m.across[0].back() - std::log1p(0.5)) < 1e-12);
  }

  /// A curve in the mirror direction that is black except at the fixed angle: no division by 0.
  void hardCase20BlackBesideTheFixedAngle() {
    const test::FunctionBrdf material([](const Direction& wi, const Direction& wo) {
      const ProjectedDeviation at = toProjectedDeviation(wi, wo);
      return Rgb(at.deviation > 1e-6 || std::abs(at.thetaR - 1) < 0.05 ? 0.5 : 0);
    });
    const FactorMeasurement m = measureFactors(material, {.axes = FactorAxes::symmetricDeviation, .fixedAngle = 1});
    for (const double z : m.across[0]) QVERIFY(std::isfinite(z) && z >= 0);
  }

  void noiseIsThatOfTheGoniometer() {
    const test::FunctionBrdf constant = test::lambert(Rgb(pi));
    const MeasurementNoise noise{.relative = 0.05, .seed = 3};
    const FactorMeasurement m = measureFactors(constant, {.angles = 2000}, noise);
    QVERIFY(m.along == measureFactors(constant, {.angles = 2000}, noise).along);
    double sum = 0;
    for (const double z : m.along[0]) sum += (std::expm1(z) - 1) * (std::expm1(z) - 1);
    const double deviation = std::sqrt(sum / double(m.along[0].size()));
    QVERIFY2(std::abs(deviation / 0.05 - 1) < 0.08, QByteArray::number(deviation));
  }

  /// Readings in any order give the same curves; without the reading in the mirror direction at the fixed angle, the
  /// curve along gives the scale.
  void orderAndScale() {
    const auto material = productOfCurves(FactorAxes::projectedDeviation);
    FactorPlan plan = planFactors();
    const FactorMeasurement sorted = factorMeasurement(plan, measure(material, plan.plan));
    std::ranges::reverse(plan.plan.samples);
    std::ranges::reverse(plan.curves);
    const FactorMeasurement reversed = factorMeasurement(plan, measure(material, plan.plan));
    QVERIFY(reversed.along == sorted.along && reversed.across == sorted.across);
    const auto first = std::ranges::find(plan.curves, FactorCurve::across, [](FactorCurve c) { return c; });
    QVERIFY(first != plan.curves.end());
    plan.plan.samples.erase(plan.plan.samples.begin() + (std::ranges::count(plan.curves, FactorCurve::across) - 1));
    plan.curves.erase(first);
    const FactorMeasurement without = factorMeasurement(plan, measure(material, plan.plan));
    QCOMPARE(without.distances.size(), sorted.distances.size() - 1);
    QVERIFY(std::abs(without.across[0].back() / sorted.across[0].back() - 1) < 1e-3);
  }

  void readingsThatAreNoCurvesAreErrors() {
    const auto material = productOfCurves(FactorAxes::projectedDeviation);
    const FactorPlan good = planFactors();
    const auto errorOf = [&](const FactorPlan& plan) {
      return test::errorOf([&] { factorMeasurement(plan, measure(material, plan.plan)); });
    };
    FactorPlan plan = good;
    plan.curves.back() = FactorCurve::along;
    QVERIFY(test::contains(errorOf(plan), R"(from the mirror direction on the curve "along", expected 0)"));
    plan = good;
    plan.axes = FactorAxes::halfDifference;
    QVERIFY(test::contains(errorOf(plan), R"(degrees on the curve "across", expected 60)"));
    plan = good;
    plan.plan.samples[4].directions = plan.plan.samples[3].directions;
    QVERIFY(test::contains(errorOf(plan), "sample 5: found the same position on the curve as sample 4"));
    plan = good;
    std::ranges::fill(plan.curves, FactorCurve::along);
    QVERIFY(test::contains(errorOf(plan), R"(found no reading of the curve "across")"));
    QVERIFY(test::contains(test::errorOf([&] { factorMeasurement(good, {}); }), "found 0 values"));
  }
};

GONIO_TEST(FactorMeasurementTest)
}  // namespace factor_measurement_test

#include "factor_measurement_test.moc"
