// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/unguided_selection.h"

#include <QTest>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "tests/support/test_program.h"

namespace unguided_selection_test {
using namespace gonio;
using namespace gonio::acquisition;

using Indices = std::vector<std::size_t>;

std::vector<std::uint32_t> cellsAboveHorizon(const HalfDifferenceGrid& grid) {
  std::vector<std::uint32_t> cells;
  for (std::size_t cell = 0; cell < grid.size(); ++cell)
    if (grid.nodeAboveHorizon(cell)) cells.push_back(std::uint32_t(cell));
  return cells;
}

bool distinct(const Indices& indices) { return std::set(indices.begin(), indices.end()).size() == indices.size(); }

class UnguidedSelectionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void randomIsDistinctAndSeeded() {
    const Indices one = randomIndices(1000, 50, 1);
    QCOMPARE(one.size(), std::size_t(50));
    QVERIFY(distinct(one) && *std::max_element(one.begin(), one.end()) < 1000);
    QVERIFY(randomIndices(1000, 50, 1) == one);
    QVERIFY(randomIndices(1000, 50, 2) != one);
    Indices all = randomIndices(20, 100, 3);
    std::sort(all.begin(), all.end());
    Indices expected(20);
    std::iota(expected.begin(), expected.end(), std::size_t(0));
    QVERIFY(all == expected);
  }

  /// How often each index comes first, over many seeds: within five standard deviations.
  void randomIsEven() {
    std::array<int, 10> counts{};
    for (std::uint64_t seed = 0; seed < 10000; ++seed) ++counts[randomIndices(10, 1, seed)[0]];
    for (const int count : counts) QVERIFY(std::abs(count - 1000) < 5 * std::sqrt(900.0));
  }

  /// The fraction of the samples in any slab of an axis is the slab's fraction of the measure, far closer than chance
  /// has it.
  void spreadFollowsTheMeasure() {
    const HalfDifferenceGrid grid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 60};
    const auto cells = cellsAboveHorizon(grid);
    constexpr std::size_t samples = 400;
    const Indices chosen = evenlySpreadIndices(grid, cells, samples);
    QCOMPARE(chosen.size(), samples);
    QVERIFY(distinct(chosen));
    const auto coordinate = [&](std::size_t index, int axis) {
      const auto cell = int(cells[index]);
      return axis == 0 ? cell / 1800 : axis == 1 ? cell / 60 % 30 : cell % 60;
    };
    double total = 0;
    for (const std::uint32_t cell : cells) total += grid.cellMeasure(cell);
    for (const int axis : {0, 1, 2}) {
      std::map<int, double> measure, found;
      for (std::size_t i = 0; i < cells.size(); ++i) measure[coordinate(i, axis)] += grid.cellMeasure(cells[i]) / total;
      for (const std::size_t i : chosen) found[coordinate(i, axis)] += 1.0 / samples;
      double expected = 0, seen = 0;
      for (const auto& [at, fraction] : measure) {
        expected += fraction;
        seen += found[at];
        // By chance 0.025 is one standard deviation in the middle.
        QVERIFY2(std::abs(seen - expected) < 0.02, qPrintable(QString::number(seen - expected)));
      }
    }
  }

  void moreSamplesBeginTheSame() {
    const HalfDifferenceGrid grid{.thetaHCount = 10, .thetaDCount = 8, .phiDCount = 6};
    const auto cells = cellsAboveHorizon(grid);
    const Indices few = evenlySpreadIndices(grid, cells, 10);
    Indices more = evenlySpreadIndices(grid, cells, 60);
    QVERIFY(distinct(more));
    more.resize(10);
    QVERIFY(more == few);
    QCOMPARE(evenlySpreadIndices(grid, cells, 10000).size(), cells.size());
    QVERIFY(distinct(evenlySpreadIndices(grid, cells, 10000)));
  }
};

GONIO_TEST(UnguidedSelectionTest)
}  // namespace unguided_selection_test

#include "unguided_selection_test.moc"
