// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <limits>

#include "core/plots/plotted_values.h"
#include "core/plots/value_scale.h"
#include "tests/support/test_program.h"

namespace plot_numbers_test {
using namespace gonio;
using namespace gonio::plots;

class PlotNumbersTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nodesAscendAndAreDenseAboutTheCentre() {
    for (const double centre : {-5.0, -1.0, 0.3, 1.0}) {
      const std::vector<double> nodes = nodesAbout(centre, -1, 1, 200);
      QVERIFY(nodes.size() == 200 && nodes.front() == -1 && nodes.back() == 1);
      double nearest = 9, smallest = 9, largest = 0;
      std::size_t smallestAt = 0;
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        const double step = nodes[i] - nodes[i - 1];
        QVERIFY(step > 0);
        if (step < smallest) smallest = step, smallestAt = i;
        largest = std::max(largest, step);
        nearest = std::min(nearest, std::abs(nodes[i] - std::clamp(centre, -1.0, 1.0)));
      }
      QVERIFY(nearest <= smallest && std::abs(nodes[smallestAt] - std::clamp(centre, -1.0, 1.0)) <= 2 * smallest);
      QVERIFY(largest / smallest > 20 && largest / smallest < 31);
    }
  }

  void luminanceAndChannels() {
    const Rgb value(1, 2, 4);
    QCOMPARE(channelOf(Channel::green, value), 2.0);
    QCOMPARE(channelOf(Channel::blue, value), 4.0);
    QCOMPARE(channelOf(Channel::luminance, value), luminance(value));
    QCOMPARE(channelOf(Channel::luminance, Rgb(0.7)), 0.7);
  }

  void scalesShowAllValuesAndAreUndone() {
    const double values[] = {0, 0.02, 350, std::nan(""), std::numeric_limits<double>::infinity()};
    const ValueScale linear = scaleFor(values, false), logarithmic = scaleFor(values, true);
    QVERIFY(linear.min == 0 && linear.max > 350 && linear.max < 400);
    QVERIFY(std::abs(logarithmic.min - 0.01) < 1e-12 && std::abs(logarithmic.max - 1000) < 1e-9);
    for (const ValueScale& scale : {linear, logarithmic})
      for (const double fraction : {0.0, 0.25, 1.0})
        QVERIFY(std::abs(scale.fraction(scale.value(fraction)) - fraction) < 1e-12);
    QVERIFY(std::abs(logarithmic.fraction(1) - 0.4) < 1e-12);
    QCOMPARE(logarithmic.fraction(0), 0.0);
    QCOMPARE(logarithmic.fraction(-3), 0.0);
  }

  void scalesOfOddValues() {
    const double none[] = {0, -2, std::nan("")};
    // Of a hundred values the largest one is left out of 99 %, and of all of them none.
    std::vector<double> hundred;
    for (int i = 1; i <= 100; ++i) hundred.push_back(i);
    hundred.back() = 1e6;
    QCOMPARE(scaleFor(hundred, false, 8, 0.99).max, 99 * 1.05);
    QCOMPARE(scaleFor(hundred, false).max, 1e6 * 1.05);
    QCOMPARE(scaleFor(hundred, true, 8, 0.99).max, 100.0);
    QVERIFY(scaleFor(none, false).max == 1 && scaleFor(none, true).min == 0.1);
    const double wide[] = {1e-30, 1e6};
    QVERIFY(std::abs(std::log10(scaleFor(wide, true).min) + 2) < 1e-9);  // eight decades
    const double one[] = {10};
    const ValueScale single = scaleFor(one, true);
    QVERIFY(single.min < 10 && single.max >= 10 && single.min > 0);
  }

  void ticksAreRound() {
    const std::vector<double> linear = scaleTicks({false, 0, 0.33}, 4);
    QCOMPARE(linear.size(), std::size_t(3));
    QVERIFY(std::abs(linear[0] - 0.1) < 1e-12 && std::abs(linear[2] - 0.3) < 1e-12);
    const std::vector<double> powers = scaleTicks({true, 1e-3, 1e5}, 4);
    QVERIFY(powers.size() <= 5 && std::abs(powers.back() - 1e5) < 1e-6);
    for (std::size_t i = 1; i < powers.size(); ++i) QVERIFY(std::abs(powers[i] / powers[i - 1] - 100) < 1e-6);
  }

  /// A zigzag through the square [0, 1]^2, cut at its edges.
  void linesAreCutAtTheEdges() {
    const glm::dvec2 zigzag[] = {{-1, 0.5}, {1, 0.5}, {1, 2}, {0, 1}, {0, std::nan("")}, {0.2, 0.2}, {0.4, 0.4}};
    const auto parts = clipPolyline(zigzag, {0, 0}, {1, 1});
    const std::vector<std::vector<glm::dvec2>> expected{
        {{0, 0.5}, {1, 0.5}, {1, 1}}, {{0, 1}, {0, 1}}, {{0.2, 0.2}, {0.4, 0.4}}};
    QCOMPARE(parts.size(), expected.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      QCOMPARE(parts[i].size(), expected[i].size());
      for (std::size_t k = 0; k < parts[i].size(); ++k) QVERIFY(glm::length(parts[i][k] - expected[i][k]) < 1e-12);
    }
    const glm::dvec2 outside[] = {{-1, 0}, {0, 2.5}, {2, 1.5}};
    QVERIFY(clipPolyline(outside, {0, 0}, {1, 1}).empty());
    QVERIFY(clipPolyline({}, {0, 0}, {1, 1}).empty());
  }
};

GONIO_TEST(PlotNumbersTest)
}  // namespace plot_numbers_test

#include "plot_numbers_test.moc"
