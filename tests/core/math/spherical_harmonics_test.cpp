// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/special_functions.h"

#include <QTest>
#include <cmath>
#include <vector>

#include "core/math/quadrature.h"
#include "tests/support/test_program.h"

namespace spherical_harmonics_test {
using namespace gonio;

class SphericalHarmonicsTest : public QObject {
  Q_OBJECT
 private:
  static std::vector<double> at(int bands, double z) {
    std::vector<double> q(harmonicCount(bands));
    normalisedLegendre(bands, z, q);
    return q;
  }

 private Q_SLOTS:
  void theIndexCountsUp() {
    std::size_t expected = 0;
    for (int m = 0; m < 7; ++m)
      for (int l = m; l < 7; ++l) QCOMPARE(harmonicIndex(7, l, m), expected++);
    QCOMPARE(harmonicCount(7), expected);
  }

  /// Over z with weight (1 - z^2)^m and the 2 pi of the azimuth: the harmonics of one order are orthonormal.
  void orthonormal() {
    constexpr int bands = 31;
    const QuadratureRule rule = gaussLegendre(64);
    std::vector<std::vector<double>> values;
    for (const double z : rule.nodes) values.push_back(at(bands, z));
    for (int m = 0; m < bands; ++m)
      for (int a = m; a < bands; ++a)
        for (int b = m; b <= a; ++b) {
          double sum = 0;
          for (std::size_t i = 0; i < rule.nodes.size(); ++i)
            sum += rule.weights[i] * values[i][harmonicIndex(bands, a, m)] * values[i][harmonicIndex(bands, b, m)] *
                   std::pow((1 - rule.nodes[i]) * (1 + rule.nodes[i]), m);
          QVERIFY(std::abs(2 * M_PI * sum - (a == b ? 1 : 0)) < 1e-10);
        }
  }

  void closedForms() {
    for (const double z : {-1.0, -0.3, 0.0, 0.7, 1.0}) {
      const std::vector<double> q = at(3, z);
      const auto near = [](double value, double expected) { return std::abs(value - expected) < 1e-15; };
      QVERIFY(near(q[harmonicIndex(3, 0, 0)], std::sqrt(1 / (4 * M_PI))));
      QVERIFY(near(q[harmonicIndex(3, 1, 0)], std::sqrt(3 / (4 * M_PI)) * z));
      QVERIFY(near(q[harmonicIndex(3, 2, 0)], std::sqrt(5 / (16 * M_PI)) * (3 * z * z - 1)));
      QVERIFY(near(q[harmonicIndex(3, 1, 1)], std::sqrt(3 / (8 * M_PI))));
      QVERIFY(near(q[harmonicIndex(3, 2, 1)], std::sqrt(15 / (8 * M_PI)) * z));
      QVERIFY(near(q[harmonicIndex(3, 2, 2)], std::sqrt(15 / (32 * M_PI))));
    }
  }
};

GONIO_TEST(SphericalHarmonicsTest)
}  // namespace spherical_harmonics_test

#include "spherical_harmonics_test.moc"
