// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/fast_functions.h"

#include <QTest>
#include <random>

#include "tests/support/test_program.h"

namespace fast_roots_logs_test {
using namespace gonio;

/// Against the library in extended precision.
double relativeError(double value, long double exact) { return std::abs(double((value - exact) / exact)); }

class FastRootsLogsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void cubeRootsOfAllSizes() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-307, 308), mantissa(1, 9.9);
    for (int n = 0; n < 300000; ++n) {
      const double x = mantissa(random) * std::pow(10, exponent(random));
      if (!std::isfinite(x)) continue;
      QVERIFY(relativeError(fastCbrt(x), std::cbrt(static_cast<long double>(x))) < 5e-16);
      QCOMPARE(fastCbrt(-x), -fastCbrt(x));
    }
    const double subnormal = 3e-320;
    QVERIFY(relativeError(fastCbrt(subnormal), std::cbrt(static_cast<long double>(subnormal))) < 5e-16);
    QCOMPARE(fastCbrt(0), 0.0);
    QCOMPARE(fastCbrt(27), 3.0);
  }

  void logarithmsNearZeroAndFarAway() {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-300, 300), below(-0.9999, 0);
    for (int n = 0; n < 300000; ++n)
      for (const double x : {std::pow(10, exponent(random)), std::pow(10, exponent(random) / 100), below(random)})
        if (x != 0) QVERIFY(relativeError(fastLog1p(x), std::log1p(static_cast<long double>(x))) < 5e-16);
    for (int n = 0; n < 300000; ++n)
      for (const double x : {std::pow(10, exponent(random)), 1 + below(random)})
        if (x != 1) QVERIFY(relativeError(fastLog(x), std::log(static_cast<long double>(x))) < 5e-16);
    QCOMPARE(fastLog(1), 0.0);
    QCOMPARE(fastLog1p(0), 0.0);
    QCOMPARE(fastLog1p(1e-300), 1e-300);
  }
};

GONIO_TEST(FastRootsLogsTest)
}  // namespace fast_roots_logs_test

#include "fast_roots_logs_test.moc"
