// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/masked_rank_one.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/factorization/canonical_polyadic.h"
#include "core/math/parallel.h"
#include "tests/support/test_program.h"

namespace masked_rank_one_test {
using namespace gonio;
using namespace gonio::factorization;

/// Uniform entries; `keep` is the fraction of the cells that count.
MaskedTensor randomTensor(int m, int n, int p, bool positive, double keep, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  MaskedTensor t{.sizes = {m, n, p}, .values = {}, .weights = {}};
  for (int at = 0; at < m * n * p; ++at) {
    const double value = positive ? uniform(random) : 2 * uniform(random) - 1;
    t.weights.push_back(uniform(random) < keep ? 1 : 0);
    t.values.push_back(float(value) * t.weights.back());
  }
  return t;
}

double squaredDistance(const MaskedTensor& t, const RankOne& term) {
  double sum = 0;
  for (int i = 0; i < t.sizes[0]; ++i)
    for (int j = 0; j < t.sizes[1]; ++j)
      for (int k = 0; k < t.sizes[2]; ++k) {
        const std::size_t at = t.index(i, j, k);
        const double d =
            double(t.values[at]) - term.a[std::size_t(i)] * term.b[std::size_t(j)] * term.c[std::size_t(k)];
        sum += double(t.weights[at]) * d * d;
      }
  return sum;
}

class MaskedRankOneTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Values of 1e-30 and 1e30, whose products underflow and overflow in single precision: the same factors.
  void hardCase56TinyAndHugeValues() {
    const MaskedTensor t = randomTensor(7, 9, 11, true, 0.6, 3);
    for (const int exponent : {-100, 100})
      for (const bool positive : {true, false}) {
        const RankOne expected = bestRankOne(t, {.nonnegative = positive});
        MaskedTensor scaled = t;
        for (float& value : scaled.values) value = std::ldexp(value, exponent);
        const RankOne found = bestRankOne(scaled, {.nonnegative = positive});
        QVERIFY(found.b == expected.b && found.c == expected.c);
        for (std::size_t i = 0; i < found.a.size(); ++i) QCOMPARE(found.a[i], std::ldexp(expected.a[i], exponent));
        QCOMPARE(found.residuals.back(), std::ldexp(expected.residuals.back(), 2 * exponent));
      }
  }

  /// The residual is reported correctly, never rises, and no small change of a factor makes it smaller.
  void residualFallsToAMinimum() {
    for (const bool positive : {true, false}) {
      const MaskedTensor t = randomTensor(7, 9, 11, positive, 0.6, 3);
      const RankOne term = bestRankOne(t, {.nonnegative = positive, .maxSweeps = 500, .tolerance = 1e-9});
      for (std::size_t i = 1; i < term.residuals.size(); ++i) QVERIFY(term.residuals[i] <= term.residuals[i - 1]);
      const double least = squaredDistance(t, term);
      QVERIFY(std::abs(term.residuals.back() - least) < 1e-4 * t.squaredNorm());
      for (std::vector<double> RankOne::*factor : {&RankOne::a, &RankOne::b, &RankOne::c})
        for (std::size_t i = 0; i < (term.*factor).size(); ++i)
          for (const double step : {-0.05, 0.05}) {
            RankOne moved = term;
            (moved.*factor)[i] += step;
            QVERIFY(squaredDistance(t, moved) >= least * (1 - 1e-5));
          }
    }
  }

  void nonNegativeDataHaveNonNegativeFactors() {
    const RankOne term = bestRankOne(randomTensor(6, 7, 8, true, 0.5, 4), {.nonnegative = true});
    for (const auto* factor : {&term.a, &term.b, &term.c})
      for (const double value : *factor) QVERIFY(value >= 0);
  }

  /// Separable data are found exactly, whatever cells are missing, as long as no row is.
  void separableDataAreExact() {
    for (const bool nonnegative : {true, false}) {
      MaskedTensor t = randomTensor(8, 9, 10, true, 0.5, 5);
      for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 9; ++j)
          for (int k = 0; k < 10; ++k)
            t.values[t.index(i, j, k)] =
                t.weights[t.index(i, j, k)] * float((1 + i) * std::exp(-0.3 * j) * (2 + k % 3));
      const RankOne term = bestRankOne(t, {.nonnegative = nonnegative, .maxSweeps = 500, .tolerance = 1e-12});
      QVERIFY2(squaredDistance(t, term) < 1e-10 * t.squaredNorm(), QByteArray::number(squaredDistance(t, term)));
      const double before = t.squaredNorm();
      subtract(t, term);
      QVERIFY(t.squaredNorm() < 1e-10 * before);
    }
  }

  /// With every cell it is the CP decomposition of rank one.
  void withoutAMaskItIsTheCanonicalDecomposition() {
    const MaskedTensor t = randomTensor(5, 6, 7, true, 2, 6);
    Tensor dense({7, 6, 5});
    for (std::size_t i = 0; i < dense.count(); ++i) dense[i] = double(t.values[i]);
    const CanonicalPolyadic cp = decomposeCanonicalPolyadic(dense, 1, {.tolerance = 1e-13});
    const RankOne term = bestRankOne(t, {.nonnegative = true, .maxSweeps = 500, .tolerance = 1e-12});
    QVERIFY(std::abs(std::sqrt(squaredDistance(t, term)) / dense.norm() - (1 - cp.fit)) < 1e-6);
  }

  void hardCase18EmptyTensorsAndRows() {
    MaskedTensor zero = randomTensor(4, 5, 6, true, -1, 1);
    const RankOne nothing = bestRankOne(zero);
    QCOMPARE(squaredDistance(zero, nothing), 0.0);
    QCOMPARE(nothing.residuals.back(), 0.0);
    MaskedTensor t = randomTensor(4, 5, 6, true, 1, 2);
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 6; ++k) t.values[t.index(2, j, k)] = t.weights[t.index(2, j, k)] = 0;
    const RankOne term = bestRankOne(t, {.nonnegative = true});
    QCOMPARE(term.a[2], 0.0);
    for (const auto* factor : {&term.a, &term.b, &term.c})
      for (const double value : *factor) QVERIFY(std::isfinite(value));
  }

  void hardCase50SameBitsForAnyNumberOfThreads() {
    const MaskedTensor t = randomTensor(40, 30, 20, false, 0.7, 8);
    const RankOne all = bestRankOne(t);
    const ThreadLimit one(1);
    QVERIFY(bestRankOne(t).a == all.a && bestRankOne(t).c == all.c);
  }
};

GONIO_TEST(MaskedRankOneTest)
}  // namespace masked_rank_one_test

#include "masked_rank_one_test.moc"
