// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/weighted_sum.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/function_brdf.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace weighted_sum_test {
using namespace gonio;
using namespace gonio::test;

constexpr HalfDifferenceGrid grid{.thetaHCount = 12, .thetaDCount = 10, .phiDCount = 18};

std::shared_ptr<const Brdf> shared(std::unique_ptr<const Brdf> brdf) { return brdf; }
const std::shared_ptr<const Brdf> matte = shared(ggx(Rgb(0.3, 0.2, 0.1), Rgb(0.2), 0.6, 0.1));
const std::shared_ptr<const Brdf> shiny = shared(ggx(Rgb(0.05), Rgb(0.9), 0.2, 0.5));

std::shared_ptr<const Brdf> sumOf(std::vector<std::shared_ptr<const Brdf>> terms, std::vector<double> weights) {
  return weightedSum(std::move(terms), std::move(weights));
}

class WeightedSumTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void valuesAreTheSum() {
    const auto sum = sumOf({matte, shiny, matte}, {0.25, 0.5, 0});
    std::mt19937_64 random(1);
    std::vector<DirectionPair> pairs(200);
    for (DirectionPair& pair : pairs) pair = {randomUpper(random), randomUpper(random)};
    std::vector<Rgb> values(pairs.size());
    sum->evaluate(pairs, values);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      QVERIFY(glm::length(values[i] - (0.25 * matte->evaluate(wi, wo) + 0.5 * shiny->evaluate(wi, wo))) < 1e-14);
    }
    QVERIFY(sum->isIsotropic());
    const auto turned =
        std::make_shared<const FunctionBrdf>([](const Direction&, const Direction&) { return Rgb(1); }, false);
    QVERIFY(!sumOf({matte, turned}, {0.5, 0.5})->isIsotropic());
    QVERIFY(sumOf({matte, turned}, {1, 0})->isIsotropic());
    QVERIFY(sum->isReciprocal());
    const auto skewed = std::make_shared<const FunctionBrdf>(
        [](const Direction& wi, const Direction&) { return Rgb(wi.z); }, true, false);
    QVERIFY(!sumOf({matte, skewed}, {0.5, 0.5})->isReciprocal());
  }

  void drawsFromAllTerms() {
    const auto sum = sumOf({matte, shiny}, {0.3, 1.2});
    for (const double theta : {0.0, 0.7, 1.4}) {
      const test::SamplingCheck check = test::checkSampling(*sum, fromSpherical(theta, 0.3), 1 << 20, 1e-5);
      QVERIFY(check.valid);
      QVERIFY(std::abs(check.integral - 1) < 1e-4);
      QVERIFY(check.pValue > 1e-5 && check.widerPValue < 1e-9);
    }
  }

  void tables() {
    const std::shared_ptr<const TabulatedBrdf> a = bakeTable(*matte, grid), b = bakeTable(*shiny, grid);
    std::vector<std::uint8_t> flags(b->valid().begin(), b->valid().end());
    const std::size_t hole = grid.index(3, 2, 5);
    flags[hole] = 0;
    const auto holed = std::make_shared<const TabulatedBrdf>(
        grid, std::vector<TabulatedBrdf::Value>(b->values().begin(), b->values().end()), flags);
    const std::vector<std::shared_ptr<const TabulatedBrdf>> terms{a, holed};
    const auto sum = weightedSum(terms, std::vector{0.25, 0.75});
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      QCOMPARE(sum->valid()[cell] != 0, a->valid()[cell] && flags[cell]);
      if (!sum->valid()[cell]) continue;
      const Rgb expected = 0.25 * Rgb(a->values()[cell]) + 0.75 * Rgb(b->values()[cell]);
      QVERIFY(glm::length(Rgb(sum->values()[cell]) - expected) <= 1e-7 * glm::length(expected));
    }
    // What has no weight takes nothing away.
    QVERIFY(weightedSum(terms, std::vector{1.0, 0.0})->valid()[hole] != 0);
  }

  void tableOnAnotherGrid() {
    constexpr HalfDifferenceGrid coarse{.thetaHCount = 6, .thetaDCount = 5, .phiDCount = 9};
    const std::shared_ptr<const TabulatedBrdf> fine = bakeTable(*matte, grid);
    QVERIFY(onGrid(fine, grid) == fine);
    // The coarse nodes are nodes of the fine grid.
    const auto other = onGrid(fine, coarse);
    for (std::size_t cell = 0; cell < coarse.size(); ++cell) {
      const std::size_t phi = cell % 9, td = cell / 9 % 5, th = cell / 45;
      const std::size_t at = grid.index(int(2 * th), int(2 * td), int(2 * phi));
      QCOMPARE(other->valid()[cell], fine->valid()[at]);
      if (other->valid()[cell]) QVERIFY(glm::length(Rgb(other->values()[cell]) - Rgb(fine->values()[at])) < 1e-6);
    }
  }
};

GONIO_TEST(WeightedSumTest)
}  // namespace weighted_sum_test

#include "weighted_sum_test.moc"
