// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_prediction.h"

#include <QTest>
#include <cmath>

#include "core/support/error.h"
#include "tests/core/acquisition/factor_oracles.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace factor_prediction_test {
using namespace gonio;
using namespace gonio::acquisition;
using test::factorPair;
using test::factorPlaceOf;
using test::productOfCurves;

/// A matte body and a mirror reflection that increases steeply toward the horizon: reciprocal, not a product.
test::FunctionBrdf varnish() {
  return test::FunctionBrdf([](const Direction& wi, const Direction& wo) {
    const double deviation = toProjectedDeviation(wi, wo).deviation, d = toHalfDifference(wi, wo).thetaD;
    return Rgb(0.2) + Rgb(20 * std::pow(1 - std::cos(d), 5) * std::exp(-100 * deviation * deviation));
  });
}

class FactorPredictionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Exact where the material is a product, except for the interpolation between the readings.
  void hardCase20ProductsArePredicted_data() {
    QTest::addColumn<int>("axes");
    QTest::addColumn<int>("bound");
    for (int axes = 0; axes < test::productAxes; ++axes)
      for (const FactorBound bound : {FactorBound::none, FactorBound::readings})
        // Such a product over theta_R or theta_o is not reciprocal, which the bound requires.
        if (bound == FactorBound::none || areReciprocal(FactorAxes(axes)))
          QTest::addRow("%s, %s", factorAxesNames[std::size_t(axes)].data(),
                        factorBoundNames[std::size_t(bound)].data())
              << axes << int(bound);
  }
  void hardCase20ProductsArePredicted() {
    QFETCH(int, axes);
    QFETCH(int, bound);
    const auto which = FactorAxes(axes);
    const test::FunctionBrdf material = productOfCurves(which);
    const FactorMeasurement m = measureFactors(material, {.axes = which, .fixedAngle = 0.6});
    const auto predicted = predictFromFactors(m, FactorBound(bound));
    std::mt19937_64 random(1);
    int compared = 0;
    for (int n = 0; n < 2000; ++n) {
      const auto [wi, wo] = factorPair(random);
      const glm::dvec2 at = factorPlaceOf(which, wi, wo);
      // Beyond the readings the prediction is constant.
      if (at.x < m.angles.front() || at.y > m.distances.back()) continue;
      // Beside retro-reflection theta_d lies before the first reading in the mirror direction.
      if (which == FactorAxes::symmetricDeviation && std::abs(at.y - 2 * std::sin(0.6)) < 0.1) continue;
      ++compared;
      const Rgb found = predicted->evaluate(wi, wo), expected = material.evaluate(wi, wo);
      for (int channel = 0; channel < 3; ++channel)
        QVERIFY2(std::abs(found[channel] - expected[channel]) <= 2e-3 * expected[channel],
                 qPrintable(QString("%1 %2").arg(found[channel]).arg(expected[channel])));
    }
    QVERIFY(compared > 200);
    QVERIFY(supportOf(m).contradicted == 0 || !areReciprocal(which));
  }

  /// At every reading of the curves the unbounded prediction is the reading.
  void readingsAreReproduced() {
    const auto material = varnish();
    for (const FactorAxes axes : {FactorAxes::projectedDeviation, FactorAxes::halfDifference, FactorAxes::halfOut}) {
      const FactorPlan plan = planFactors({.axes = axes});
      const MeasuredValues values = measure(material, plan.plan);
      const auto predicted = predictFromFactors(factorMeasurement(plan, values), FactorBound::none);
      for (std::size_t i = 0; i < plan.curves.size(); ++i) {
        const auto& [wi, wo] = plan.plan.samples[i].directions;
        QVERIFY(std::abs(predicted->evaluate(wi, wo).x / values.rgb[i].x - 1) < 1e-6);
      }
    }
  }

  /// Never above the interpolated readings, never above the unbounded prediction, and reciprocal.
  void boundedPredictionsNeverExceed() {
    const auto material = varnish();
    for (const auto axes : {FactorAxes::projectedDeviation, FactorAxes::symmetricDeviation, FactorAxes::halfDifference,
                            FactorAxes::halfOut}) {
      const FactorMeasurement m = measureFactors(material, {.axes = axes, .fixedAngle = 0.3});
      const auto bounded = predictFromFactors(m), printed = predictFromFactors(m, FactorBound::none);
      QVERIFY(bounded->isReciprocal());
      std::mt19937_64 random(2);
      for (int n = 0; n < 2000; ++n) {
        const auto [wi, wo] = factorPair(random);
        const double value = bounded->evaluate(wi, wo).x;
        QVERIFY(value <= std::expm1(m.highest[0]) * (1 + 1e-12));
        QVERIFY(value <= printed->evaluate(wi, wo).x * (1 + 1e-12));
        QVERIFY(value <= printed->evaluate(wo, wi).x * (1 + 1e-9));
        QVERIFY(std::abs(bounded->evaluate(wo, wi).x - value) <= 1e-9 * value);
      }
    }
  }

  /// The printed product multiplies the matte body by the increase of the mirror reflection; the bound does not.
  void matteBodyDoesNotFollowTheMirrorReflection() {
    const auto material = varnish();
    const FactorMeasurement m = measureFactors(material, {.fixedAngle = radians(30)});
    const Direction viewer = fromSpherical(radians(85), 0), light = fromSpherical(radians(20), radians(90));
    const double truth = material.evaluate(light, viewer).x;
    QVERIFY(predictFromFactors(m, FactorBound::none)->evaluate(light, viewer).x > 5 * truth);
    QVERIFY(predictFromFactors(m)->evaluate(light, viewer).x < 1.5 * truth);
    const FactorSupport support = supportOf(m);
    for (const int step : {0, -5, 7, 180}) QVERIFY_EXCEPTION_THROWN(supportOf(m, step), Error);
    QVERIFY(support.contradicted > 0.1);
    QVERIFY(!support.warnings.empty() && test::contains(support.warnings[0], "exchanging light and viewer"));
    QCOMPARE(supportOf(measureFactors(material, {.axes = FactorAxes::halfDifference})).contradicted, 0.0);
  }

  /// Where the curve along is nearly black, the symmetric axes divide the curve across by it: the quotient exceeds all
  /// readings, and the product with the bright end of the curve along overflows. The bound is the nearest readings.
  void divisionByADarkReadingIsBounded() {
    const test::FunctionBrdf material([](const Direction& wi, const Direction& wo) {
      const double d = toHalfDifference(wi, wo).thetaD, deviation = toProjectedDeviation(wi, wo).deviation;
      return Rgb(deviation < 0.05 && d < 0.6 ? 1e-5 : d < 0.6 ? 0.1 : 5);
    });
    const FactorMeasurement m = measureFactors(material, {.axes = FactorAxes::symmetricDeviation, .fixedAngle = 1});
    const auto bounded = predictFromFactors(m);
    double printed = 0;
    std::mt19937_64 random(4);
    for (int n = 0; n < 2000; ++n) {
      const auto [wi, wo] = factorPair(random);
      printed = std::max(printed, predictFromFactors(m, FactorBound::none)->evaluate(wi, wo).x);
      QVERIFY(bounded->evaluate(wi, wo).x <= 5 * (1 + 1e-9));
    }
    QVERIFY(printed > 1e6);
    const FactorSupport support = supportOf(m);
    QVERIFY(support.bounded > 0.01);
    QVERIFY(std::ranges::any_of(support.warnings,
                                [](const auto& text) { return test::contains(text, "more than twice as large"); }));
  }

  void warningsStateTheCause() {
    const auto hasWarning = [](const FactorMeasurement& m, const char* text) {
      return std::ranges::any_of(supportOf(m).warnings,
                                 [&](const auto& warning) { return test::contains(warning, text); });
    };
    const test::FunctionBrdf spike([](const Direction& wi, const Direction& wo) {
      return Rgb(0.1 + 100 * std::exp(-1e6 * std::pow(toProjectedDeviation(wi, wo).deviation, 2)));
    });
    QVERIFY(hasWarning(measureFactors(spike, {.distances = 10}), "narrower than the spacing"));
    QVERIFY(!hasWarning(measureFactors(spike, {.distances = 2000}), "narrower than the spacing"));
    const test::FunctionBrdf hole([](const Direction& wi, const Direction& wo) {
      return Rgb(0.5, toProjectedDeviation(wi, wo).deviation < 0.05 ? 0 : 0.5, 0);
    });
    QVERIFY(hasWarning(measureFactors(hole), "in green: the mirror direction is black"));
    QVERIFY(!hasWarning(measureFactors(hole), "in blue"));
    QVERIFY(hasWarning(measureFactors(varnish(), {.fixedAngle = 0}), "outside the two curves"));
    QVERIFY(supportOf(measureFactors(test::lambert(Rgb(0.5)), {.fixedAngle = radians(60)})).warnings.empty());
  }

  /// The curves as PDV factors are the unbounded prediction, up to single precision, also where the curve across
  /// increases.
  void curvesAsFactors() {
    const test::FunctionBrdf increasing([](const Direction& wi, const Direction& wo) {
      const ProjectedDeviation at = toProjectedDeviation(wi, wo);
      return Rgb(std::expm1(0.1 * (1 + at.thetaR) * (1 + at.deviation)));
    });
    for (const test::FunctionBrdf& material : {productOfCurves(FactorAxes::projectedDeviation), increasing}) {
      const FactorMeasurement m = measureFactors(material, {.fixedAngle = 0.6});
      const factorization::PdvFactors curves = pdvFactorsOfCurves(m);
      for (const auto& channel : curves.channels)
        QVERIFY(channel[0].f2.empty() || std::ranges::max(channel[0].f2) <= 1 + 1e-12);
      const auto factors = factorization::makePdvBrdf(curves), predicted = predictFromFactors(m, FactorBound::none);
      std::mt19937_64 random(3);
      for (int n = 0; n < 500; ++n) {
        const auto [wi, wo] = factorPair(random);
        // Below the second reading, the node at 0 that factors need changes the slope.
        if (polarAngle(wo) < m.angles[1]) continue;
        const Rgb found = factors->evaluate(wi, wo), expected = predicted->evaluate(wi, wo);
        const Rgb limit = Rgb(std::expm1(curves.highest) * (1 + 1e-5));
        QVERIFY(glm::length(found - glm::min(expected, limit)) < 1e-4 * (1 + glm::length(expected)));
      }
    }
    QVERIFY_EXCEPTION_THROWN(pdvFactorsOfCurves(measureFactors(varnish(), {.axes = FactorAxes::halfDifference})),
                             Error);
  }
};

GONIO_TEST(FactorPredictionTest)
}  // namespace factor_prediction_test

#include "factor_prediction_test.moc"
