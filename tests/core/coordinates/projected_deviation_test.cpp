// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/projected_deviation.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/math/quadrature.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace projected_deviation_test {
using namespace gonio;
using test::randomUpper;
using test::rotateZ;

/// Coordinates and back, turned to the viewer's azimuth. Near the horizon z loses half of the digits of the disk.
bool roundTrips(const Direction& wi, const Direction& wo) {
  const ProjectedDirections back = fromProjectedDeviation(toProjectedDeviation(wi, wo));
  const double phi = azimuth(wo);
  const glm::dvec2 light(rotateZ(back.pair.wi, phi) - wi), viewer(rotateZ(back.pair.wo, phi) - wo);
  const double z = back.pair.wi.z - wi.z;
  return back.valid && glm::length(light) < 1e-12 && glm::length(viewer) < 1e-12 &&
         std::abs(z) * std::max(std::abs(wi.z), std::abs(z)) < 1e-12 && std::abs(back.pair.wo.z - wo.z) < 1e-12;
}

class ProjectedDeviationTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void roundTripAtRandomPairs() {
    std::mt19937_64 random(1);
    for (int n = 0; n < 100000; ++n) QVERIFY(roundTrips(randomUpper(random), randomUpper(random)));
  }

  void hardCase08RoundTripAtSingularAzimuths() {
    for (const double phiI : {0.0, halfPi, -halfPi, pi, -pi})
      for (const double phiO : {0.0, halfPi, -halfPi, pi, -pi})
        for (const double thetaI : {0.0, 1e-9, 0.7, halfPi - 1e-9, halfPi})
          for (const double thetaO : {0.0, 1e-9, 0.7, halfPi - 1e-9, halfPi})
            QVERIFY(roundTrips(fromSpherical(thetaI, phiI), fromSpherical(thetaO, phiO)));
  }

  void meaningOfTheAzimuth() {
    const Direction wo = fromSpherical(0.8, 0);
    const double s = std::sin(0.8);
    const ProjectedDeviation mirror = toProjectedDeviation({-wo.x, -wo.y, wo.z}, wo);
    QVERIFY(mirror.deviation < 1e-15 && std::abs(mirror.thetaR - 0.8) < 1e-15);
    const ProjectedDeviation retro = toProjectedDeviation(wo, wo);
    QVERIFY(std::abs(retro.deviation - 2 * s) < 1e-15 && retro.phi == 0);
    const ProjectedDeviation normal = toProjectedDeviation({0, 0, 1}, wo);
    QVERIFY(std::abs(normal.deviation - s) < 1e-15 && normal.phi == 0);
    const ProjectedDeviation behind = toProjectedDeviation({-1, 0, 0}, wo);
    QVERIFY(std::abs(behind.deviation - (1 - s)) < 1e-15 && behind.phi == pi);
  }

  /// |Dp| is that of the exchanged pair.
  void reciprocalDeviation() {
    std::mt19937_64 random(2);
    for (int n = 0; n < 10000; ++n) {
      const Direction wi = randomUpper(random), wo = randomUpper(random);
      QVERIFY(std::abs(toProjectedDeviation(wi, wo).deviation - toProjectedDeviation(wo, wi).deviation) < 1e-15);
    }
  }

  /// The viewer along the normal: phi is an azimuth of its own, the other two do not change with it.
  void hardCase06ViewerAlongTheNormal() {
    for (double phi = -3; phi <= 3; phi += 0.25) {
      const ProjectedDeviation c = toProjectedDeviation(fromSpherical(0.6, phi), {0, 0, 1});
      QVERIFY(c.thetaR == 0 && std::abs(c.deviation - std::sin(0.6)) < 1e-15 && std::abs(c.phi - phi) < 1e-14);
    }
  }

  void hardCase07MirrorPairsHaveAzimuthZero() {
    QCOMPARE(toProjectedDeviation({0, 0, 1}, {0, 0, 1}).phi, 0.0);
    const Direction wo(0.6, 0, 0.8);
    QCOMPARE(toProjectedDeviation({-0.6, 0, 0.8}, wo).phi, 0.0);
    QVERIFY(fromProjectedDeviation({0.9, 0, 0.4}).valid);
  }

  void hardCase09OutsideOfTheDisk() {
    const auto rim = [](double outside) {
      return fromProjectedDeviation({.thetaR = 0.5, .deviation = 1 - std::sin(0.5) + outside, .phi = pi});
    };
    for (const double outside : {0.0, 1e-15, 5e-13}) {
      QVERIFY(rim(outside).valid);
      QVERIFY(rim(outside).pair.wi.z < 2e-8 && rim(outside).pair.wi.z >= 0);
    }
    QVERIFY(!rim(1e-11).valid);
    QVERIFY(!rim(0.1).valid);
    QVERIFY(std::isfinite(rim(0.1).pair.wi.z) && std::isfinite(rim(2).pair.wi.x));
  }

  /// Never NaN, never rising, pi up to 1 - s, and at the limit the point is on the rim.
  void hardCase10AzimuthLimit() {
    for (const double s : {0.0, 1e-300, 1e-16, 1e-8, 0.3, 0.9, 1 - 1e-16, 1.0}) {
      double last = pi;
      for (int n = 0; n <= 4000; ++n) {
        const double d = n * (2.0 / 4000), limit = azimuthLimit(d, s);
        QVERIFY(limit >= 0 && limit <= last);
        last = limit;
        if (d <= 1 - s) QCOMPARE(limit, pi);
        if (limit > 0 && limit < pi) {
          const double x = d * std::cos(limit) - s, y = d * std::sin(limit);
          QVERIFY(std::abs(std::hypot(x, y) - 1) < 1e-12);
        }
      }
      for (const double edge : {1 - s, 1 + s})
        for (const double offset : {-1e-15, 0.0, 1e-15}) QVERIFY(azimuthLimit(edge + offset, s) >= 0);
      QCOMPARE(azimuthLimit(1 + s + 1e-15, s), 0.0);
    }
  }

  /// The disk has the area pi in these coordinates, seen from any mirror direction; its directions 2 pi sr.
  void measureOfTheDisk() {
    for (const double thetaR : {0.0, 0.3, 1.0, 1.5}) {
      const double s = std::sin(thetaR);
      double area = 0;
      for (const auto& [low, high] : {std::pair(0.0, 1 - s), std::pair(1 - s, 1 + s)}) {
        // d = middle - half cos t: the square roots at both ends of the range of partial circles become smooth.
        const double middle = (low + high) / 2, half = (high - low) / 2;
        area += gaussLegendre(60, 0, pi).integrate([&](double t) {
          const double d = middle - half * std::cos(t);
          return d * 2 * azimuthLimit(d, s) * half * std::sin(t);
        });
      }
      QVERIFY(std::abs(area - pi) < 1e-6);
    }
  }

  /// The measure is the Jacobian: differences of the direction over small steps of the coordinates.
  void measureIsTheJacobian() {
    std::mt19937_64 random(4);
    for (int n = 0; n < 1000; ++n) {
      const ProjectedDeviation c = toProjectedDeviation(randomUpper(random), randomUpper(random));
      const double step = 1e-5;
      const auto at = [&](double d, double phi) { return fromProjectedDeviation({c.thetaR, d, phi}); };
      const ProjectedDirections centre = at(c.deviation, c.phi);
      if (centre.pair.wi.z < 0.05 || c.deviation < 0.01) continue;
      const Direction alongD =
          (at(c.deviation + step, c.phi).pair.wi - at(c.deviation - step, c.phi).pair.wi) / (2 * step);
      const Direction alongPhi =
          (at(c.deviation, c.phi + step).pair.wi - at(c.deviation, c.phi - step).pair.wi) / (2 * step);
      const double expected = glm::length(glm::cross(alongD, alongPhi));
      const double measure = c.deviation / centre.pair.wi.z;
      QVERIFY(std::abs(measure - expected) < 1e-4 * expected);
    }
  }
};

GONIO_TEST(ProjectedDeviationTest)
}  // namespace projected_deviation_test

#include "projected_deviation_test.moc"
