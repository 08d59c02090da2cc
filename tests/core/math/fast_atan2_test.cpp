// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/fast_functions.h"

#include <QTest>
#include <limits>
#include <random>

#include "tests/support/test_program.h"

namespace fast_atan2_test {
using namespace gonio;

class FastAtan2Test : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithTheLibraryAllAround() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-30, 3), angle(-std::numbers::pi, std::numbers::pi);
    for (int n = 0; n < 1000000; ++n) {
      const double r = std::pow(10, exponent(random)), a = angle(random);
      const double y = r * std::sin(a), x = r * std::cos(a);
      QVERIFY(std::abs(fastAtan2(y, x) - std::atan2(y, x)) < 1e-15);
    }
  }

  void smallAnglesKeepTheirDigits() {
    for (double y = 1e-30; y < 0.3; y *= 1.37) {
      QVERIFY(std::abs(fastAtan2(y, 1) / std::atan2(y, 1) - 1) < 5e-16);
      QVERIFY(std::abs(fastAtan2(-y, 1) / std::atan2(-y, 1) - 1) < 5e-16);
    }
  }

  void axesAndDiagonals() {
    constexpr double pi = std::numbers::pi;
    QCOMPARE(fastAtan2(0, 1), 0.0);
    QCOMPARE(fastAtan2(1, 0), pi / 2);
    QCOMPARE(fastAtan2(-1, 0), -pi / 2);
    QCOMPARE(fastAtan2(0, -1), pi);
    QCOMPARE(fastAtan2(-0.0, -1), -pi);
    QCOMPARE(fastAtan2(0, 0), 0.0);
    QCOMPARE(fastAtan2(2, 2), pi / 4);
    QCOMPARE(fastAtan2(-3, -3), -3 * pi / 4);
  }
};

GONIO_TEST(FastAtan2Test)
}  // namespace fast_atan2_test

#include "fast_atan2_test.moc"
