// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <functional>

#include "core/coordinates/half_difference.h"
#include "core/coordinates/half_out.h"
#include "core/coordinates/projected_deviation.h"
#include "core/plots/plotted_values.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace plot_curves_test {
using namespace gonio;
using namespace gonio::plots;

constexpr double tolerance = 1e-12;

/// An 8 x 8 x 8 table, 0.5 where theta_h of the node is below 30 degrees, not measured elsewhere.
TabulatedBrdf partlyMeasured() {
  const HalfDifferenceGrid grid{8, 8, 8, true};
  std::vector<std::uint8_t> valid(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) valid[i] = grid.node(i).thetaH < radians(30);
  return TabulatedBrdf(grid, std::vector<TabulatedBrdf::Value>(grid.size(), glm::vec3(0.5f)), valid);
}

class PlotCurvesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Lambert: k_d / pi at every angle; times a cosine, that cosine.
  void lobeOfLambertIsTheCosine() {
    const auto brdf = test::lambert(Rgb(0.2, 0.5, 0.9));
    const double thetaI = radians(50);
    for (const auto cosine : {CosineFactor::none, CosineFactor::incident, CosineFactor::outgoing}) {
      const Curve curve = polarLobe(brdf, thetaI, cosine);
      QVERIFY(std::is_sorted(curve.angles.begin(), curve.angles.end()));
      QCOMPARE(curve.angles.front(), -curve.angles.back());
      for (std::size_t i = 0; i < curve.angles.size(); ++i) {
        const double factor = cosine == CosineFactor::none       ? 1
                              : cosine == CosineFactor::incident ? std::cos(thetaI)
                                                                 : std::cos(curve.angles[i]);
        QVERIFY(maxChannel(glm::abs(curve.points.values[i] - Rgb(0.2, 0.5, 0.9) / pi * factor)) < tolerance);
        QVERIFY(curve.points.states[i] == PointState::known);
      }
    }
  }

  /// theta_o = theta_i is the mirror: the half vector is the normal there, and nowhere else.
  void lobePeaksAtTheMirrorDirection() {
    const test::FunctionBrdf brdf(
        [](const Direction& wi, const Direction& wo) { return Rgb(std::pow(glm::normalize(wi + wo).z, 1e5)); });
    for (const double thetaI : {0.0, radians(37.3), radians(80)}) {
      const Curve curve = polarLobe(brdf, thetaI, CosineFactor::none);
      const auto peak = std::max_element(curve.points.values.begin(), curve.points.values.end(),
                                         [](const Rgb& a, const Rgb& b) { return a.x < b.x; });
      QVERIFY(peak->x > 0.98);
      QVERIFY(std::abs(curve.angles[std::size_t(peak - curve.points.values.begin())] - thetaI) < radians(0.2));
    }
  }

  /// A function that returns its own coordinates shows where a section lies.
  void sectionsLieWhereTheySay() {
    const test::FunctionBrdf coordinates([](const Direction& wi, const Direction& wo) {
      const HalfDifference at = toHalfDifference(wi, wo);
      return Rgb(at.thetaH, at.thetaD, foldPhiD(at.phiD));
    });
    const Section overH{.axis = SectionAxis::thetaH, .thetaD = 0.3, .phiD = 0.6};
    Curve curve = sectionCurve(coordinates, overH);
    for (std::size_t i = 1; i < curve.angles.size(); ++i) {
      if (curve.points.states[i] != PointState::known) continue;
      QVERIFY(maxChannel(glm::abs(curve.points.values[i] - Rgb(curve.angles[i], 0.3, 0.6))) < 1e-9);
    }
    const Section overD{.axis = SectionAxis::thetaD, .thetaH = 0.2, .phiD = 1.1};
    curve = sectionCurve(coordinates, overD);
    for (std::size_t i = 1; i < curve.angles.size(); ++i) {
      if (curve.points.states[i] != PointState::known) continue;
      QVERIFY(maxChannel(glm::abs(curve.points.values[i] - Rgb(0.2, curve.angles[i], 1.1))) < 1e-9);
    }
    // Out of the plane of incidence: the azimuths of light and viewer differ by 90 degrees.
    const test::FunctionBrdf product([](const Direction& wi, const Direction& wo) { return Rgb(glm::dot(wi, wo)); });
    curve = sectionCurve(product, {.axis = SectionAxis::thetaO, .thetaI = 0.4, .planeAzimuth = halfPi});
    for (std::size_t i = 0; i < curve.angles.size(); ++i)
      QVERIFY(std::abs(curve.points.values[i].x - std::cos(0.4) * std::cos(curve.angles[i])) < tolerance);
  }

  /// phi_d = 0: the directions meet the horizon at theta_h + theta_d = 90 degrees.
  void pointsBelowTheHorizonAreMarked() {
    const Curve curve =
        sectionCurve(test::lambert(Rgb(1)), {.axis = SectionAxis::thetaH, .thetaD = radians(30), .phiD = 0});
    for (std::size_t i = 0; i < curve.angles.size(); ++i) {
      const bool below = curve.angles[i] > radians(60);
      QCOMPARE(curve.points.states[i] == PointState::belowHorizon, below);
      QCOMPARE(std::isnan(curve.points.at(i, Channel::red)), below);
      QCOMPARE(curve.points.values[i].x, below ? 0 : 1 / pi);
    }
  }

  void valuesBetweenTheNodes() {
    Curve curve{{0, 1, 3, 4}, {{Rgb(1), Rgb(2, 4, 6), Rgb(0), Rgb(1)}, std::vector(4, PointState::known)}};
    QCOMPARE(valueAt(curve, 0.25, Channel::red), 1.25);
    QCOMPARE(valueAt(curve, 1, Channel::green), 4.0);
    QCOMPARE(valueAt(curve, 2, Channel::blue), 3.0);
    QVERIFY(std::isnan(valueAt(curve, -0.1, Channel::red)) && std::isnan(valueAt(curve, 4.1, Channel::red)));
    curve.points.states[2] = PointState::notMeasured;
    QVERIFY(std::isnan(valueAt(curve, 2, Channel::red)) && std::isnan(valueAt(curve, 3.5, Channel::red)));
    QCOMPARE(valueAt(curve, 1, Channel::red), 2.0);
  }

  void pointsThatWereNotMeasuredAreMarked() {
    const TabulatedBrdf table = partlyMeasured();
    // Nodes at theta_h = (i / 8)^2 90 degrees: the last valid one is i = 4 (22.5), interpolation reaches to i = 5
    // (35.2).
    const Section section{.axis = SectionAxis::thetaH, .thetaD = radians(20), .phiD = halfPi};
    const Curve curve = sectionCurve(table, section, &table);
    for (std::size_t i = 0; i < curve.angles.size(); ++i)
      QCOMPARE(curve.points.states[i] == PointState::known, curve.angles[i] < radians(90.0 * 25 / 64));
    // Without the coverage the table's 0 stands.
    QVERIFY(sectionCurve(table, section).points.states.back() == PointState::known);
  }

  void sliceOfAKnownFunction_data() {
    QTest::addColumn<int>("coordinates");
    QTest::addColumn<double>("azimuth");
    for (int coordinates = 0; coordinates < 3; ++coordinates)
      for (const double azimuth : {0.1, halfPi, 2.5})
        QTest::addRow("%s, %g", std::string(axesOf(SliceCoordinates(coordinates)).system).c_str(), azimuth)
            << coordinates << azimuth;
  }

  void sliceOfAKnownFunction() {
    QFETCH(int, coordinates);
    QFETCH(double, azimuth);
    // The coordinates by their own functions.
    const std::function<Rgb(const Direction&, const Direction&)> functions[] = {
        [](const Direction& wi, const Direction& wo) {
          const HalfDifference at = toHalfDifference(wi, wo);
          return Rgb(at.thetaH, at.thetaD, at.phiD);
        },
        [](const Direction& wi, const Direction& wo) {
          const HalfOut at = toHalfOut(wi, wo);
          return Rgb(at.thetaH, at.thetaO, at.phiH);
        },
        [](const Direction& wi, const Direction& wo) {
          const ProjectedDeviation at = toProjectedDeviation(wi, wo);
          return Rgb(at.deviation, at.thetaR, at.phi);
        }};
    const test::FunctionBrdf brdf(functions[coordinates]);
    for (const auto spacing : {ThetaHSpacing::linear, ThetaHSpacing::squareRoot}) {
      const Slice slice =
          sliceOf(brdf, SliceCoordinates(coordinates), azimuth, spacing, CosineFactor::none, nullptr, 30);
      int known = 0;
      for (int row = 0; row < slice.height; ++row)
        for (int column = 0; column < slice.width; ++column) {
          const double across = slice.across(column), up = slice.up(row);
          const std::size_t i = slice.index(column, row);
          if (coordinates == 0)
            QCOMPARE(slice.cells.states[i] == PointState::known, isAboveHorizon(across, up, azimuth));
          if (slice.cells.states[i] != PointState::known) continue;
          ++known;
          const Rgb& value = slice.cells.values[i];
          QVERIFY(std::abs(value.x - across) < 1e-9);
          QVERIFY(std::abs(value.y - up) < 1e-9);
          QVERIFY(std::abs(std::remainder(value.z - azimuth, 2 * pi)) < 1e-7);
        }
      QVERIFY(known > 100);
    }
  }

  void cosineOfASlice() {
    // At phi_d = 90 degrees cos theta_i = cos theta_h cos theta_d.
    const Slice slice = sliceOf(test::lambert(Rgb(pi)), SliceCoordinates::halfDifference, halfPi, ThetaHSpacing::linear,
                                CosineFactor::incident);
    const std::size_t i = slice.index(10, 70);
    QVERIFY(std::abs(slice.cells.values[i].x - std::cos(slice.across(10)) * std::cos(slice.up(70))) < tolerance);
  }

  void spacingOfTheSliceIsUndone() {
    for (const auto spacing : {ThetaHSpacing::linear, ThetaHSpacing::squareRoot})
      for (const double fraction : {0.0, 0.1, 0.7, 1.0})
        QVERIFY(std::abs(thetaHFraction(spacing, thetaHAt(spacing, fraction)) - fraction) < tolerance);
    QCOMPARE(thetaHAt(ThetaHSpacing::squareRoot, 0.5), halfPi / 4);
  }

  void albedoOfLambertIsItsReflectance() {
    const Rgb albedo(0.2, 0.5, 0.9);
    const Curve curve = albedoCurve(test::lambert(albedo), 7, 256);
    QCOMPARE(curve.angles.front(), 0.0);
    QVERIFY(std::abs(curve.angles.back() - radians(89)) < tolerance);
    for (const Rgb& value : curve.points.values) QVERIFY(maxChannel(glm::abs(value - albedo)) < tolerance);
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_EXCEPTION_THROWN(albedoCurve(test::lambert(albedo), 7, 256, {stop.get_token(), {}}), Cancelled);
  }

  /// The mesh covers the hemisphere: the areas of its cells, by the corners' solid angles, sum to 2 pi.
  void lobeSurfaceCoversTheHemisphere() {
    const LobeSurface lobe = lobeSurface(test::lambert(Rgb(1)), radians(60), CosineFactor::outgoing);
    double solidAngle = 0;
    for (int ring = 0; ring + 1 < lobe.rings; ++ring)
      for (int sector = 0; sector < lobe.sectors; ++sector) {
        const Direction a = lobe.directions[lobe.index(ring, sector)],
                        b = lobe.directions[lobe.index(ring + 1, sector)];
        const Direction c = lobe.directions[lobe.index(ring, sector + 1)];
        double turn = azimuth(lobe.directions[lobe.index(ring + 1, sector + 1)]) - azimuth(b);
        if (turn < 0) turn += 2 * pi;
        solidAngle += (a.z - b.z) * turn;
        QVERIFY(c.z > 0);
      }
    QVERIFY(std::abs(solidAngle - 2 * pi) < 0.01);
    for (std::size_t i = 0; i < lobe.directions.size(); ++i)
      QVERIFY(std::abs(lobe.points.values[i].x - lobe.directions[i].z / pi) < tolerance);
  }
};

GONIO_TEST(PlotCurvesTest)
}  // namespace plot_curves_test

#include "plot_curves_test.moc"
