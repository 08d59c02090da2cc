// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/lawrence.h"

#include <QTest>
#include <cmath>

#include "tests/core/baselines/half_out_test_support.h"
#include "tests/support/test_program.h"

namespace lawrence_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;
using factorization::test_support::axesWithoutHorizon;
using factorization::test_support::halfOutSamples;
using factorization::test_support::worstAtNodes;

/// Cells below the horizon count as 0; at nodes where there are none the data are this one product.
Rgb product(double thetaH, double phiH, double thetaO) {
  return std::exp(-3 * thetaH) * (2 + std::cos(phiH)) * Rgb(1, 0.5 + thetaO, 0.2 * std::cos(thetaO));
}

class LawrenceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void exactForOneProduct() {
    const HalfOutSamples s = halfOutSamples(
        axesWithoutHorizon(), [](double h, double p, double o, double cosI) { return product(h, p, o) / cosI; });
    const double worst = worstAtNodes(s, *makeLawrenceBrdf(factorizeLawrence(s, {.terms = 1, .products = 1})));
    QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
  }

  /// Two products with different curves of all angles: two terms hold them.
  void twoTermsForTwoProducts() {
    const HalfOutSamples s = halfOutSamples(axesWithoutHorizon(), [](double h, double p, double o, double cosI) {
      const double second = h * h * (h > 0 ? 1 - std::cos(p) : 0) * (1 + o);
      return (product(h, p, o) + 5 * second * Rgb(0, 1, 2)) / cosI;
    });
    const double two = worstAtNodes(s, *makeLawrenceBrdf(factorizeLawrence(s, {.terms = 2, .products = 2})));
    const double one = worstAtNodes(s, *makeLawrenceBrdf(factorizeLawrence(s, {.terms = 1, .products = 1})));
    QVERIFY2(two < 0.02, qPrintable(QString::number(two)));
    QVERIFY(one > 0.1);
  }

  void nothingNegative() {
    const HalfOutSamples s = halfOutSamples(makeHalfOutAxes(10, 6, 7), [](double h, double p, double o, double) {
      return Rgb(std::exp(-20 * h * h) + 0.1 * std::sin(p + o) * std::sin(p + o));
    });
    const LawrenceFactors f = factorizeLawrence(s, {.terms = 3, .products = 2});
    QVERIFY(f.viewer.minCoeff() >= 0 && f.polar.minCoeff() >= 0 && f.azimuth.minCoeff() >= 0);
    QVERIFY(f.viewer.allFinite() && f.polar.allFinite() && f.azimuth.allFinite());
    QCOMPARE(f.bytes(), std::size_t(4 * (3 * 7 * 3 + 6 * (10 + 6))));
  }

  /// A black material stays black.
  void hardCase18Black() {
    const HalfOutSamples s =
        halfOutSamples(makeHalfOutAxes(6, 4, 5), [](double, double, double, double) { return Rgb(0); });
    QVERIFY(worstAtNodes(s, *makeLawrenceBrdf(factorizeLawrence(s, {.terms = 2, .products = 2}))) < 1e-12);
  }

  void ranksFillTheBudget() {
    const HalfOutAxes axes = lawrenceAxes();
    for (const std::size_t budget : {10, 2000, 5000, 20000, 43560, 200000}) {
      const LawrenceRanks ranks = lawrenceRanks(axes, budget);
      const std::size_t term =
          4 * (3 * axes.thetaO.size() + std::size_t(ranks.products) * (axes.thetaH.size() + axes.phiH.size()));
      QVERIFY(ranks.terms == 1 || std::size_t(ranks.terms) * term <= budget);
      QVERIFY(std::size_t(ranks.terms + 1) * term > budget);
    }
  }
};

GONIO_TEST(LawrenceTest)
}  // namespace lawrence_test

#include "lawrence_test.moc"
