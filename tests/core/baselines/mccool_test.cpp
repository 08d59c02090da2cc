// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/mccool.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/core/factorization/half_difference_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace mccool_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;
using factorization::test_support::halfDifferenceSamples;
using factorization::test_support::worstAtNodes;

const HalfDifferenceAxes axes = makeHalfDifferenceAxes(20, 18, 5);

/// Lines in the logarithm between all nodes.
Rgb product(const HalfDifference& at, const DirectionPair& pair) {
  const double angles = polarAngle(pair.wi) + polarAngle(pair.wo);
  return {std::exp(2 - 0.5 * angles - 3 * at.thetaH), std::exp(1 + 0.3 * angles - at.thetaH), std::exp(-angles)};
}

class McCoolTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Data that are one product less the bias: the bias is a hundredth of the mean, so that of the product is known.
  void exactForOneProduct() {
    HalfDifferenceSamples s = halfDifferenceSamples(axes, product);
    Rgb sum(0);
    double weights = 0;
    factorization::test_support::visitNodes(
        axes, [&](std::size_t h, std::size_t d, std::size_t p, std::size_t i, const DirectionPair&) {
          sum += projectedMeasure(s, h, d, p) * s.values[i];
          weights += projectedMeasure(s, h, d, p);
        });
    const Rgb bias = 1e-2 / 1.01 * sum / weights;
    for (std::size_t i = 0; i < s.values.size(); ++i)
      if (s.valid[i]) s.values[i] -= bias;
    const McCoolFactors f = factorizeMcCool(s);
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(f.channels[std::size_t(c)].bias / bias[c] - 1) < 1e-9);
    const double worst = worstAtNodes(s, *makeMcCoolBrdf(f));
    QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst)));
  }

  /// A sum of two products is none: reciprocal, never negative, never above the data.
  void boundedAndReciprocal() {
    const HalfDifferenceSamples s = halfDifferenceSamples(
        axes, [](const auto& at, const auto&) { return Rgb(0.1 + 1000 * std::exp(-200 * at.thetaH * at.thetaH)); });
    const McCoolFactors f = factorizeMcCool(s);
    const auto brdf = makeMcCoolBrdf(f);
    std::mt19937_64 generator(3);
    for (int i = 0; i < 2000; ++i) {
      const Direction wi = test::randomUpper(generator), wo = test::randomUpper(generator);
      const double a = brdf->evaluate(wi, wo).y, b = brdf->evaluate(wo, wi).y;
      QVERIFY(std::isfinite(a) && a >= 0 && a < 1000.2);
      QVERIFY(std::abs(a - b) < 1e-9 * (1 + a));
    }
    QCOMPARE(f.bytes(), std::size_t(4 * 3 * (90 + 20 + 2)));
  }

  /// One black channel beside others, and all black.
  void hardCase12BlackChannel() {
    const HalfDifferenceSamples s =
        halfDifferenceSamples(axes, [](const auto& at, const auto& pair) { return product(at, pair) * Rgb(1, 0, 1); });
    const auto brdf = makeMcCoolBrdf(factorizeMcCool(s));
    const Rgb value = brdf->evaluate({0.6, 0, 0.8}, {0, 0.6, 0.8});
    QVERIFY(value.x > 0.1 && value.z > 0.01);
    QCOMPARE(value.y, 0.0);
    const HalfDifferenceSamples black = halfDifferenceSamples(axes, [](const auto&, const auto&) { return Rgb(0); });
    QCOMPARE(worstAtNodes(black, *makeMcCoolBrdf(factorizeMcCool(black))), 0.0);
  }

  void hardCase14Constant() {
    const HalfDifferenceSamples s =
        halfDifferenceSamples(axes, [](const auto&, const auto&) { return Rgb(0.3, 0.2, 0.1); });
    const auto brdf = makeMcCoolBrdf(factorizeMcCool(s));
    QVERIFY(worstAtNodes(s, *brdf) < 1e-6);
    QVERIFY(std::abs(brdf->evaluate({0.6, 0, 0.8}, {0, 0.28, 0.96}).x - 0.3) < 1e-6);
  }

  /// The bias of a spike in a black material is finite, and so is all else; the rest stays near black.
  void hardCase15Spike() {
    HalfDifferenceSamples s = halfDifferenceSamples(axes, [](const auto&, const auto&) { return Rgb(0); });
    s.values[axes.index(0, 3, 2)] = Rgb(1e6);
    const auto brdf = makeMcCoolBrdf(factorizeMcCool(s));
    std::mt19937_64 generator(4);
    for (int i = 0; i < 2000; ++i) {
      const Rgb value = brdf->evaluate(test::randomUpper(generator), test::randomUpper(generator));
      QVERIFY(std::isfinite(value.x) && value.x >= 0 && value.x <= 1e6 * (1 + 1e-9));
    }
    QVERIFY(brdf->evaluate({0.6, 0, 0.8}, {0.6, 0, 0.8}).x < 1);
  }
};

GONIO_TEST(McCoolTest)
}  // namespace mccool_test

#include "mccool_test.moc"
