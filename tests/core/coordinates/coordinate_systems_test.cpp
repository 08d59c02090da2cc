// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/coordinate_systems.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace coordinate_systems_test {
using namespace gonio;

class CoordinateSystemsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Of isotropic materials: both polar angles and the angle between the directions return.
  void roundTrips() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const CoordinateSystem& system : coordinateSystems())
      for (int n = 0; n < 500; ++n) {
        const DirectionPair pair{fromSpherical(1.5 * uniform(random), 6 * uniform(random)),
                                 fromSpherical(1.5 * uniform(random), 6 * uniform(random))};
        const std::vector<double> values = system.to(pair);
        QCOMPARE(values.size(), system.columns.size());
        const auto found = system.from(values);
        QVERIFY(found.has_value());
        QVERIFY(std::abs(found->wi.z - pair.wi.z) < 1e-9 && std::abs(found->wo.z - pair.wo.z) < 1e-9);
        QVERIFY(std::abs(glm::dot(found->wi, found->wo) - glm::dot(pair.wi, pair.wo)) < 1e-9);
      }
  }

  void withoutDirections() {
    const auto none = [](const char* system, std::vector<double> values) {
      return !coordinateSystemNamed(system).from(values);
    };
    QVERIFY(none("standard", {2, 0, 0.3, 0}));
    QVERIFY(none("half-difference", {1.2, 1.2, 0}));
    QVERIFY(none("half-out", {1.4, 1.4, pi}));
    QVERIFY(none("projected-deviation", {0.3, 1.9, 0}));
    QVERIFY_EXCEPTION_THROWN(coordinateSystemNamed("pdv"), Error);
  }
};

GONIO_TEST(CoordinateSystemsTest)
}  // namespace coordinate_systems_test

#include "coordinate_systems_test.moc"
