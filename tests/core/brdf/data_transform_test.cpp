// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/data_transform.h"

#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"

namespace data_transform_test {
using namespace gonio;

class DataTransformTest : public QObject {
  Q_OBJECT
 private:
  static std::vector<DataTransform> all() {
    std::vector<DataTransform> result;
    for (std::size_t i = 0; i < dataTransformNames.size(); ++i) result.push_back(DataTransform(i));
    return result;
  }

 private Q_SLOTS:
  /// The logarithm of a reflectance of 0 is 0, not minus infinity, and comes back as 0.
  void hardCase38LogarithmOfZero() {
    for (const DataTransform transform : all()) {
      QCOMPARE(transformed(transform, 0, 1), 0.0);
      QCOMPARE(inverseTransformed(transform, 0, 1), 0.0);
      QCOMPARE(inverseTransformed(transform, -3, 1), 0.0);
    }
    for (const double gamma : {1.0, 2.0, 2.5, 3.0}) QCOMPARE(gammaTransformed(0, gamma), 0.0);
  }

  /// The definitions, of which eq. 2.29 to 2.31 print the first three.
  void formulas() {
    for (const double rho : {0.0, 0.003, 0.4, 7.0, 900.0})
      for (const double weight : {1e-3, 0.3, 1.0}) {
        const auto isNear = [&](DataTransform transform, double y) {
          return std::abs(transformed(transform, rho, weight) - y) <= 1e-15 + 1e-14 * y;
        };
        QVERIFY(isNear(DataTransform::logPlus, std::log(1 + rho)));
        QVERIFY(isNear(DataTransform::logPlusTenth, std::log(1 + 10 * rho)));
        QVERIFY(isNear(DataTransform::logPlusHundredth, std::log(1 + 100 * rho)));
        QVERIFY(isNear(DataTransform::cosineLog, std::log(1 + rho * weight)));
        QVERIFY(isNear(DataTransform::gamma15, std::cbrt(rho * rho)));
        QVERIFY(isNear(DataTransform::root, std::sqrt(rho)));
        QVERIFY(isNear(DataTransform::gamma25, std::pow(rho * rho, 0.2)));
        QVERIFY(isNear(DataTransform::gamma3, std::cbrt(rho)));
        QVERIFY(isNear(DataTransform::none, rho));
      }
  }

  void namesAreFound() {
    for (const DataTransform transform : all())
      QCOMPARE(dataTransformNamed(dataTransformNames[std::size_t(transform)]), transform);
    QVERIFY(!dataTransformNamed("log"));
  }

  /// What a logarithm's inverse makes of large y is no longer a float: capped, and never infinite.
  void hardCase39OverflowOfTheInverse() {
    for (const DataTransform transform : all())
      for (const double y : {88.0, 90.0, 700.0, 800.0, 1e300, HUGE_VAL}) {
        const double rho = inverseTransformed(transform, y, 1e-3);
        QVERIFY(std::isfinite(float(rho)));
        const bool isRoot = logOffset(transform) == 0;
        QVERIFY(y < 94 || rho == maxBrdfValue || (isRoot && std::pow(y, gammaOf(transform)) < 1.001 * rho));
      }
    QCOMPARE(inverseTransformed(DataTransform::logPlus, 90, 1), maxBrdfValue);
    QVERIFY(inverseTransformed(DataTransform::logPlus, 88, 1) < maxBrdfValue);
    QCOMPARE(inverseTransformed(DataTransform::cosineLog, 85, 1e-3), maxBrdfValue);
  }

  /// A reconstruction may be negative: it counts as black, and no power of it is taken.
  void hardCase43GammaOfNegativeReconstructions() {
    for (const double gamma : {1.0, 1.5, 2.0, 3.0})
      for (const double rho : {-1e6, -1e-300, -0.0, std::nan("")}) QCOMPARE(gammaTransformed(rho, gamma), 0.0);
  }

  /// The slope is the derivative of the inverse, by central differences, but for its floor near the root of 0.
  void theSlopeIsTheDerivative() {
    for (const DataTransform transform : all())
      for (const double weight : {1e-3, 0.2, 1.0})
        for (double rho = 1e-3; rho < 1e4; rho *= 7) {
          const double y = transformed(transform, rho, weight), step = 1e-5 * std::max(1e-2, std::abs(y));
          const double difference =
              (inverseTransformed(transform, y + step, weight) - inverseTransformed(transform, y - step, weight)) /
              (2 * step);
          QVERIFY(std::abs(inverseSlope(transform, rho, weight) - difference) < 1e-6 * difference);
        }
    QCOMPARE(inverseSlope(DataTransform::root, 0, 1), 0.01);
  }

  void gammaIsARoot() {
    QCOMPARE(gammaTransformed(9, 2), 3.0);
    QVERIFY(std::abs(gammaTransformed(27, 3) - 3) < 1e-15);
    QCOMPARE(gammaTransformed(0.7, 1), 0.7);
    for (double gamma = 1; gamma <= 3; gamma += 0.25)
      for (double rho = 1e-12; rho < 1e7; rho *= 7)
        QVERIFY(std::abs(std::pow(gammaTransformed(rho, gamma), gamma) - rho) < 1e-14 * rho);
  }

  /// A few units in the last place over all sizes of reflectance; exp(log(1 + x)) - 1 would lose the small ones.
  void hardCase16DynamicRange() {
    for (const DataTransform transform : all())
      for (double rho = 1e-12; rho < 1e7; rho *= 7) {
        const double back = inverseTransformed(transform, transformed(transform, rho, 0.3), 0.3);
        QVERIFY(std::abs(back - rho) < 1e-14 * rho);
      }
  }

  /// At grazing angles the weight is floored, so that its inverse stays finite.
  void hardCase45FloorOfTheWeight() {
    QCOMPARE(cosineWeight(0, 1), 1e-3);
    QCOMPARE(cosineWeight(0.5, 0.5), 0.25);
    const double weight = cosineWeight(1e-9, 1e-9);
    for (double rho = 1e-6; rho < 1e6; rho *= 10) {
      const double back =
          inverseTransformed(DataTransform::cosineLog, transformed(DataTransform::cosineLog, rho, weight), weight);
      QVERIFY(std::abs(back - rho) <= 8 * (1 + rho * weight) / weight * 2.3e-16 + 1e-14 * rho);
    }
  }
};

GONIO_TEST(DataTransformTest)
}  // namespace data_transform_test

#include "data_transform_test.moc"
