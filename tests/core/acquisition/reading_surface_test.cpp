// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reading_surface.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/acquisition/factor_prediction.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/core/acquisition/factor_oracles.h"
#include "tests/support/test_program.h"

namespace reading_surface_test {
using namespace gonio;
using namespace gonio::acquisition;
using test::FunctionBrdf;

/// A body and a highlight whose width in `distance` is the same at all angles: p = 0 for theta_h, 1 for |Dp|.
FunctionBrdf ofTheForm(double power) {
  return FunctionBrdf([power](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    const double distance = std::sin(at.thetaH) * std::pow(std::cos(at.thetaD), power);
    const double fresnel = 0.05 + 0.95 * std::pow(1 - std::cos(at.thetaD), 5);
    return Rgb(0.2, 0.1, 0.01) + Rgb(20 * fresnel * std::exp(-60 * distance * distance));
  });
}

/// The highlight of a GGX lobe with roughness 0.2 and its masking, over a matte body: not of the form of the fit.
FunctionBrdf paint() {
  return FunctionBrdf([](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    constexpr double a2 = 0.04;
    const double c = std::cos(at.thetaH), d = a2 / (pi * std::pow(c * c * (a2 - 1) + 1, 2));
    const auto masked = [](double z) { return 1 / (z + std::sqrt(a2 + (1 - a2) * z * z)); };
    const double fresnel = 0.04 + 0.96 * std::pow(1 - std::cos(at.thetaD), 5);
    return Rgb(0.3, 0.1, 0.05) / pi + Rgb(d * fresnel * masked(wi.z) * masked(wo.z));
  });
}

FactorReadings readingsOf(const Brdf& material, const FactorPlanOptions& options = {.axes = FactorAxes::adaptive}) {
  FactorReadings readings{.plan = planFactors(options), .values = {}};
  readings.values = measure(material, readings.plan.plan);
  return readings;
}

/// Root mean squared logarithm of the ratio, over random pairs up to 75 degrees.
double logError(const Brdf& found, const Brdf& material) {
  std::mt19937_64 random(3);
  double sum = 0;
  int count = 0;
  while (count < 3000) {
    const auto [wi, wo] = test::factorPair(random);
    if (std::min(wi.z, wo.z) < std::cos(radians(75))) continue;
    sum += std::pow(std::log(found.evaluate(wi, wo).y / material.evaluate(wi, wo).y), 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

class ReadingSurfaceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A highlight whose distance the readings must find: theta_h, |Dp|, or the one between.
  void materialsOfItsForm() {
    for (const double power : {0.0, 0.5, 1.0}) {
      const FunctionBrdf material = ofTheForm(power);
      const double error = logError(*fitReadings(readingsOf(material), true), material);
      QVERIFY2(error < 0.06, qPrintable(QString("p %1: %2").arg(power).arg(error)));
    }
  }

  /// From as many readings, the error is at most half that of any product of two curves.
  void moreAccurateThanProducts() {
    const FunctionBrdf material = paint();
    const double fitted = logError(*fitReadings(readingsOf(material), true), material);
    for (int axes = 0; axes < test::productAxes; ++axes) {
      const double product =
          logError(*predictFromFactors(measureFactors(material, {.axes = FactorAxes(axes)})), material);
      QVERIFY2(fitted < product / 2, qPrintable(QString("%1: %2, %3").arg(axes).arg(fitted).arg(product)));
    }
  }

  void reciprocalAndBounded() {
    const FactorReadings readings = readingsOf(paint());
    const auto bounded = fitReadings(readings, true), free = fitReadings(readings, false);
    QVERIFY(bounded->isReciprocal());
    double highest = 0;
    for (const Rgb& rgb : readings.values.rgb) highest = std::max(highest, rgb.x);
    std::mt19937_64 random(4);
    for (int n = 0; n < 1000; ++n) {
      const auto [wi, wo] = test::factorPair(random);
      const double value = bounded->evaluate(wi, wo).x;
      QVERIFY(value > 0 && value <= highest);
      QVERIFY(value == std::min(highest, free->evaluate(wi, wo).x));
      QVERIFY(std::abs(bounded->evaluate(wo, wi).x - value) <= 1e-9 * value);
    }
    QCOMPARE(bounded->evaluate({1, 0, -0.01}, {0, 0, 1}), Rgb(0));
  }

  /// hard case 20: black channels, and a material that is constant, are predicted as such.
  void blackAndConstant() {
    const auto black = fitReadings(readingsOf(FunctionBrdf([](auto&, auto&) { return Rgb(0, 0.2, 0); })), false);
    std::mt19937_64 random(5);
    for (int n = 0; n < 300; ++n) {
      const auto [wi, wo] = test::factorPair(random);
      const Rgb value = black->evaluate(wi, wo);
      QVERIFY(value.x == 0 && value.z == 0 && std::abs(value.y / 0.2 - 1) < 1e-2);
    }
  }

  /// A gross error whose noise is known has no influence; if its noise is not known it has.
  void knownNoiseCounts() {
    const FunctionBrdf material = ofTheForm(1);
    FactorReadings readings = readingsOf(material);
    const auto wrong =
        std::size_t(std::ranges::find(readings.plan.curves, FactorCurve::further) - readings.plan.curves.begin() + 3);
    const DirectionPair at = readings.plan.plan.samples[wrong].directions;
    const double truth = readings.values.rgb[wrong].y;
    readings.values.rgb[wrong] *= 20;
    const double misled = fitReadings(readings, false)->evaluate(at.wi, at.wo).y;
    readings.values.noise.assign(readings.values.rgb.size(), Rgb(1e-6));
    readings.values.noise[wrong] = Rgb(100);
    const double found = fitReadings(readings, false)->evaluate(at.wi, at.wo).y;
    QVERIFY(std::abs(found / truth - 1) < 0.15 && std::abs(misled / truth - 1) > 0.3);
  }

  void anyNumberOfThreads() {
    const FactorReadings readings = readingsOf(paint());
    const auto several = fitReadings(readings, true);
    const ThreadLimit one(1);
    const auto single = fitReadings(readings, true);
    std::mt19937_64 random(6);
    for (int n = 0; n < 200; ++n) {
      const auto [wi, wo] = test::factorPair(random);
      QCOMPARE(single->evaluate(wi, wo), several->evaluate(wi, wo));
    }
  }

  /// Readings of two curves alone are fitted too; the user is told what is not known. Those of the other axes can be
  /// used, and further readings do not disturb a product.
  void readingsServeOtherAxes() {
    const FunctionBrdf material = paint();
    FactorReadings two = readingsOf(material, {.axes = FactorAxes::projectedDeviation});
    two.plan.axes = FactorAxes::adaptive;
    const FactorMeasurement m = factorMeasurement(two.plan, two.values);
    QVERIFY(predictFromFactors(m)->evaluate({0, 0, 1}, {0, 0, 1}).y > 0);
    QVERIFY(test::contains(supportOf(m).warnings.back(), "two curves only"));
    FactorReadings all = readingsOf(material);
    QVERIFY(supportOf(factorMeasurement(all.plan, all.values)).warnings.empty());
    all.plan.axes = FactorAxes::symmetricDeviation;
    const FactorMeasurement product = factorMeasurement(all.plan, all.values);
    QVERIFY(product.angles.size() + product.distances.size() < all.plan.curves.size() / 2);
    QVERIFY(predictFromFactors(product)->evaluate({0, 0, 1}, {0, 0, 1}).y > 0);
  }

  void numbersThatDifferAreErrors() {
    FactorReadings readings = readingsOf(paint());
    readings.values.rgb.pop_back();
    QVERIFY_EXCEPTION_THROWN(fitReadings(readings, true), Error);
    QVERIFY_EXCEPTION_THROWN(fitReadings({}, true), Error);
  }
};

GONIO_TEST(ReadingSurfaceTest)
}  // namespace reading_surface_test

#include "reading_surface_test.moc"
