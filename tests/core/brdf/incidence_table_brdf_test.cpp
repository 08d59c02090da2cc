// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/incidence_table_brdf.h"

#include <QTest>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "core/support/error.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace incidence_table_brdf_test {
using namespace gonio;
using namespace gonio::test;
using Axis = IncidenceTable::Axis;
using Function = std::function<double(double incident, double azimuth, double polar)>;

std::vector<double> steps(double first, double step, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(radians(first + step * i));
  return angles;
}

IncidenceTable tableOf(Axis axis, bool symmetric, const Function& function, std::vector<double> incident,
                       std::vector<double> azimuths, std::vector<double> polars) {
  IncidenceTable table{axis, symmetric, std::move(incident), std::move(azimuths), std::move(polars), {}};
  for (const double i : table.incident)
    for (const double a : table.azimuths)
      for (const double p : table.polars) {
        const auto value = float(function(i, a, p));
        table.values.emplace_back(value, 2 * value, 3 * value);
      }
  return table;
}

/// The direction at an angle from the mirror direction of a light at azimuth 0, by a turn about the y axis.
Direction aboutMirror(double thetaI, double azimuth, double polar) {
  const Direction up = fromSpherical(polar, azimuth);
  return {std::cos(thetaI) * up.x - std::sin(thetaI) * up.z, up.y, std::sin(thetaI) * up.x + std::cos(thetaI) * up.z};
}

double tent(double azimuth) { return azimuth < pi ? azimuth / pi : 2 - azimuth / pi; }

bool isClose(double a, double b) { return std::abs(a - b) < 2e-6 * (1 + std::abs(b)); }

std::string errorOf(IncidenceTable table) {
  try {
    const IncidenceTableBrdf brdf(std::move(table));
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

class IncidenceTableBrdfTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Linear in each coordinate and without an azimuth on the axis: exact between all nodes, also across the seam, which
  /// no node marks, and wherever the plane of incidence lies.
  void multilinearFunctionsAreExact() {
    const Function function = [](double i, double a, double p) { return (1 + 2 * i) * (1 + p * tent(a)); };
    for (const bool symmetric : {true, false}) {
      const IncidenceTableBrdf brdf(tableOf(Axis::mirror, symmetric, function, steps(10, 15, 3),
                                            symmetric ? steps(0, 45, 5) : steps(0, 45, 8), steps(0, 10, 4)));
      QVERIFY(brdf.isIsotropic() && !brdf.isReciprocal());
      std::mt19937_64 random(1);
      std::uniform_real_distribution<double> uniform(0, 1);
      for (int n = 0; n < 2000; ++n) {
        const double i = radians(10 + 30 * uniform(random)), a = 2 * pi * uniform(random),
                     p = radians(30) * uniform(random), turn = 2 * pi * uniform(random);
        const DirectionPair pair{rotateZ(fromSpherical(i, 0), turn), rotateZ(aboutMirror(i, a, p), turn)};
        const Rgb value = brdf.evaluate(pair.wi, pair.wo);
        QVERIFY(isClose(value.x, function(i, a, p)) && isClose(value.z, 3 * function(i, a, p)));
        QVERIFY(brdf.hasData(pair));
      }
    }
  }

  /// Several azimuths of the light, also across the seam: exact between all nodes of a function that is linear in them.
  void azimuthsOfTheLight() {
    const auto strength = [](double phi) { return 1 + tent(phi); };
    IncidenceTable table = tableOf(
        Axis::mirror, true, [](double i, double, double p) { return (1 + i) * (1 + p); }, steps(10, 15, 3),
        steps(0, 45, 5), steps(0, 10, 4));
    const std::vector<glm::vec3> one = table.values;
    table.values.clear();
    table.rotations = steps(0, 60, 6);
    for (const double phi : table.rotations)
      for (const glm::vec3& value : one) table.values.push_back(float(strength(phi)) * value);
    const IncidenceTableBrdf brdf(table);
    QVERIFY(!brdf.isIsotropic());
    for (int n = 0; n < 72; ++n) {
      const double phi = radians(5.0 * n), i = radians(20), p = radians(15);
      const DirectionPair pair{rotateZ(fromSpherical(i, 0), phi), rotateZ(aboutMirror(i, 1, p), phi)};
      QVERIFY(isClose(brdf.evaluate(pair.wi, pair.wo).x, strength(phi) * (1 + i) * (1 + p)));
      QVERIFY(brdf.hasData(pair));
    }
    table.rotations.pop_back();
    QCOMPARE(errorOf(table), std::string("found 360 values, expected 300"));
  }

  /// About the normal: exact at the angles of incidence of the table.
  void multilinearAboutTheNormal() {
    const Function function = [](double i, double a, double p) { return (1 + i) * (1 + p * tent(a)); };
    const IncidenceTableBrdf brdf(
        tableOf(Axis::normal, false, function, steps(0, 20, 4), steps(0, 30, 12), steps(0, 15, 6)));
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 500; ++n) {
      const double i = radians(20 * (n % 4)), a = 2 * pi * uniform(random), p = radians(75) * uniform(random);
      QVERIFY(isClose(brdf.evaluate(fromSpherical(i, 0), fromSpherical(p, a)).x, function(i, a, p)));
    }
  }

  /// A highlight between two angles of incidence stands at the mirror direction, as strong as under both.
  void highlightMovesWithTheLight() {
    const auto lobe = [](double fromMirror) { return std::exp(-0.5 * std::pow(fromMirror / radians(4), 2)); };
    const IncidenceTableBrdf mirror(tableOf(
        Axis::mirror, true, [&](double, double, double p) { return lobe(p); }, steps(0, 30, 3), steps(0, 90, 3),
        steps(0, 1, 91)));
    const IncidenceTableBrdf normal(tableOf(
        Axis::normal, false,
        [&](double i, double a, double p) {
          return lobe(std::acos(std::clamp(glm::dot(fromSpherical(p, a), fromSpherical(i, pi)), -1.0, 1.0)));
        },
        steps(0, 30, 3), steps(0, 2, 180), steps(0, 1, 91)));
    for (const double i : {7.0, 15.0, 42.5})
      for (const double off : {0.0, 3.0, 8.0}) {
        const Direction wi = fromSpherical(radians(i), 1), wo = fromSpherical(radians(i + off), 1 + pi);
        QVERIFY(std::abs(mirror.evaluate(wi, wo).x - lobe(radians(off))) < 0.01);
        QVERIFY(std::abs(normal.evaluate(wi, wo).x - lobe(radians(off))) < 0.02);
      }
  }

  /// What a file holds for directions below the horizon does not leak above it.
  void nodesBelowTheHorizonDoNotCount() {
    const IncidenceTableBrdf brdf(tableOf(
        Axis::mirror, true, [](double i, double a, double p) { return aboutMirror(i, a, p).z < -1e-9 ? 1e6 : 0.25; },
        steps(0, 20, 5), steps(0, 15, 13), steps(0, 10, 18)));
    std::mt19937_64 random(3);
    for (int n = 0; n < 5000; ++n) {
      const double value = brdf.evaluate(randomUpper(random), randomUpper(random)).x;
      QVERIFY2(isClose(value, 0.25) || value == 0, std::to_string(value).c_str());
    }
    QVERIFY(isClose(brdf.evaluate({0, 0, 1}, fromSpherical(radians(89), 2)).x, 0.25));
    QVERIFY(brdf.evaluate({0, 0, 1}, {0, 0.6, -0.8}) == Rgb(0));
  }

  void endsAreHeldAndUnknown() {
    const Function function = [](double i, double, double p) { return 1 + i + p; };
    const IncidenceTableBrdf brdf(
        tableOf(Axis::mirror, true, function, steps(10, 20, 2), steps(0, 180, 2), steps(5, 5, 3)));
    const auto at = [&](double i, double p) {
      return DirectionPair{fromSpherical(radians(i), 0), aboutMirror(radians(i), 0.3, radians(p))};
    };
    for (const auto& [i, p] : {std::pair(5.0, 10.0), {40.0, 10.0}, {20.0, 2.0}, {20.0, 30.0}}) {
      const double held = function(radians(std::clamp(i, 10.0, 30.0)), 0, radians(std::clamp(p, 5.0, 15.0)));
      QVERIFY(isClose(brdf.evaluate(at(i, p).wi, at(i, p).wo).x, held));
      QVERIFY(!brdf.hasData(at(i, p)));
    }
    QVERIFY(brdf.hasData(at(20, 10)) && brdf.hasData(at(10, 5)) && brdf.hasData(at(30, 15)));
  }

  /// A viewer that is below the horizon of the last angle of incidence sees what is at that horizon.
  void beyondTheLastAngleTheHorizonIsSeen() {
    const Function function = [](double, double, double p) { return 1 + p; };
    const IncidenceTableBrdf brdf(
        tableOf(Axis::mirror, true, function, steps(50, 10, 1), steps(0, 15, 13), steps(0, 1, 181)));
    // Away from the normal the horizon is 40 degrees from the mirror direction; toward it, 140.
    const auto at = [&](double i, double a, double p) {
      return brdf.evaluate(fromSpherical(radians(i), 0), aboutMirror(radians(i), radians(a), radians(p))).x;
    };
    QVERIFY(isClose(at(10, 180, 39), 1 + radians(39)));
    QVERIFY(isClose(at(10, 180, 60), 1 + radians(40)));
    QVERIFY(isClose(at(10, 180, 79), 1 + radians(40)));
    QVERIFY(isClose(at(80, 0, 150), 1 + radians(140)));
    QVERIFY(isClose(at(80, 90, 85), 1 + radians(85)));
  }

  void axisHasOneValueAndNegativeOnesAreCut() {
    const IncidenceTableBrdf brdf(tableOf(
        Axis::mirror, true, [](double, double a, double p) { return p > 0 ? -1 : degrees(a); }, {0.5}, steps(0, 90, 3),
        steps(0, 10, 2)));
    QCOMPARE(brdf.clampedCount(), std::size_t(9));
    QVERIFY(isClose(brdf.evaluate(fromSpherical(0.5, 0), fromSpherical(0.5, pi)).x, 90));
    QVERIFY(brdf.evaluate(fromSpherical(0.5, 0), aboutMirror(0.5, 1, radians(10))).x < 1e-4);
  }

  void brokenTablesAreRefused() {
    const IncidenceTable good = tableOf(
        Axis::mirror, true, [](double, double, double) { return 1; }, steps(0, 10, 3), steps(0, 90, 3), steps(0, 5, 3));
    QVERIFY(errorOf(good).empty());
    const auto refused = [&](const std::function<void(IncidenceTable&)>& breakIt, const char* part) {
      IncidenceTable table = good;
      breakIt(table);
      return errorOf(table).find(part) != std::string::npos;
    };
    QVERIFY(refused([](auto& table) { table.incident[1] = table.incident[0]; }, "the angle of incidence 0.0"));
    QVERIFY(refused([](auto& table) { table.incident[2] = 1.6; }, "from 0 to 90"));
    QVERIFY(refused([](auto& table) { table.azimuths[2] = 3.2; }, "the azimuth"));
    QVERIFY(refused([](auto& table) { table.polars.clear(); }, "found no polar angle"));
    QVERIFY(refused([](auto& table) { table.values.pop_back(); }, "found 26 values, expected 27"));
    QVERIFY(refused([](auto& table) { table.values[7].y = std::numeric_limits<float>::infinity(); }, "value 7"));
  }
};

GONIO_TEST(IncidenceTableBrdfTest)
}  // namespace incidence_table_brdf_test

#include "incidence_table_brdf_test.moc"
