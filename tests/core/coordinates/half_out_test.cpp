// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_out.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace half_out_test {
using namespace gonio;
using test::randomUpper;
using test::rotateZ;

bool roundTrips(const Direction& wi, const Direction& wo) {
  const HalfOutDirections back = fromHalfOut(toHalfOut(wi, wo));
  const double phi = wo.x == 0 && wo.y == 0 ? azimuth(wi) : azimuth(wo);
  return back.valid && glm::length(rotateZ(back.pair.wi, phi) - wi) < 1e-12 &&
         glm::length(rotateZ(back.pair.wo, phi) - wo) < 1e-12;
}

class HalfOutTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void roundTripAtRandomPairs() {
    std::mt19937_64 random(1);
    for (int n = 0; n < 100000; ++n) QVERIFY(roundTrips(randomUpper(random), randomUpper(random)));
  }

  void roundTripAtSingularPairs() {
    for (const double phiI : {0.0, halfPi, -halfPi, pi})
      for (const double phiO : {0.0, halfPi, -halfPi, pi})
        for (const double thetaI : {0.0, 1e-9, 0.7, halfPi - 1e-9})
          for (const double thetaO : {0.0, 1e-9, 0.7, halfPi - 1e-9})
            QVERIFY(roundTrips(fromSpherical(thetaI, phiI), fromSpherical(thetaO, phiO)));
  }

  void mirrorPairsHaveTheHalfVectorAtThePole() {
    const Direction wo = fromSpherical(0.8, 0.3);
    QVERIFY(toHalfOut({-wo.x, -wo.y, wo.z}, wo).thetaH < 1e-15);
    QCOMPARE(toHalfOut({0, 0, 1}, {0, 0, 1}).phiH, 0.0);
  }

  void oppositeDirectionsHaveNoHalfVector() {
    QVERIFY(!toHalfOut({1, 0, 0}, {-1, 0, 0}).valid);
    QVERIFY(!fromHalfOut({.valid = false}).valid);
  }

  void halfVectorsWithoutALightAreInvalid() {
    QVERIFY(!fromHalfOut({.thetaO = 1.2, .thetaH = 1.2, .phiH = pi}).valid);  // turned from the viewer
    QVERIFY(!fromHalfOut({.thetaO = 0.2, .thetaH = 1.2, .phiH = 0}).valid);   // light below the horizon
    QVERIFY(fromHalfOut({.thetaO = 0.2, .thetaH = 0.3, .phiH = 2}).valid);
  }

  void measureIsTheJacobian() {
    const Direction wo = fromSpherical(0.7, 0), half = fromSpherical(0.4, 1.1);
    constexpr double step = 1e-5;
    const auto light = [&](double thetaH, double phiH) {
      return fromHalfOut({.thetaO = 0.7, .thetaH = thetaH, .phiH = phiH}).pair.wi;
    };
    const Direction alongTheta = (light(0.4 + step, 1.1) - light(0.4 - step, 1.1)) / (2 * step);
    const Direction alongPhi = (light(0.4, 1.1 + step) - light(0.4, 1.1 - step)) / (2 * step);
    const double expected = glm::length(glm::cross(alongTheta, alongPhi)) / std::sin(0.4);
    QVERIFY(std::abs(halfOutJacobian(glm::dot(wo, half)) - expected) < 1e-8);
  }
};

GONIO_TEST(HalfOutTest)
}  // namespace half_out_test

#include "half_out_test.moc"
