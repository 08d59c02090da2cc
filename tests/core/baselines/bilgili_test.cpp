// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/bilgili.h"

#include <QTest>
#include <cmath>

#include "tests/core/baselines/half_out_test_support.h"
#include "tests/support/test_program.h"

namespace bilgili_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;
using factorization::test_support::axesWithoutHorizon;
using factorization::test_support::halfOutSamples;
using factorization::test_support::worstAtNodes;

double product(double thetaH, double phiH, double thetaO) {
  return std::exp(-3 * thetaH) * (2 + std::cos(phiH)) * (1 + thetaO);
}

class BilgiliTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// ln(1 + Y) one product, colours in proportion: one term holds it.
  void exactForOneProduct() {
    const Rgb ks(0.7, 1, 1.2);
    const Rgb luminanceFree = ks / luminance(ks);
    const HalfOutSamples s = halfOutSamples(axesWithoutHorizon(), [&](double h, double p, double o, double) {
      return luminanceFree * std::expm1(product(h, p, o));
    });
    const BilgiliFactors f = factorizeBilgili(s, 1);
    QVERIFY(f.residuals[1] < 1e-5);
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(f.ks[c] - luminanceFree[c]) < 1e-4 && std::abs(f.kd[c]) < 1e-4);
    QVERIFY(worstAtNodes(s, *makeBilgiliBrdf(f)) < 1e-3);
  }

  /// A coloured body under a white highlight: the line through the luminance is exact, one of its kd is negative.
  void colourIsALine() {
    const Rgb body(0.1, 0.02, 0.3);
    const HalfOutSamples s = halfOutSamples(axesWithoutHorizon(), [&](double h, double p, double o, double) {
      return body + Rgb(std::expm1(product(h, p, o)) - luminance(body));
    });
    const BilgiliFactors f = factorizeBilgili(s, 1);
    for (int c = 0; c < 3; ++c) {
      QVERIFY(std::abs(f.kd[c] - (body[c] - luminance(body))) < 1e-4);
      QVERIFY(std::abs(f.ks[c] - 1) < 1e-5);
    }
  }

  /// Each channel one product, of colours that no line through the luminance has.
  void channelsAreExactWhereTheLuminanceIsNot() {
    const HalfOutSamples s = halfOutSamples(axesWithoutHorizon(), [&](double h, double p, double o, double) {
      return Rgb(std::expm1(product(h, p, o)), std::expm1(product(h / 3, p, o) / 2), std::expm1((1 + p) * (2 - o)));
    });
    std::array<BilgiliFactors, 3> channels;
    for (int c = 0; c < 3; ++c) {
      channels[std::size_t(c)] = factorizeBilgili(s, 1, c);
      QCOMPARE(channels[std::size_t(c)].bytes(), factorizeBilgili(s, 1).bytes() - 24);
    }
    QVERIFY(worstAtNodes(s, *makeBilgiliBrdf(channels)) < 1e-3);
    QVERIFY(worstAtNodes(s, *makeBilgiliBrdf(factorizeBilgili(s, 5))) > 0.1);
  }

  void residualNeverRises() {
    const HalfOutSamples s = halfOutSamples(makeHalfOutAxes(12, 8, 9), [](double h, double p, double o, double) {
      return Rgb(std::exp(-5 * h * (1 + o)) + 0.1 * std::abs(std::sin(3 * p * h)));
    });
    const BilgiliFactors f = factorizeBilgili(s, 12);
    QCOMPARE(f.residuals.size(), std::size_t(13));
    QCOMPARE(f.residuals.front(), 1.0);
    for (std::size_t l = 1; l < f.residuals.size(); ++l) QVERIFY(f.residuals[l] <= f.residuals[l - 1] + 1e-9);
    QVERIFY(f.residuals.back() < 0.5 * f.residuals[1]);
    QCOMPARE(f.bytes(), std::size_t(12 * (12 + 8 + 9) * 4 + 28));
  }

  void hardCase18Black() {
    const HalfOutSamples s =
        halfOutSamples(makeHalfOutAxes(6, 4, 5), [](double, double, double, double) { return Rgb(0); });
    const BilgiliFactors f = factorizeBilgili(s, 2);
    QCOMPARE(f.residuals, (std::vector<double>{0, 0, 0}));
    QCOMPARE(worstAtNodes(s, *makeBilgiliBrdf(f)), 0.0);
  }

  void hardCase14Constant() {
    const Rgb colour(0.3, 0.2, 0.1);
    const HalfOutSamples s =
        halfOutSamples(makeHalfOutAxes(6, 4, 5), [&](double, double, double, double) { return colour; });
    QVERIFY(worstAtNodes(s, *makeBilgiliBrdf(factorizeBilgili(s, 1))) < 1e-5);
  }

  /// Between a measured node and a hole the model reads both: holes hold what their neighbours hold, not a product that
  /// nothing bounds. Many terms of data that no product makes, at pairs up to the horizon.
  void boundedAtTheHorizon() {
    const HalfOutSamples s = halfOutSamples(makeHalfOutAxes(24, 12, 12), [](double h, double p, double o, double cosI) {
      return Rgb(0.05 + 200 * std::exp(-60 * h * h) + std::abs(std::sin(5 * h * p * o)) / (0.05 + cosI));
    });
    double largest = 0;
    for (const Rgb& value : s.values) largest = std::max(largest, value.x);
    QVERIFY(largest > 150);
    const auto brdf = makeBilgiliBrdf(factorizeBilgili(s, 40));
    for (int i = 0; i < 60; ++i)
      for (int k = 0; k < 24; ++k) {
        const Rgb value =
            brdf->evaluate(fromSpherical(radians(88 + 0.03 * i), pi * k / 24), fromSpherical(radians(1.4 * i), 0));
        // Off the highlight: theta_h > 20 degrees, where the data are at most about 10 / sr.
        if (toHalfOut(fromSpherical(radians(88 + 0.03 * i), pi * k / 24), fromSpherical(radians(1.4 * i), 0)).thetaH >
            radians(25))
          QVERIFY2(value.x < 40, qPrintable(QString("%1 %2: %3").arg(i).arg(k).arg(value.x)));
      }
  }

  /// Fewer terms of the same factorisation are those of a shorter one.
  void truncatedIsShorterFit() {
    const HalfOutSamples s = halfOutSamples(makeHalfOutAxes(12, 8, 9), [](double h, double p, double o, double) {
      return Rgb(std::exp(-5 * h * (1 + o)) + 0.1 * std::abs(std::sin(3 * p * h)), 0.2, 0.1);
    });
    const BilgiliFactors truncated = truncateBilgili(factorizeBilgili(s, 6), 3, s), shorter = factorizeBilgili(s, 3);
    QCOMPARE(truncated.residuals, shorter.residuals);
    QCOMPARE(truncated.ks, shorter.ks);
    QCOMPARE(truncated.kd, shorter.kd);
    QCOMPARE(truncated.bytes(), shorter.bytes());
  }

  void termsFillTheBudget() {
    const HalfOutAxes axes = bilgiliAxes();
    QCOMPARE(bilgiliTerms(axes, 10 * 4 * 180 + 28), 10);
    QCOMPARE(bilgiliTerms(axes, 10 * 4 * 180 + 27), 9);
    QCOMPARE(bilgiliTerms(axes, 3), 1);
  }
};

GONIO_TEST(BilgiliTest)
}  // namespace bilgili_test

#include "bilgili_test.moc"
