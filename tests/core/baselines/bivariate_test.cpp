// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/bivariate.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace bivariate_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;
using test::FunctionBrdf;

const HalfDifferenceGrid smallGrid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36};

Rgb smooth(double thetaH, double thetaD) {
  return Rgb(0.2, 0.4, 0.1) + Rgb(std::exp(-4 * thetaH * thetaH) * (1 + thetaD * thetaD));
}

class BivariateTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Without a dependence on phi_d nothing is lost: exact at the nodes of the table.
  void exactWithoutAzimuth() {
    const auto table = bakeTable(FunctionBrdf([](const Direction& wi, const Direction& wo) {
                                   const HalfDifference at = toHalfDifference(wi, wo);
                                   return smooth(at.thetaH, at.thetaD);
                                 }),
                                 smallGrid);
    const auto brdf = makeBivariateBrdf(averageBivariate(*table, 30));
    for (std::size_t i = 0; i < smallGrid.size(); i += 7) {
      // phi_d = 0 has no valid neighbour for some nodes at the horizon: those are read from cells that are valid.
      if (!smallGrid.nodeWithin(i, radians(80))) continue;
      const HalfDifference node = smallGrid.node(i);
      const DirectionPair at = smallGrid.directions(i);
      const Rgb expected = smooth(node.thetaH, node.thetaD), found = brdf->evaluate(at.wi, at.wo);
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(found[c] - expected[c]) < 1e-5 * expected[c]);
    }
  }

  /// cos^2 phi_d has the mean 1/2 where all azimuths are above the horizon, and that over the rest by brute force.
  void meanOverMeasuredAzimuths() {
    const auto table = bakeTable(FunctionBrdf([](const Direction& wi, const Direction& wo) {
                                   const double c = std::cos(toHalfDifference(wi, wo).phiD);
                                   return Rgb(c * c);
                                 }),
                                 {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 180});
    const BivariateTable result = averageBivariate(*table, 30);
    for (int i = 1; i < 30; ++i)
      for (int j = 1; j < 30; ++j) {
        const double thetaH = halfPi * i * i / 900, thetaD = halfPi * j / 30;
        double sum = 0, count = 0;
        for (int k = 0; k < 180; ++k) {
          if (!isAboveHorizon(thetaH, thetaD, pi * k / 180)) continue;
          sum += std::pow(std::cos(pi * k / 180), 2);
          ++count;
        }
        const double found = double(result.values[std::size_t(i * 30 + j)].x);
        QVERIFY2(std::abs(found - sum / count) < 0.01, qPrintable(QString("%1 %2: %3").arg(i).arg(j).arg(found)));
        if (thetaH + thetaD < halfPi) QVERIFY(std::abs(found - 0.5) < 1e-4);
      }
  }

  /// Reciprocal, finite and never negative for any pair.
  void reciprocal() {
    const auto table = bakeTable(*test::ggx(Rgb(0.1), Rgb(1), 0.2, 0.05), smallGrid);
    const auto brdf = makeBivariateBrdf(averageBivariate(*table, 17));
    std::mt19937_64 generator(3);
    for (int i = 0; i < 2000; ++i) {
      const Direction wi = test::randomUpper(generator), wo = test::randomUpper(generator);
      const double a = brdf->evaluate(wi, wo).y, b = brdf->evaluate(wo, wi).y;
      QVERIFY(std::isfinite(a) && a >= 0);
      QVERIFY(std::abs(a - b) < 1e-9 * (1 + a));
    }
  }

  void budget() {
    QCOMPARE(bivariateSide(90 * 90 * 12), 90);
    QCOMPARE(bivariateSide(60 * 60 * 12), 60);
    QCOMPARE(bivariateSide(60 * 60 * 12 - 1), 59);
    QCOMPARE(bivariateSide(1), 2);
    QCOMPARE(bivariateSide(100'000'000), 90);
  }
};

GONIO_TEST(BivariateTest)
}  // namespace bivariate_test

#include "bivariate_test.moc"
