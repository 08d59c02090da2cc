// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference_grid.h"

#include <QTest>

#include "tests/support/test_program.h"

namespace half_difference_grid_test {
using namespace gonio;

class HalfDifferenceGridTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hardCase11ValidCells() {
    const HalfDifferenceGrid grid;
    std::size_t above = 0, within85 = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      above += grid.nodeAboveHorizon(i);
      within85 += grid.nodeWithin(i, radians(85));
    }
    QCOMPARE(above, std::size_t(1111432));
    QCOMPARE(within85, std::size_t(1015451));
  }

  void cellCentresFindTheirCell() {
    for (const bool reciprocal : {true, false}) {
      const HalfDifferenceGrid grid{.phiDCount = reciprocal ? 180 : 360, .reciprocal = reciprocal};
      for (int i = 0; i < 90; ++i)
        for (int j = 0; j < 90; ++j)
          for (int k = 0; k < grid.phiDCount; k += 7) {
            const double h = (i + 0.5) / 90;
            const HalfDifference at{h * h * halfPi, radians(j + 0.5), radians(k + 0.5), true};
            QCOMPARE(grid.cellIndex(at), grid.index(i, j, k));
          }
    }
  }

  void nodesKeepTheirPosition() {
    const HalfDifferenceGrid grid;
    const auto p = grid.position(grid.node(grid.index(17, 33, 121)));
    QVERIFY(std::abs(p.thetaH - 17) < 1e-12 && std::abs(p.thetaD - 33) < 1e-12 && std::abs(p.phiD - 121) < 1e-12);
  }

  /// The measures of all cells add up to the closed integral over theta_h, theta_d and phi_d in their full ranges.
  void cellMeasuresAddUp() {
    const HalfDifferenceGrid grid;
    double sum = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) sum += grid.cellMeasure(i);
    // The last node of each theta axis ends half a cell before 90 degrees.
    const double lastH = (89.5 / 90) * (89.5 / 90) * halfPi, lastD = radians(89.5);
    const double expected = (1 - std::cos(lastH)) * 2 * std::sin(lastD) * std::sin(lastD) * pi;
    QVERIFY(std::abs(sum / expected - 1) < 1e-12);
  }
};

GONIO_TEST(HalfDifferenceGridTest)
}  // namespace half_difference_grid_test

#include "half_difference_grid_test.moc"
