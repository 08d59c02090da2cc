// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/kautz_mccool.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/core/factorization/half_difference_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace kautz_mccool_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;
using factorization::test_support::halfDifferenceSamples;
using factorization::test_support::worstAtNodes;

/// No node has a direction below the horizon: the matrix has no holes.
HalfDifferenceAxes axesWithoutHoles() {
  HalfDifferenceAxes axes = makeHalfDifferenceAxes(12, 9, 5);
  for (double& theta : axes.thetaH) theta *= 0.4;
  for (double& theta : axes.thetaD) theta *= 0.4;
  return axes;
}

Rgb product(const HalfDifference& at) {
  return std::exp(-5 * at.thetaH) * (2 + std::cos(2 * at.phiD) * at.thetaD) * Rgb(1, 0.5 + at.thetaH, 0.2);
}

Rgb secondProduct(const HalfDifference& at) { return at.thetaH * (1 + at.thetaD * at.thetaD) * Rgb(0.1, 1, 2); }

Rgb manyProducts(const HalfDifference& at) {
  return Rgb(std::exp(-8 * at.thetaH * (1 + at.thetaD * (1 + 0.3 * std::cos(2 * at.phiD))))) * Rgb(1, 0.8, 0.5);
}

class KautzMcCoolTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void exactForAsManyProducts() {
    const auto one = halfDifferenceSamples(axesWithoutHoles(), [](const auto& at, const auto&) { return product(at); });
    QVERIFY(worstAtNodes(one, *makeKautzMcCoolBrdf(factorizeKautzMcCool(one, 1))) < 1e-9);
    const auto two = halfDifferenceSamples(axesWithoutHoles(),
                                           [](const auto& at, const auto&) { return product(at) + secondProduct(at); });
    QVERIFY(worstAtNodes(two, *makeKautzMcCoolBrdf(factorizeKautzMcCool(two, 1))) > 0.01);
    QVERIFY(worstAtNodes(two, *makeKautzMcCoolBrdf(factorizeKautzMcCool(two, 2))) < 1e-9);
  }

  /// Channels that differ by 16 orders of magnitude are as accurate as equal ones: the largest does not hide the
  /// others.
  void hardCase59ChannelsOfDifferentSize() {
    const Rgb sizes(1e-8, 1, 1e8);
    const auto values = [](const HalfDifference& at) { return Rgb(manyProducts(at).x) + secondProduct(at) * 0.1; };
    const auto equal =
        halfDifferenceSamples(axesWithoutHoles(), [&](const auto& at, const auto&) { return values(at); });
    const auto apart =
        halfDifferenceSamples(axesWithoutHoles(), [&](const auto& at, const auto&) { return values(at) * sizes; });
    const auto worst = [](const HalfDifferenceSamples& s, const Brdf& brdf, const Rgb& of) {
      double most = 0;
      factorization::test_support::visitNodes(
          s.axes, [&](std::size_t, std::size_t, std::size_t, std::size_t i, const DirectionPair& pair) {
            most = std::max(most, maxChannel(glm::abs(brdf.evaluate(pair.wi, pair.wo) - s.values[i]) / of));
          });
      return most;
    };
    for (const int terms : {2, 6}) {
      const double expected = worst(equal, *makeKautzMcCoolBrdf(factorizeKautzMcCool(equal, terms)), Rgb(1)),
                   found = worst(apart, *makeKautzMcCoolBrdf(factorizeKautzMcCool(apart, terms)), sizes);
      QVERIFY2(found < 2 * expected + 1e-9, qPrintable(QString("%1, equal channels %2").arg(found).arg(expected)));
      const double nonnegative =
          worst(apart, *makeKautzMcCoolBrdf(factorizeNonnegativeHalfDifference(apart, terms)), sizes);
      QVERIFY2(nonnegative < 1, qPrintable(QString::number(nonnegative)));
    }
  }

  /// All terms rebuild any data, holes or not: those of a hole are made up.
  void allTermsAreExact() {
    const auto s = halfDifferenceSamples(makeHalfDifferenceAxes(8, 6, 3),
                                         [](const auto& at, const auto&) { return manyProducts(at); });
    QVERIFY(worstAtNodes(s, *makeKautzMcCoolBrdf(factorizeKautzMcCool(s, 18))) < 1e-9);
  }

  /// The reported residual is the norm of what the model leaves, weighted, by brute force.
  void residualFallsAndIsTrue() {
    const auto s =
        halfDifferenceSamples(axesWithoutHoles(), [](const auto& at, const auto&) { return manyProducts(at); });
    const KautzMcCoolFactors all = factorizeKautzMcCool(s, 6);
    QCOMPARE(all.residuals.size(), std::size_t(7));
    QCOMPARE(all.residuals[0], 1.0);
    for (std::size_t k = 1; k < 7; ++k) QVERIFY(all.residuals[k] < all.residuals[k - 1]);
    const KautzMcCoolFactors three = all.truncated(3);
    QCOMPARE(three.residuals.size(), std::size_t(4));
    QCOMPARE(three.bytes(), std::size_t(4 * 3 * (3 * 12 + 9 * 5)));
    double left = 0, total = 0;
    factorization::test_support::visitNodes(
        s.axes, [&](std::size_t h, std::size_t d, std::size_t p, std::size_t i, const DirectionPair&) {
          // Weighted as at phi_d = pi / 2, for any azimuth.
          const double cosines = std::pow(std::cos(s.axes.thetaH[h]) * std::cos(s.axes.thetaD[d]), 2);
          const double weight = projectedMeasure(s, h, d, p) / (s.cosI[i] * s.cosO[i]) * cosines;
          for (int c = 0; c < 3; ++c) {
            double sum = 0;
            for (Eigen::Index k = 0; k < 3; ++k)
              sum += three.half(Eigen::Index(3 * h) + c, k) * three.difference(Eigen::Index(d * 5 + p), k);
            left += weight * std::pow(s.values[i][c] - sum, 2);
            total += weight * std::pow(s.values[i][c], 2);
          }
        });
    QVERIFY(std::abs(std::sqrt(left / total) / three.residuals[3] - 1) < 1e-6);
  }

  /// Eckart and Young 1936: no sum of as many products leaves less than the singular values that are left out, here of
  /// the weighted matrix by Jacobi rotations. The residuals are that bound.
  void residualsAreTheBestPossible() {
    const auto s =
        halfDifferenceSamples(axesWithoutHoles(), [](const auto& at, const auto&) { return manyProducts(at); });
    const std::size_t differences = s.axes.thetaD.size() * s.axes.phiD.size();
    Eigen::MatrixXd weighted(Eigen::Index(3 * s.axes.thetaH.size()), Eigen::Index(differences));
    factorization::test_support::visitNodes(
        s.axes, [&](std::size_t h, std::size_t d, std::size_t p, std::size_t i, const DirectionPair&) {
          const double cosines = std::cos(s.axes.thetaH[h]) * std::cos(s.axes.thetaD[d]);
          const double root = std::sqrt(projectedMeasure(s, h, d, p) / (s.cosI[i] * s.cosO[i])) * cosines;
          for (int c = 0; c < 3; ++c)
            weighted(Eigen::Index(3 * h) + c, Eigen::Index(d * s.axes.phiD.size() + p)) = root * s.values[i][c];
        });
    const Eigen::VectorXd values = test::singularValues(weighted);
    const KautzMcCoolFactors f = factorizeKautzMcCool(s, 6), nonnegative = factorizeNonnegativeHalfDifference(s, 3);
    for (Eigen::Index k = 0; k <= 6; ++k) {
      const double best = values.tail(values.size() - k).norm() / values.norm();
      QVERIFY2(std::abs(f.residuals[std::size_t(k)] / best - 1) < 1e-6, qPrintable(QString::number(k)));
      if (k == 3) QVERIFY(nonnegative.residuals.back() >= best);
    }
  }

  /// Exact for one product without negative values; never better than the SVD, the best of all sums of as many
  /// products.
  void nonnegativeFactors() {
    const auto one = halfDifferenceSamples(axesWithoutHoles(), [](const auto& at, const auto&) { return product(at); });
    QVERIFY(worstAtNodes(one, *makeKautzMcCoolBrdf(factorizeNonnegativeHalfDifference(one, 1))) < 1e-6);
    const auto many =
        halfDifferenceSamples(axesWithoutHoles(), [](const auto& at, const auto&) { return manyProducts(at); });
    const KautzMcCoolFactors f = factorizeNonnegativeHalfDifference(many, 3), svd = factorizeKautzMcCool(many, 3);
    QVERIFY(f.half.minCoeff() >= 0 && f.difference.minCoeff() >= 0);
    QVERIFY(f.residuals.back() >= svd.residuals[3] && f.residuals.back() < svd.residuals[1]);
    QCOMPARE(f.bytes(), svd.bytes());
    const auto black = halfDifferenceSamples(axesWithoutHoles(), [](const auto&, const auto&) { return Rgb(0); });
    QCOMPARE(worstAtNodes(black, *makeKautzMcCoolBrdf(factorizeNonnegativeHalfDifference(black, 2))), 0.0);
  }

  void reciprocalAndNotNegative() {
    const auto s = halfDifferenceSamples(makeHalfDifferenceAxes(20, 10, 5),
                                         [](const auto& at, const auto&) { return manyProducts(at); });
    const auto brdf = makeKautzMcCoolBrdf(factorizeKautzMcCool(s, 2));
    std::mt19937_64 generator(3);
    for (int i = 0; i < 2000; ++i) {
      const Direction wi = test::randomUpper(generator), wo = test::randomUpper(generator);
      const double a = brdf->evaluate(wi, wo).y, b = brdf->evaluate(wo, wi).y;
      QVERIFY(std::isfinite(a) && a >= 0);
      QVERIFY(std::abs(a - b) < 1e-9);
    }
  }

  void hardCase12Black() {
    const auto s = halfDifferenceSamples(axesWithoutHoles(), [](const auto&, const auto&) { return Rgb(0); });
    const KautzMcCoolFactors f = factorizeKautzMcCool(s, 2);
    QCOMPARE(f.residuals, (std::vector<double>{0, 0, 0}));
    QCOMPARE(worstAtNodes(s, *makeKautzMcCoolBrdf(f)), 0.0);
  }

  /// One term is exact, holes or not.
  void hardCase14Constant() {
    const auto s = halfDifferenceSamples(makeHalfDifferenceAxes(12, 9, 5),
                                         [](const auto&, const auto&) { return Rgb(0.3, 0.2, 0.1); });
    const auto brdf = makeKautzMcCoolBrdf(factorizeKautzMcCool(s, 1));
    QVERIFY(worstAtNodes(s, *brdf) < 1e-9);
    QVERIFY(std::abs(brdf->evaluate({0.6, 0, 0.8}, {0, 0.28, 0.96}).x - 0.3) < 1e-9);
  }

  /// One cell in a black material is one product.
  void hardCase15Spike() {
    HalfDifferenceSamples s =
        halfDifferenceSamples(axesWithoutHoles(), [](const auto&, const auto&) { return Rgb(0); });
    s.values[s.axes.index(3, 4, 2)] = Rgb(1e6);
    QVERIFY(worstAtNodes(s, *makeKautzMcCoolBrdf(factorizeKautzMcCool(s, 1))) < 1e-9);
  }

  void termsFillTheBudget() {
    const HalfDifferenceAxes axes = kautzMcCoolAxes();
    const std::size_t term = 4 * (3 * 90 + 30 * 7);
    QCOMPARE(kautzMcCoolTerms(axes, 5 * term), 5);
    QCOMPARE(kautzMcCoolTerms(axes, 5 * term - 1), 4);
    QCOMPARE(kautzMcCoolTerms(axes, 3), 1);
    QCOMPARE(kautzMcCoolTerms(axes, 100'000'000), 210);
  }
};

GONIO_TEST(KautzMcCoolTest)
}  // namespace kautz_mccool_test

#include "kautz_mccool_test.moc"
