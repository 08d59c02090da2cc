// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sampling_plan.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/coordinates/grid_directions.h"
#include "core/support/error.h"
#include "tests/core/io/test_files.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace sampling_plan_test {
using namespace gonio;
using namespace gonio::acquisition;

std::vector<std::uint32_t> someCells(const HalfDifferenceGrid& grid, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> cells;
  while (cells.size() < count) {
    const auto cell = std::uint32_t(random() % grid.size());
    if (grid.nodeAboveHorizon(cell)) cells.push_back(cell);
  }
  return cells;
}

double lengthOf(std::span<const DirectionPair> pairs, const std::vector<std::size_t>& way) {
  DirectionPair at;
  double length = 0;
  for (const std::size_t next : way) {
    length += armTravel(at, pairs[next]);
    at = pairs[next];
  }
  return length;
}

class SamplingPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every node above the horizon of the whole grid; where theta_h or theta_d is 0 all phi_d are one pair of
  /// directions.
  void everyNodeIsFoundAgain() {
    const HalfDifferenceGrid grid;
    const GridDirections directions(grid);
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      const auto node = directions.at(cell);
      if (!node.aboveHorizon) continue;
      ++count;
      const bool isOnePair = grid.node(cell).thetaD == 0 || grid.node(cell).thetaH == 0;
      const std::size_t expected = isOnePair ? cell - cell % std::size_t(grid.phiDCount) : cell;
      if (nearestNode(grid, node.pair) != expected) QFAIL(qPrintable(QString::number(cell)));
    }
    QVERIFY(count > 1000000);
  }

  /// Directions turned about the normal and a third of a cell off belong to the node still; light and viewer exchanged
  /// too, since the grid folds phi_d.
  void nearbyDirections() {
    const HalfDifferenceGrid grid;
    for (const std::size_t cell : {grid.index(20, 30, 60), grid.index(5, 40, 179), grid.index(40, 1, 0)}) {
      const HalfDifference at = grid.node(cell);
      const double step = halfPi / 90 * 0.3;
      const DirectionPair pair = fromHalfDifference(at.thetaH, at.thetaD + step, at.phiD - step);
      QCOMPARE(std::size_t(nearestNode(grid, pair)), cell);
      QCOMPARE(std::size_t(nearestNode(grid, {test::rotateZ(pair.wi, 2), test::rotateZ(pair.wo, 2)})), cell);
      QCOMPARE(std::size_t(nearestNode(grid, {pair.wo, pair.wi})), cell);
    }
  }

  /// The mirror pairs are one whichever way they are turned about the normal, with the rounding of a file or not.
  void mirrorPairsTurned() {
    const HalfDifferenceGrid grid;
    for (const double theta : {20.0, 21.0, 60.0})
      for (const double turn : {0.0, 0.3, 1.0, 2.5, -1.1})
        for (const double rounding : {0.0, 1e-8, -1e-8}) {
          const DirectionPair pair{fromSpherical(radians(theta), turn),
                                   fromSpherical(radians(theta) + rounding, turn + pi)};
          QCOMPARE(std::size_t(nearestNode(grid, pair)), grid.index(0, int(theta), 0));
        }
  }

  void refusals() {
    const HalfDifferenceGrid grid;
    QVERIFY_EXCEPTION_THROWN(nearestNode(grid, {Direction(1, 0, 0), Direction(-1, 0, 0)}), Error);
    QVERIFY_EXCEPTION_THROWN(nearestNode(grid, {Direction(0.6, 0, -0.8), Direction(0, 0, 1)}), Error);
    const std::vector<std::uint32_t> below{std::uint32_t(grid.index(89, 89, 0))};
    QVERIFY(!grid.nodeAboveHorizon(below[0]));
    QVERIFY(test::contains(test::errorOf([&] { planFor(grid, below); }), std::to_string(below[0])));
    QVERIFY_EXCEPTION_THROWN(planFor(grid, std::vector{std::uint32_t(grid.size())}), Error);
    QVERIFY(planFor(grid, {}).samples.empty());
  }

  void plansInTheOrderOfChoice() {
    const HalfDifferenceGrid grid;
    const auto cells = someCells(grid, 40, 1);
    const SamplingPlan plan = planFor(grid, cells);
    std::vector<int> orders;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      QCOMPARE(plan.samples[i].index, int(i) + 1);
      QVERIFY(!isBelowHorizon(plan.samples[i].directions.wi) && !isBelowHorizon(plan.samples[i].directions.wo));
      orders.push_back(plan.samples[i].order);
    }
    const auto order = plan.measurementOrder();
    for (std::size_t i = 0; i < order.size(); ++i) QCOMPARE(plan.samples[order[i]].order, int(i) + 1);
    std::sort(orders.begin(), orders.end());
    for (std::size_t i = 0; i < orders.size(); ++i) QCOMPARE(orders[i], int(i) + 1);
    QVERIFY(planFor(grid, cells).samples == plan.samples);
  }

  /// Of up to seven samples the way is compared with the best of all; it is never longer than that of nearest
  /// neighbours, and no turning round of a part makes it shorter.
  void thePathIsShort() {
    double sum = 0, best = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::mt19937_64 random(seed);
      std::vector<DirectionPair> pairs;
      for (int i = 0; i < 7; ++i) pairs.push_back({test::randomUpper(random), test::randomUpper(random)});
      const double found = lengthOf(pairs, shortPath(pairs));
      std::vector<std::size_t> way(pairs.size());
      std::iota(way.begin(), way.end(), std::size_t(0));
      double shortest = std::numeric_limits<double>::infinity();
      do shortest = std::min(shortest, lengthOf(pairs, way));
      while (std::next_permutation(way.begin(), way.end()));
      QVERIFY(found >= shortest - 1e-9);
      QVERIFY2(found < 1.35 * shortest, qPrintable(QString::number(found / shortest)));
      sum += found;
      best += shortest;
    }
    QVERIFY2(sum < 1.06 * best, qPrintable(QString::number(sum / best)));
  }

  /// A whole table of pairs has an order at once: the light goes down once.
  void pathOfVeryMany() {
    const HalfDifferenceGrid grid;
    const SamplingPlan plan = planFor(grid, someCells(grid, 60000, 6));
    double last = 0;
    for (const std::size_t position : plan.measurementOrder()) {
      const double thetaI = polarAngle(plan.samples[position].directions.wi);
      QVERIFY(thetaI > last - 1e-7);
      last = thetaI;
    }
  }

  void pathOfManyCannotBeTurned() {
    const HalfDifferenceGrid grid;
    const SamplingPlan plan = planFor(grid, someCells(grid, 60, 5));
    std::vector<DirectionPair> pairs;
    for (const PlannedSample& sample : plan.samples) pairs.push_back(sample.directions);
    const auto way = plan.measurementOrder();
    const double length = lengthOf(pairs, way);
    for (std::size_t first = 0; first < way.size(); ++first)
      for (std::size_t last = first + 2; last <= way.size(); ++last) {
        auto turned = way;
        std::reverse(turned.begin() + std::ptrdiff_t(first), turned.begin() + std::ptrdiff_t(last));
        QVERIFY(lengthOf(pairs, turned) > length - 1e-6);
      }
    auto asChosen = way;
    std::iota(asChosen.begin(), asChosen.end(), std::size_t(0));
    QVERIFY(length < 0.6 * lengthOf(pairs, asChosen));
  }
};

GONIO_TEST(SamplingPlanTest)
}  // namespace sampling_plan_test

#include "sampling_plan_test.moc"
