// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_difference_tensor.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/factorization/canonical_polyadic.h"
#include "tests/core/factorization/half_difference_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace half_difference_tensor_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;
using factorization::test_support::halfDifferenceSamples;
using factorization::test_support::worstAtNodes;

using Logarithm = Rgb (*)(const HalfDifference& at);

/// No node has a direction below the horizon: the tensor has no holes.
HalfDifferenceAxes innerAxes() {
  HalfDifferenceAxes axes = makeHalfDifferenceAxes(12, 9, 5);
  for (double& theta : axes.thetaH) theta *= 0.4;
  for (double& theta : axes.thetaD) theta *= 0.4;
  return axes;
}

HalfDifferenceSamples samplesOf(const HalfDifferenceAxes& axes, Logarithm y) {
  return halfDifferenceSamples(axes, [y](const HalfDifference& at, const DirectionPair&) {
    const Rgb value = y(at);
    return Rgb(std::expm1(value.x), std::expm1(value.y), std::expm1(value.z));
  });
}

/// Without a dependence on phi_d at theta_d = 0, where it is undefined.
Rgb oneTerm(const HalfDifference& at) {
  return std::exp(-3 * at.thetaH) * 2 * at.thetaD * (2 + std::cos(2 * at.phiD)) * Rgb(1, 0.5, 0.2);
}
Rgb twoTerms(const HalfDifference& at) {
  return oneTerm(at) + (0.1 + at.thetaH) * (1 + at.thetaD * at.thetaD) * Rgb(0.1, 0.4, 0.8);
}
Rgb manyTerms(const HalfDifference& at) {
  return Rgb(1, 0.8, 0.5) * std::exp(-8 * at.thetaH * (1 + at.thetaD * (1 + 0.3 * std::cos(2 * at.phiD))));
}

class HalfDifferenceTensorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// y of as many products is exact with as many terms, and not with one fewer.
  void cpIsExactForAsManyProducts() {
    const HalfDifferenceSamples one = samplesOf(innerAxes(), oneTerm), two = samplesOf(innerAxes(), twoTerms);
    const auto rebuilt = [](const HalfDifferenceSamples& s, int terms) {
      return worstAtNodes(s, *makeHalfDifferenceTensorBrdf(decomposeCp(sampleHalfDifferenceTensor(s), terms)));
    };
    QVERIFY2(rebuilt(one, 1) < 1e-9, qPrintable(QString::number(rebuilt(one, 1))));
    QVERIFY(rebuilt(two, 1) > 0.01);
    QVERIFY2(rebuilt(two, 2) < 1e-3, qPrintable(QString::number(rebuilt(two, 2))));
  }

  /// All ranks rebuild any data, with holes or without: those of a hole are made up.
  void hosvdOfFullRanksIsExact() {
    const HalfDifferenceSamples s = samplesOf(makeHalfDifferenceAxes(8, 6, 3), manyTerms);
    const HalfDifferenceTensor tensor = sampleHalfDifferenceTensor(s);
    const HalfDifferenceTensor all = decomposeHosvd(tensor, {8, 6, 3});
    QVERIFY(all.residual < 1e-12);
    QVERIFY(worstAtNodes(s, *makeHalfDifferenceTensorBrdf(all)) < 1e-9);
    const HalfDifferenceSamples one = samplesOf(innerAxes(), oneTerm);
    const auto single = decomposeHosvd(sampleHalfDifferenceTensor(one), {1, 1, 1});
    const double worst = worstAtNodes(one, *makeHalfDifferenceTensorBrdf(single));
    QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
  }

  /// The squared error is at most the sum of the squared singular values that are left out (De Lathauwer et al. 2000,
  /// property 10), and at least the largest of these sums of one mode.
  void hosvdErrorIsBounded() {
    const HalfDifferenceTensor tensor = sampleHalfDifferenceTensor(samplesOf(innerAxes(), manyTerms));
    const std::array<int, 3> ranks{3, 2, 1};
    const HalfDifferenceTensor truncated = decomposeHosvd(tensor, ranks);
    const Tensor core = decomposeHigherOrderSvd(tensor.values).core;
    double all = 0, largest = 0;
    for (int mode = 0; mode < 3; ++mode) {
      const Eigen::MatrixXd fibres = unfold(core, mode);
      const double left = fibres.bottomRows(fibres.rows() - ranks[std::size_t(mode)]).squaredNorm();
      all += left;
      largest = std::max(largest, left);
    }
    const double squared = std::pow(truncated.residual * tensor.values.norm(), 2);
    QVERIFY(largest > 0 && squared <= all * (1 + 1e-9) && squared >= largest * (1 - 1e-9));
  }

  /// Parseval: the squared residual is the energy of what is left out. One product of cosines needs one coefficient.
  void cosineSeriesKeepTheLargestCoefficients() {
    const HalfDifferenceAxes axes = makeHalfDifferenceAxes(12, 8, 5);
    const auto tensor = sampleHalfDifferenceTensor(samplesOf(axes, manyTerms));
    QVERIFY(truncateCosineSeries(tensor, 12 * 8 * 5 * 3).residual < 1e-12);
    double before = 1;
    for (const std::size_t count : {1, 10, 100, 600}) {
      const HalfDifferenceTensor series = truncateCosineSeries(tensor, count);
      // The kept part is orthogonal to the residual.
      const double kept = series.values.norm() / tensor.values.norm();
      QVERIFY(std::abs(kept * kept + series.residual * series.residual - 1) < 1e-12);
      QVERIFY(series.residual < before);
      before = series.residual;
    }
    HalfDifferenceTensor wave = tensor;
    std::size_t i = 0;
    for (int c = 0; c < 3; ++c)
      for (int p = 0; p < 5; ++p)
        for (int d = 0; d < 8; ++d)
          for (int h = 0; h < 12; ++h)
            wave.values[i++] = std::cos(pi * 3 * (h + 0.5) / 12) * std::cos(pi * 2 * (d + 0.5) / 8);
    QVERIFY(truncateCosineSeries(wave, 1).residual < 1e-12);
  }

  /// The composed tensor, interpolated, is the sum of the products of the interpolated curves.
  void evaluationInterpolatesTheCurves() {
    const HalfDifferenceAxes axes = innerAxes();
    const auto brdf =
        makeHalfDifferenceTensorBrdf(decomposeCp(sampleHalfDifferenceTensor(samplesOf(axes, oneTerm)), 1));
    const double h = 0.5 * (axes.thetaH[4] + axes.thetaH[5]), d = 0.25 * axes.thetaD[3] + 0.75 * axes.thetaD[4],
                 p = 0.5 * (axes.phiD[1] + axes.phiD[2]);
    const double ofH = 0.5 * (std::exp(-3 * axes.thetaH[4]) + std::exp(-3 * axes.thetaH[5])), ofD = 2 * d,
                 ofP = 2 + 0.5 * (std::cos(2 * axes.phiD[1]) + std::cos(2 * axes.phiD[2]));
    const DirectionPair at = fromHalfDifference(h, d, p);
    const Rgb found = brdf->evaluate(at.wi, at.wo);
    QVERIFY(std::abs(found.x - std::expm1(ofH * ofD * ofP)) < 1e-9);
    QVERIFY(std::abs(found.z - std::expm1(0.2 * ofH * ofD * ofP)) < 1e-9);
  }

  void reciprocalAndNotNegative() {
    const auto tensor = sampleHalfDifferenceTensor(samplesOf(makeHalfDifferenceAxes(20, 10, 5), manyTerms));
    std::mt19937_64 generator(3);
    for (const HalfDifferenceTensor& model : {decomposeCp(tensor, 3), decomposeHosvd(tensor, {4, 3, 2})}) {
      const auto brdf = makeHalfDifferenceTensorBrdf(model);
      for (int i = 0; i < 1000; ++i) {
        const Direction wi = test::randomUpper(generator), wo = test::randomUpper(generator);
        const double a = brdf->evaluate(wi, wo).y, b = brdf->evaluate(wo, wi).y;
        QVERIFY(std::isfinite(a) && a >= 0 && a <= std::expm1(tensor.highest) + 1e-9);
        QVERIFY(std::abs(a - b) < 1e-9);
      }
    }
  }

  void hardCase12Black() {
    const auto tensor =
        sampleHalfDifferenceTensor(samplesOf(innerAxes(), [](const HalfDifference&) { return Rgb(0); }));
    for (const HalfDifferenceTensor& model : {decomposeCp(tensor, 2), decomposeHosvd(tensor, {2, 2, 2})}) {
      QCOMPARE(model.residual, 0.0);
      QCOMPARE(makeHalfDifferenceTensorBrdf(model)->evaluate({0, 0.6, 0.8}, {0.6, 0, 0.8}), Rgb(0));
    }
  }

  void sizesFillTheBudget() {
    const HalfDifferenceAxes axes = makeHalfDifferenceAxes(90, 30, 7);
    const std::size_t term = 4 * (90 + 30 + 7 + 3);
    QCOMPARE(cpTerms(axes, 5 * term + 4), 5);
    QCOMPARE(cpTerms(axes, 5 * term + 3), 4);
    QCOMPARE(cpTerms(axes, 3), 1);
    QCOMPARE(cpTerms(axes, 100'000'000), maxCpTerms);
    QCOMPARE(cosineCoefficients(axes, 5 * 6 + 4), std::size_t(5));
    QCOMPARE(cosineCoefficients(axes, 5 * 6 + 3), std::size_t(4));
    QCOMPARE(cosineCoefficients(axes, 0), std::size_t(1));
    QCOMPARE(cosineCoefficients(axes, 100'000'000), std::size_t(90 * 30 * 7 * 3));
    QVERIFY((hosvdRanks(axes, 100'000'000) == std::array<int, 3>{90, 30, 7}));
    QVERIFY((hosvdRanks(axes, 1) == std::array<int, 3>{1, 1, 1}));
    // Ranks 30, 10, 2: a core of 1,800 numbers, matrices of 2,700, 300, 14 and 9, and the bound.
    const std::size_t bytes = 4 * (30 * 10 * 2 * 3 + 30 * 90 + 10 * 30 + 2 * 7 + 9 + 1);
    QVERIFY((hosvdRanks(axes, bytes) == std::array<int, 3>{30, 10, 2}));
    QVERIFY(hosvdRanks(axes, bytes - 1)[0] == 29);
    const auto tensor = sampleHalfDifferenceTensor(samplesOf(axes, oneTerm));
    QCOMPARE(decomposeHosvd(tensor, {30, 10, 2}).bytes, bytes);
    QCOMPARE(decomposeCp(tensor, 1).bytes, term + 4);
  }
};

GONIO_TEST(HalfDifferenceTensorTest)
}  // namespace half_difference_tensor_test

#include "half_difference_tensor_test.moc"
