// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/grid_directions.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/test_program.h"

namespace grid_directions_test {
using namespace gonio;

class GridDirectionsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sameBitsAsTheGrid() {
    for (const HalfDifferenceGrid& grid : {HalfDifferenceGrid{}, HalfDifferenceGrid{31, 17, 44, false}}) {
      const GridDirections directions(grid);
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const GridDirections::Node node = directions.at(i);
        DirectionPair expected = grid.directions(i);
        QVERIFY(node.aboveHorizon == grid.nodeAboveHorizon(i));
        if (node.aboveHorizon) {
          expected.wi.z = std::max(0.0, expected.wi.z);
          expected.wo.z = std::max(0.0, expected.wo.z);
        }
        QVERIFY(node.pair.wi == expected.wi && node.pair.wo == expected.wo);
      }
    }
  }

  /// One point in each cell, in each sixteenth of the cells along an axis equally often, never at a node.
  void pointsAreSpreadOverTheirCells() {
    for (const HalfDifferenceGrid& grid : {HalfDifferenceGrid{}, HalfDifferenceGrid{31, 17, 44, false}}) {
      const GridDirections directions(grid, GridPoints::scattered);
      std::array<std::array<double, 16>, 3> counts{};
      for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const GridDirections::Node node = directions.at(cell);
        const auto at = grid.position(toHalfDifference(node.pair.wi, node.pair.wo));
        const auto row = cell / std::size_t(grid.phiDCount);
        const int k = int(cell) % grid.phiDCount, j = int(row) % grid.thetaDCount, i = int(row) / grid.thetaDCount;
        // phi_d is the position less that of the node, in steps from -1/2 to 1/2.
        const double phi = std::remainder(at.phiD - k, grid.phiDCount);
        QVERIFY(std::abs(phi) < 0.5);
        ++counts[2][std::size_t((phi + 0.5) * 16)];
        const auto count = [&](std::size_t axis, double position, int index, int steps) {
          const double low = std::max(0.0, index - 0.5), high = index + 1 == steps ? steps : index + 0.5;
          QVERIFY(position > low && position < high);
          ++counts[axis][std::size_t((position - low) / (high - low) * 16)];
        };
        count(0, at.thetaH, i, grid.thetaHCount);
        count(1, at.thetaD, j, grid.thetaDCount);
      }
      for (const auto& axis : counts)
        for (const double number : axis)
          QVERIFY(std::abs(number / (double(grid.size()) / 16) - 1) < (grid.size() > 1'000'000 ? 0.001 : 0.05));
    }
  }

  void pointsMirrorEachOther() {
    const HalfDifferenceGrid grid{9, 8, 20, false};
    const GridDirections directions(grid, GridPoints::scattered);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      const std::size_t k = cell % 20;
      if (k == 0 || k == 10) continue;
      const DirectionPair one = directions.at(cell).pair, other = directions.at(cell - k + 20 - k).pair;
      QVERIFY(glm::length(one.wi - Direction(other.wi.x, -other.wi.y, other.wi.z)) < 1e-12);
      QVERIFY(glm::length(one.wo - Direction(other.wo.x, -other.wo.y, other.wo.z)) < 1e-12);
    }
  }
};

GONIO_TEST(GridDirectionsTest)
}  // namespace grid_directions_test

#include "grid_directions_test.moc"
