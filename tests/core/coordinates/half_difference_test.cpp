// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace half_difference_test {
using namespace gonio;
using test::randomUpper;
using test::rotateZ;

double angleBetween(const Direction& a, const Direction& b) {
  return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}
class HalfDifferenceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// wi, wo to coordinates and back give the pair rotated by -phi_h.
  void roundTripAtRandomPairs() {
    std::mt19937_64 random(1);
    for (int n = 0; n < 100000; ++n) {
      const Direction wi = randomUpper(random), wo = randomUpper(random);
      const HalfDifference c = toHalfDifference(wi, wo);
      QVERIFY(c.valid);
      const DirectionPair back = fromHalfDifference(c.thetaH, c.thetaD, c.phiD);
      const double phiH = azimuth(wi + wo);
      QVERIFY(glm::length(rotateZ(back.wi, phiH) - wi) < 1e-12);
      QVERIFY(glm::length(rotateZ(back.wo, phiH) - wo) < 1e-12);
    }
  }

  void exchangeOfDirectionsAddsPi() {
    std::mt19937_64 random(2);
    for (int n = 0; n < 10000; ++n) {
      const Direction wi = randomUpper(random), wo = randomUpper(random);
      const HalfDifference a = toHalfDifference(wi, wo), b = toHalfDifference(wo, wi);
      QCOMPARE(a.thetaH, b.thetaH);
      QCOMPARE(a.thetaD, b.thetaD);
      QVERIFY(std::abs(std::remainder(a.phiD - b.phiD - pi, 2 * pi)) < 1e-9);
      const double difference = foldPhiD(a.phiD) - foldPhiD(b.phiD);
      QVERIFY(std::abs(std::remainder(difference, pi)) < 1e-9);
    }
  }

  void foldStaysInsideHalfOpenInterval() {
    for (double phi : {-pi, -1e-300, -1e-17, 0.0, -0.0, 1.0, pi, std::nextafter(pi, 0.0)}) {
      QVERIFY(foldPhiD(phi) >= 0);
      QVERIFY(foldPhiD(phi) < pi);
    }
  }

  void hardCase3RetroReflection() {
    std::mt19937_64 random(3);
    for (int n = 0; n < 1000; ++n) {
      const Direction wi = randomUpper(random);
      const HalfDifference c = toHalfDifference(wi, wi);
      QVERIFY(c.valid);
      QVERIFY(c.thetaD == 0 && c.phiD == 0);
      QVERIFY(std::abs(c.thetaH - polarAngle(wi)) < 1e-14);
      const Direction near = glm::normalize(wi + Direction(1e-9, 0, 0));
      QVERIFY(std::abs(toHalfDifference(wi, near).thetaD - angleBetween(wi, near) / 2) < 1e-15);
    }
  }

  void hardCase4OppositeHorizontalDirections() {
    QVERIFY(!toHalfDifference({1, 0, 0}, {-1, 0, 0}).valid);
    QVERIFY(!toHalfDifference(fromSpherical(halfPi, 0.3), -fromSpherical(halfPi, 0.3)).valid);
  }

  void hardCase5HalfVectorAtThePole() {
    for (double theta : {0.0, 1e-9, 0.3, 1.0, 1.5, 1.57})
      for (double phi : {0.0, 0.5, 1.5707963, 2.5, -3.0}) {
        const Direction wi = fromSpherical(theta, phi), wo = {-wi.x, -wi.y, wi.z};
        const HalfDifference a = toHalfDifference(wi, wo), b = toHalfDifference(wo, wi);
        QVERIFY(a.valid && std::isfinite(a.phiD));
        QVERIFY(a.thetaH < 1e-12);
        QVERIFY(std::abs(a.thetaD - theta) < 1e-12);
        QVERIFY(std::abs(std::remainder(foldPhiD(a.phiD) - foldPhiD(b.phiD), pi)) < pi / 180);
      }
  }
};

GONIO_TEST(HalfDifferenceTest)
}  // namespace half_difference_test

#include "half_difference_test.moc"
