// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/data_transform.h"

#include <QTest>

using namespace gonio;

class DataTransformTest : public QObject {
  Q_OBJECT
 private:
  static constexpr DataTransform all[] = {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root,
                                          DataTransform::none};

 private Q_SLOTS:
  /// The logarithm of a reflectance of 0 is 0, not minus infinity, and comes back as 0.
  void hardCase38LogarithmOfZero() {
    for (const DataTransform transform : all) {
      QCOMPARE(transformed(transform, 0, 1), 0.0);
      QCOMPARE(inverseTransformed(transform, 0, 1), 0.0);
      QCOMPARE(inverseTransformed(transform, -3, 1), 0.0);
    }
  }

  /// A few units in the last place over all sizes of reflectance; exp(log(1 + x)) - 1 would lose the small ones.
  void hardCase16DynamicRange() {
    for (const DataTransform transform : all)
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

QTEST_APPLESS_MAIN(DataTransformTest)
#include "data_transform_test.moc"
