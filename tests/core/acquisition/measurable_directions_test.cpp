// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/measurable_directions.h"

#include <QTest>
#include <limits>

#include "core/coordinates/grid_directions.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace measurable_directions_test {
using namespace gonio;
using namespace gonio::acquisition;

DirectionPair pairAt(double thetaI, double thetaO, double azimuthDifference) {
  return {fromSpherical(radians(thetaI), radians(30 + azimuthDifference)), fromSpherical(radians(thetaO), radians(30))};
}

QString errorOf(const MeasurableDirections& limits) {
  try {
    limits.check();
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

class MeasurableDirectionsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The published count of cells of a MERL table that are not grazing.
  void hardCase11CellsWithin85Degrees() {
    const HalfDifferenceGrid grid;
    const GridDirections directions(grid);
    const MeasurableDirections limits;
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      const auto node = directions.at(cell);
      count += node.aboveHorizon && limits.allows(node.pair);
    }
    QCOMPARE(count, std::size_t(1015451));
  }

  void polarAngles() {
    const MeasurableDirections limits{.maxPolarAngle = radians(60)};
    QVERIFY(limits.allows(pairAt(60, 60, 180)));
    QVERIFY(limits.allows(pairAt(0, 60, 10)));
    QVERIFY(!limits.allows(pairAt(60.001, 0, 0)));
    QVERIFY(!limits.allows(pairAt(0, 60.001, 0)));
    const MeasurableDirections all{.maxPolarAngle = halfPi};
    QVERIFY(all.allows(pairAt(90, 90, 180)));
    QVERIFY(!all.allows(pairAt(91, 10, 0)));
    QVERIFY(!all.allows(pairAt(10, 91, 0)));
  }

  void separationOfTheArms() {
    const MeasurableDirections limits{.minSeparation = radians(10)};
    QVERIFY(!limits.allows(pairAt(40, 40, 0)));
    QVERIFY(!limits.allows(pairAt(40, 30.001, 0)));
    QVERIFY(limits.allows(pairAt(40, 30, 0)));
    QVERIFY(limits.allows(pairAt(5, 5, 180)));
    QVERIFY(!limits.allows(pairAt(4.999, 5, 180)));
    // At 60 degrees an azimuth of 10 degrees is less than 10 degrees of arc.
    QVERIFY(!limits.allows(pairAt(60, 60, 11)));
    QVERIFY(limits.allows(pairAt(60, 60, 12)));
  }

  /// A box with its faces, for each of the three angles.
  void boxes() {
    MeasurableDirections limits;
    limits.forbidden.push_back({.thetaI = {radians(20), radians(40)},
                                .thetaO = {radians(10), radians(30)},
                                .azimuthDifference = {radians(90), radians(120)}});
    for (const double thetaI : {19.9, 20.0, 30.0, 40.0, 40.1})
      for (const double thetaO : {9.9, 10.0, 20.0, 30.0, 30.1})
        for (const double azimuth : {89.9, 90.0, 100.0, 120.0, 120.1, -100.0, 260.0, 460.0}) {
          const double folded =
              azimuth < 0 ? -azimuth : (azimuth > 360 ? azimuth - 360 : (azimuth > 180 ? 360 - azimuth : azimuth));
          const bool inside =
              thetaI >= 20 && thetaI <= 40 && thetaO >= 10 && thetaO <= 30 && folded >= 90 && folded <= 120;
          QCOMPARE(limits.allows(pairAt(thetaI, thetaO, azimuth)), !inside);
        }
    limits.forbidden.push_back({.thetaI = {0, radians(5)}});
    QVERIFY(!limits.allows(pairAt(4, 50, 10)) && limits.allows(pairAt(6, 50, 10)));
    limits.forbidden.emplace_back();  // everything
    QVERIFY(!limits.allows(pairAt(6, 50, 10)));
  }

  /// A light at the normal can be turned to any azimuth.
  void atTheNormal() {
    MeasurableDirections limits;
    limits.forbidden.push_back({.thetaI = {0, radians(20)}, .azimuthDifference = {0, radians(179)}});
    QVERIFY(limits.allows({{0, 0, 1}, fromSpherical(1, 2)}));
    QVERIFY(!limits.allows(pairAt(0.1, 50, 10)));
    limits.forbidden.front().azimuthDifference.highest = pi;
    QVERIFY(!limits.allows({{0, 0, 1}, fromSpherical(1, 2)}));
  }

  void wrongLimitsAreErrors() {
    QVERIFY(errorOf({}).isEmpty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double angle : {-0.1, 1.6, nan})
      QVERIFY(errorOf({.maxPolarAngle = angle}).contains("maximum polar angle"));
    for (const double angle : {-0.1, 3.2, nan}) QVERIFY(errorOf({.minSeparation = angle}).contains("separation"));
    QCOMPARE(errorOf({.maxPolarAngle = radians(95)}), "the maximum polar angle is 95 degrees: expected 0 to 90");
    const auto withBox = [](const ForbiddenRegion& box) { return errorOf({.forbidden = {{.thetaI = {0, 0.1}}, box}}); };
    QVERIFY(withBox({}).isEmpty());
    QVERIFY(withBox({.thetaI = {1, 0.5}}).contains("light of forbidden region 2"));
    QVERIFY(withBox({.thetaO = {-1, 0.5}}).contains("viewer of forbidden region 2"));
    QVERIFY(withBox({.azimuthDifference = {0, 4}}).contains("azimuth difference of forbidden region 2"));
    QVERIFY(withBox({.azimuthDifference = {nan, 1}}).contains("azimuth difference of forbidden region 2"));
  }

  void comparison() {
    MeasurableDirections a, b;
    QVERIFY(a == b);
    b.forbidden.emplace_back();
    QVERIFY(!(a == b));
  }
};

GONIO_TEST(MeasurableDirectionsTest)
}  // namespace measurable_directions_test

#include "measurable_directions_test.moc"
