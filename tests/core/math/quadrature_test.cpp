// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/quadrature.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/support/test_program.h"

namespace quadrature_test {
using namespace gonio;

class QuadratureTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void exactForPolynomialsUpToTwiceTheNodes() {
    for (const int n : {1, 2, 3, 8, 16, 64}) {
      const QuadratureRule rule = gaussLegendre(n, 0, 1);
      for (int degree = 0; degree < 2 * n; ++degree) {
        const double integral = rule.integrate([&](double x) { return std::pow(x, degree); });
        QVERIFY(std::abs(integral * (degree + 1) - 1) < 1e-13);
      }
    }
  }

  void nodesAscendInsideTheInterval() {
    for (const int n : {1, 5, 200}) {
      const QuadratureRule rule = gaussLegendre(n, -3, 7);
      QVERIFY(std::is_sorted(rule.nodes.begin(), rule.nodes.end()));
      QVERIFY(rule.nodes.front() > -3 && rule.nodes.back() < 7);
      QVERIFY(std::all_of(rule.weights.begin(), rule.weights.end(), [](double w) { return w > 0; }));
    }
  }

  void panelsResolveANarrowPeak() {
    const QuadratureRule rule = compositeGaussLegendre(16, 50, -1, 1);
    const double integral = rule.integrate([](double x) { return 1 / (1 + 1e4 * x * x); });
    QVERIFY(std::abs(integral / (2 * std::atan(100.0) / 100) - 1) < 1e-9);
  }
};

GONIO_TEST(QuadratureTest)
}  // namespace quadrature_test

#include "quadrature_test.moc"
