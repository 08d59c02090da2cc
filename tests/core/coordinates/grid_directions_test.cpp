// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/grid_directions.h"

#include <QTest>
#include <algorithm>

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
};

GONIO_TEST(GridDirectionsTest)
}  // namespace grid_directions_test

#include "grid_directions_test.moc"
