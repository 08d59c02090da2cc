// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_brdf.h"

#include <QTest>

#include "tests/support/test_program.h"

namespace statistics_test {
using namespace gonio;

class StatisticsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void rangesOfAHandMadeTable() {
    const HalfDifferenceGrid grid{2, 2, 2, true};
    std::vector<TabulatedBrdf::Value> values(grid.size(), TabulatedBrdf::Value(0.5f, 0.25f, 2));
    std::vector<std::uint8_t> valid(grid.size(), 1);
    values[1] = {0, 0.125f, 64};
    values[2] = {1000, 1000, 1000};
    valid[2] = valid[3] = 0;
    const TableStatistics s = tableStatistics(TabulatedBrdf(grid, values, valid));
    QVERIFY(s.channels[0].min == 0 && s.channels[0].max == 0.5);
    QVERIFY(s.channels[1].min == 0.125 && s.channels[1].max == 0.25);
    QVERIFY(s.channels[2].min == 2 && s.channels[2].max == 64);
    QCOMPARE(s.invalidFraction, 0.25);
    QCOMPARE(s.dynamicRange, 512.0);
  }

  void hardCase12AllZeroChannels() {
    const HalfDifferenceGrid grid{2, 2, 2, true};
    const std::vector<TabulatedBrdf::Value> black(grid.size(), TabulatedBrdf::Value(0));
    const std::vector<TabulatedBrdf::Value> red(grid.size(), TabulatedBrdf::Value(2, 0, 0));
    const std::vector<std::uint8_t> valid(grid.size(), 1), invalid(grid.size(), 0);
    QCOMPARE(tableStatistics(TabulatedBrdf(grid, black, valid)).dynamicRange, 0.0);
    QCOMPARE(tableStatistics(TabulatedBrdf(grid, red, valid)).dynamicRange, 1.0);
    QCOMPARE(tableStatistics(TabulatedBrdf(grid, red, valid)).channels[1].max, 0.0);
    const TableStatistics none = tableStatistics(TabulatedBrdf(grid, red, invalid));
    QVERIFY(none.invalidFraction == 1 && none.dynamicRange == 0 && none.channels[0].min == 0 &&
            none.channels[0].max == 0);
  }
};

GONIO_TEST(StatisticsTest)
}  // namespace statistics_test

#include "statistics_test.moc"
