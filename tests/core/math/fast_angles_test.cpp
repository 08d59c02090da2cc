// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/fast_functions.h"

#include <QTest>
#include <limits>
#include <random>

#include "tests/support/test_program.h"

namespace fast_angles_test {
using namespace gonio;

class FastAnglesTest : public QObject {
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

  void sineAndCosineOfTurns() {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> angle(-2, 2);
    for (int n = 0; n < 1000000; ++n) {
      const double turns = angle(random);
      // The rest of the nearest turn is exact, and its product with pi in long double.
      const long double radians = 2 * std::numbers::pi_v<long double> * (turns - std::round(turns));
      const auto [sine, cosine] = fastSineAndCosine(turns);
      QVERIFY(std::abs(double(sine - std::sin(radians))) < 4e-16);
      QVERIFY(std::abs(double(cosine - std::cos(radians))) < 4e-16);
    }
  }

  void quarterTurnsAreExact() {
    for (int n = -8; n <= 8; ++n) {
      const auto [sine, cosine] = fastSineAndCosine(n / 4.0);
      const int q = ((n % 4) + 4) % 4;
      QCOMPARE(sine, q == 1 ? 1.0 : q == 3 ? -1.0 : 0.0);
      QCOMPARE(cosine, q == 0 ? 1.0 : q == 2 ? -1.0 : 0.0);
    }
  }
};

GONIO_TEST(FastAnglesTest)
}  // namespace fast_angles_test

#include "fast_angles_test.moc"
