// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/brdf/tabulated_brdf.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace bake_table_test {
using namespace gonio;

class BakeTableTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nodesHoldTheModelsValues() {
    const auto brdf = test::ggx(Rgb(0.2, 0.3, 0.4), Rgb(1, 0.9, 0.8), 0.2, 0.1);
    const auto table = bakeTable(*brdf);
    QCOMPARE(table->validCount(), std::size_t(1111432));
    const HalfDifferenceGrid& grid = table->grid();
    for (std::size_t i = 0; i < grid.size(); i += 17) {
      QCOMPARE(table->valid()[i] != 0, grid.nodeAboveHorizon(i));
      if (!grid.nodeAboveHorizon(i)) continue;
      auto [wi, wo] = grid.directions(i);
      wi.z = std::max(0.0, wi.z), wo.z = std::max(0.0, wo.z);
      QVERIFY(table->values()[i] == TabulatedBrdf::Value(brdf->evaluate(wi, wo)));
    }
  }

  void sameBitsForAnyThreadCount() {
    const auto brdf = test::ggx(Rgb(0.2), Rgb(1), 0.05, 0.9);
    const auto bake = [&](int threads) {
      const ThreadLimit limit(threads);
      return bakeTable(*brdf);
    };
    const auto one = bake(1), two = bake(2);
    QVERIFY(std::ranges::equal(one->values(), two->values()));
    QVERIFY(std::ranges::equal(one->valid(), two->valid()));
  }

  /// 1 + cos of twice the azimuth of wi averages to 1 over four or more rotations; over one it does not.
  void anisotropicIsAveragedOverAzimuths() {
    const test::FunctionBrdf brdf(
        [](const Direction& wi, const Direction&) {
          return Rgb(wi.x * wi.x + wi.y * wi.y > 0 ? 2 * wi.x * wi.x / (wi.x * wi.x + wi.y * wi.y) : 1.0);
        },
        false);
    const HalfDifferenceGrid grid{10, 10, 20, true};
    const auto averaged = bakeTable(brdf, grid, {}, 8), single = bakeTable(brdf, grid, {}, 1);
    bool differs = false;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (!averaged->valid()[i]) continue;
      QVERIFY(std::abs(averaged->values()[i].x - 1) < 1e-6);
      differs = differs || std::abs(single->values()[i].x - 1) > 0.5;
    }
    QVERIFY(differs);
  }

  /// A grid that folds phi_d cannot distinguish wi from wo: of f = cos^2 theta_i its nodes hold the mean of both
  /// orders. One that does not fold it distinguishes them.
  void bothOrdersAreAveragedWhereTheGridFolds() {
    const test::FunctionBrdf brdf([](const Direction& wi, const Direction&) { return Rgb(wi.z * wi.z); }, true, false);
    const auto folded = bakeTable(brdf, {10, 10, 20, true}), whole = bakeTable(brdf, {10, 10, 40, false});
    const auto check = [](const TabulatedBrdf& table, double (*expected)(const DirectionPair&)) {
      for (std::size_t i = 0; i < table.grid().size(); ++i)
        if (table.valid()[i]) QVERIFY(std::abs(table.values()[i].x - expected(table.grid().directions(i))) < 1e-6);
    };
    check(*folded, [](const DirectionPair& p) { return (p.wi.z * p.wi.z + p.wo.z * p.wo.z) / 2; });
    check(*whole, [](const DirectionPair& p) { return p.wi.z * p.wi.z; });
  }

  /// The folded table is the mean of both orders of the whole circle's.
  void theMeanOfBothOrders() {
    const test::FunctionBrdf oneWay(
        [](const Direction& wi, const Direction& wo) {
          return Rgb(wi.z - 0.4, wo.z * wo.z, 0.2 + wi.x * wo.x + wi.y * wo.y);
        },
        true, false);
    constexpr HalfDifferenceGrid grid{12, 12, 20};
    const auto both = bakeTable(oneWay, grid.wholeCircle(), {}, 1, NegativeValues::stay);
    const auto folded = bakeTable(oneWay, grid, {}, 1), mean = meanOfOrders(both);
    QCOMPARE(mean->grid(), grid);
    QVERIFY(std::ranges::equal(mean->valid(), folded->valid()));
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(mean->values()[cell][c] - folded->values()[cell][c]) < 1e-6f);
    QVERIFY(std::ranges::any_of(both->values(), [](const auto& value) { return value.r < -0.1f; }));
    QCOMPARE(both->clampedCount(), std::size_t(0));
    QVERIFY(meanOfOrders(mean) == mean);
  }

  void mirrorImagesOfAPairAgree() {
    const auto table = bakeTable(*test::ggx(Rgb(0.1), Rgb(1), 0.3, 0.2));
    std::mt19937_64 random(1);
    for (int n = 0; n < 10000; ++n) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      const Rgb a = table->evaluate(wi, wo), b = table->evaluate({wi.x, -wi.y, wi.z}, {wo.x, -wo.y, wo.z});
      QVERIFY(maxChannel(glm::abs(a - b)) <= 1e-6 * std::max(1.0, maxChannel(a)));
    }
  }

  void aBrdfThatIsNotFiniteIsRefused() {
    const test::FunctionBrdf bad([](const Direction& wi, const Direction&) { return Rgb(wi.z > 0.5 ? NAN : 0.0); });
    QVERIFY_THROWS_EXCEPTION(Error, bakeTable(bad, {10, 10, 10, true}));
  }

  void hardCase39OverflowOfFloatIsCapped() {
    const test::FunctionBrdf huge([](const Direction&, const Direction&) { return Rgb(1e300, 2, 0); });
    const auto table = bakeTable(huge, {10, 10, 10, true});
    for (std::size_t i = 0; i < table->grid().size(); ++i)
      if (table->valid()[i])
        QCOMPARE(table->values()[i], TabulatedBrdf::Value(std::numeric_limits<float>::max(), 2, 0));
    QVERIFY(std::isfinite(table->evaluate({0.6, 0, 0.8}, {0, 0.6, 0.8}).x));
  }

  void cancelled() {
    std::stop_source source;
    source.request_stop();
    TaskControl control;
    control.stop = source.get_token();
    QVERIFY_THROWS_EXCEPTION(Cancelled, bakeTable(test::lambert(Rgb(1)), {}, control));
  }
};

GONIO_TEST(BakeTableTest)
}  // namespace bake_table_test

#include "bake_table_test.moc"
