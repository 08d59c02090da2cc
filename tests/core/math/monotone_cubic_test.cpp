// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/monotone_cubic.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/test_program.h"

namespace monotone_cubic_test {
using namespace gonio;

class MonotoneCubicTest : public QObject {
  Q_OBJECT
 private:
  static double at(const std::vector<double>& nodes, const std::vector<double>& values, double x) {
    return evaluateMonotoneCubic(nodes, values, monotoneSlopes(nodes, values), x);
  }

 private Q_SLOTS:
  void meetsThePointsAndHoldsTheEnds() {
    const std::vector<double> nodes{0, 0.1, 0.5, 2}, values{3, 1, 4, -1};
    for (std::size_t i = 0; i < nodes.size(); ++i) QVERIFY(std::abs(at(nodes, values, nodes[i]) - values[i]) < 1e-15);
    QCOMPARE(at(nodes, values, -5), 3.0);
    QCOMPARE(at(nodes, values, 7), -1.0);
  }

  /// Between two points the curve stays between their values: no overshoot at a step, a spike, or random points.
  void neverOvershoots() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 200; ++n) {
      std::vector<double> nodes{0}, values{uniform(random)};
      for (int i = 1; i < 8; ++i) {
        nodes.push_back(nodes.back() + 0.01 + uniform(random));
        values.push_back(i % 3 == 0 ? 1e6 * uniform(random) : uniform(random));
      }
      const std::vector<double> slopes = monotoneSlopes(nodes, values);
      for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        for (double t = 0; t <= 1; t += 0.05) {
          const double y = evaluateMonotoneCubic(nodes, values, slopes, nodes[i] + t * (nodes[i + 1] - nodes[i]));
          const auto [low, high] = std::minmax(values[i], values[i + 1]);
          QVERIFY(y >= low - 1e-9 * high && y <= high + 1e-9 * high);
        }
    }
  }

  void straightLinesStayStraight() {
    const std::vector<double> nodes{0, 0.3, 1, 1.1, 4};
    std::vector<double> values;
    for (const double x : nodes) values.push_back(2 - 3 * x);
    for (double x = 0; x <= 4; x += 0.1) QVERIFY(std::abs(at(nodes, values, x) - (2 - 3 * x)) < 1e-13);
    QVERIFY(std::abs(at({1, 3}, {5, 9}, 2) - 7) < 1e-15);
  }

  /// The error on a smooth monotone function falls with the third power of the distance, at least.
  void convergesOnSmoothFunctions() {
    const auto error = [](int count) {
      std::vector<double> nodes, values;
      for (int i = 0; i <= count; ++i) {
        nodes.push_back(double(i) / count);
        values.push_back(std::exp(-2 * nodes.back()));
      }
      double largest = 0;
      for (double x = 0.2; x < 0.8; x += 0.001)
        largest = std::max(largest, std::abs(at(nodes, values, x) - std::exp(-2 * x)));
      return largest;
    };
    QVERIFY(error(20) < error(10) / 6);
    QVERIFY(error(40) < 1e-5);
  }

  void oneNodeIsAConstant() { QCOMPARE(at({0}, {4}, 0.7), 4.0); }

  void placesAreFoundAtTheEndsToo() {
    const std::vector<double> nodes{0, 1, 2};
    QVERIFY(findInterval(nodes, 1).index == 1 && findInterval(nodes, 1).fraction == 0);
    QVERIFY(findInterval(nodes, 2).index == 1 && findInterval(nodes, 2).fraction == 1);
    QVERIFY(findInterval(nodes, std::nan("")).index == 0);
  }
};

GONIO_TEST(MonotoneCubicTest)
}  // namespace monotone_cubic_test

#include "monotone_cubic_test.moc"
