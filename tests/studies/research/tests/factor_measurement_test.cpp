// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/research/acquisition/factor_measurement.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace factor_measurement_test {
using namespace gonio;
using namespace gonio::acquisition;

/// (angle, distance) of a pair, once more.
glm::dvec2 placeOf(FactorAxes axes, const Direction& wi, const Direction& wo) {
  const ProjectedDeviation projected = toProjectedDeviation(wi, wo);
  const HalfOut half = toHalfOut(wi, wo);
  if (axes == FactorAxes::projectedDeviation) return {projected.thetaR, projected.deviation};
  if (axes == FactorAxes::symmetricDeviation) return {toHalfDifference(wi, wo).thetaD, projected.deviation};
  return {axes == FactorAxes::halfOut ? half.thetaO : toHalfDifference(wi, wo).thetaD, half.thetaH};
}

/// z = (1 + angle) / (1 + 2 distance): a product of two curves.
gonio::test::FunctionBrdf separable(FactorAxes axes) {
  return gonio::test::FunctionBrdf([axes](const Direction& wi, const Direction& wo) {
    const glm::dvec2 at = placeOf(axes, wi, wo);
    return Rgb(std::expm1((1 + at.x) / (1 + 2 * at.y)), std::expm1(0.3 / (1 + at.y)), 0);
  });
}

class FactorMeasurementTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Exact where the material is a product, but for the interpolation; a black channel is flagged.
  void hardCase20ProductsArePredicted_data() {
    QTest::addColumn<int>("axes");
    QTest::newRow("projected deviation") << int(FactorAxes::projectedDeviation);
    QTest::newRow("half difference") << int(FactorAxes::halfDifference);
    QTest::newRow("half out") << int(FactorAxes::halfOut);
    QTest::newRow("symmetric deviation") << int(FactorAxes::symmetricDeviation);
  }
  void hardCase20ProductsArePredicted() {
    QFETCH(int, axes);
    const FactorAxes which = static_cast<FactorAxes>(axes);
    const gonio::test::FunctionBrdf material = separable(which);
    const FactorMeasurement m = measureFactors(material, {.axes = which, .fixedAngle = 0.6});
    QVERIFY(m.unscaled == (std::array<bool, 3>{false, false, true}));
    QVERIFY(m.unreadable > 0 && m.unreadable < 90);
    const auto predicted = predictFromFactors(m);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    int compared = 0;
    for (int n = 0; n < 2000; ++n) {
      const Direction wi = fromSpherical(1.5 * uniform(random), 6 * uniform(random));
      const Direction wo = fromSpherical(1.5 * uniform(random), 6 * uniform(random));
      const glm::dvec2 at = placeOf(which, wi, wo);
      // Beyond the readings the prediction is held.
      if (at.x < m.angles.front() || at.y > m.distances.back()) continue;
      // Beside retro-reflection theta_d lies before the first reading along the mirror direction.
      if (which == FactorAxes::symmetricDeviation && std::abs(at.y - 2 * std::sin(0.6)) < 0.1) continue;
      ++compared;
      const Rgb found = predicted->evaluate(wi, wo), expected = material.evaluate(wi, wo);
      for (int channel = 0; channel < 3; ++channel)
        QVERIFY2(std::abs(found[channel] - expected[channel]) <= 2e-3 * expected[channel],
                 qPrintable(QString("%1 %2").arg(found[channel]).arg(expected[channel])));
    }
    QVERIFY(compared > 200);
  }

  /// A mirror direction that is black at the fixed angle cannot scale: the curve is taken as it is.
  void hardCase20NothingToScaleBy() {
    const gonio::test::FunctionBrdf material([](const Direction& wi, const Direction& wo) {
      return Rgb(toProjectedDeviation(wi, wo).deviation < 0.05 ? 1e-13 : 0.5);
    });
    const FactorMeasurement m = measureFactors(material);
    QVERIFY(m.unscaled[0] && m.unscaled[1] && m.unscaled[2]);
    const auto at = fromProjectedDeviation({0.4, 0.5, 0});
    QVERIFY(std::abs(predictFromFactors(m)->evaluate(at.pair.wi, at.pair.wo).x - 0.5) < 1e-9);
  }

  /// Light and viewer may change places in theta_d and |Dp|.
  void symmetricDeviationIsReciprocal() {
    const auto predicted = predictFromFactors(
        measureFactors(separable(FactorAxes::projectedDeviation), {.axes = FactorAxes::symmetricDeviation}));
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 1000; ++n) {
      const Direction wi = fromSpherical(1.5 * uniform(random), 6 * uniform(random));
      const Direction wo = fromSpherical(1.5 * uniform(random), 6 * uniform(random));
      const Rgb there = predicted->evaluate(wi, wo), back = predicted->evaluate(wo, wi);
      QVERIFY(glm::length(there - back) < 1e-10 * (1 + glm::length(there)));
    }
  }

  /// A curve along the mirror direction that is black but at the fixed angle: no division by 0.
  void hardCase20BlackBesideTheFixedAngle() {
    const gonio::test::FunctionBrdf material([](const Direction& wi, const Direction& wo) {
      const ProjectedDeviation at = toProjectedDeviation(wi, wo);
      return Rgb(at.deviation > 1e-6 || std::abs(at.thetaR - 1) < 0.05 ? 0.5 : 0);
    });
    const FactorMeasurement m = measureFactors(material, {.axes = FactorAxes::symmetricDeviation});
    for (const double z : m.across[0]) QVERIFY(std::isfinite(z) && z >= 0);
    const Rgb value = predictFromFactors(m)->evaluate(fromSpherical(0.3, 0), fromSpherical(0.9, 2));
    QVERIFY(std::isfinite(value.x) && value.x >= 0 && value.x <= std::expm1(m.highest));
  }

  /// One arm stands before the other: no reading along the normal, nor at retro-reflection.
  void blockedReadingsAreLeftOut() {
    const FactorMeasurement m = measureFactors(separable(FactorAxes::projectedDeviation), {.fixedAngle = 0.5});
    QVERIFY(m.angles.front() > 0 && m.angles.front() < 0.05);
    for (const double distance : m.distances) QVERIFY(std::abs(distance - 2 * std::sin(0.5)) > 0.5 * 0.035);
    const FactorMeasurementOptions blocked{.fixedAngle = 0, .blockedAngle = 4};
    QVERIFY_EXCEPTION_THROWN(measureFactors(separable(FactorAxes::projectedDeviation), blocked), Error);
  }

  void noiseIsSeededAndOfItsSize() {
    const gonio::test::FunctionBrdf constant = gonio::test::lambert(Rgb(pi));
    const FactorMeasurementOptions options{.angles = 2000, .noise = 0.05, .seed = 3};
    const FactorMeasurement m = measureFactors(constant, options);
    QVERIFY(m.along == measureFactors(constant, options).along);
    double sum = 0;
    for (const double z : m.along[0]) sum += (std::expm1(z) - 1) * (std::expm1(z) - 1);
    const double deviation = std::sqrt(sum / double(m.along[0].size()));
    QVERIFY2(std::abs(deviation / 0.05 - 1) < 0.08, QByteArray::number(deviation));
  }

  void wrongOptionsAreErrors() {
    const auto material = separable(FactorAxes::halfOut);
    for (const FactorMeasurementOptions& wrong :
         {FactorMeasurementOptions{.fixedAngle = 1.6}, FactorMeasurementOptions{.angles = 1},
          FactorMeasurementOptions{.noise = -1}, FactorMeasurementOptions{.noise = std::nan("")}})
      QVERIFY_EXCEPTION_THROWN(measureFactors(material, wrong), Error);
  }
};

GONIO_TEST(FactorMeasurementTest)
}  // namespace factor_measurement_test

#include "factor_measurement_test.moc"
