// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/fast_functions.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/test_program.h"

namespace fast_exp_test {
using namespace gonio;

class FastExpTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Against the library in extended precision.
  void isTheExponentialOverItsWholeRange() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> wide(-708, 709), narrow(-1, 1);
    for (int n = 0; n < 300000; ++n)
      for (const double x : {wide(random), narrow(random), 1e-9 * narrow(random)}) {
        const long double exact = std::exp(static_cast<long double>(x));
        QVERIFY2(std::abs(double((fastExp(x) - exact) / exact)) < 5e-16, qPrintable(QString::number(x, 'g', 17)));
      }
  }

  /// Against the library in extended precision.
  void minusOneHasNoCancellation() {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> wide(-708, 708), narrow(-1, 1);
    for (int n = 0; n < 300000; ++n)
      for (const double x : {wide(random), narrow(random), 1e-9 * narrow(random)}) {
        const long double exact = std::expm1(static_cast<long double>(x));
        QVERIFY2(std::abs(double((fastExpm1(x) - exact) / exact)) < 2e-15, qPrintable(QString::number(x, 'g', 17)));
      }
    QCOMPARE(fastExpm1(0), 0.0);
  }

  void valuesAtZeroAndAtTheEnds() {
    QCOMPARE(fastExp(0), 1.0);
    QVERIFY(fastExp(-708) > 0);
    for (const double x : {-708.1, -1e4, -std::numeric_limits<double>::infinity()}) QCOMPARE(fastExp(x), 0.0);
  }
};

GONIO_TEST(FastExpTest)
}  // namespace fast_exp_test

#include "fast_exp_test.moc"
