// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/data_transform.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/math/parallel.h"
#include "tests/support/test_program.h"

namespace log_relative_test {
using namespace gonio;

class LogRelativeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// ln((rho w + e) / (ref + e)), by long double.
  void isItsFormula() {
    for (double rho = 1e-9; rho < 1e7; rho *= 7)
      for (const double reference : {0.0, 1e-4, 0.3, 50.0}) {
        const long double ratio = ((long double)(rho)*0.3L + 1e-3L) / ((long double)(reference) + 1e-3L);
        const double expected = double(std::log(ratio));
        QVERIFY(std::abs(logRelative(rho, 0.3, reference) - expected) <= 2e-15 * std::max(1e-3, std::abs(expected)));
      }
  }

  /// About the reference the mapping is 0 and keeps all digits; ln of the quotient would lose them.
  void noCancellationAboutTheReference() {
    for (const double reference : {1e-3, 0.25, 4.0}) {
      QCOMPARE(logRelative(reference / 0.5, 0.5, reference), 0.0);
      QCOMPARE(inverseLogRelative(0, 0.5, reference), reference / 0.5);
      const double near = reference * (1 + 1e-12), expected = (near - reference) / (reference + logRelativeOffset);
      QVERIFY(std::abs(logRelative(near, 1, reference) / expected - 1) < 1e-11);
    }
  }

  /// Back over all sizes: to what the logarithm of a value above e keeps.
  void hardCase16DynamicRange() {
    for (const double weight : {1e-3, 0.3, 1.0})
      for (const double reference : {0.0, 1e-3, 0.7, 1e3})
        for (double rho = 1e-9; rho < 1e7; rho *= 7) {
          const double back = inverseLogRelative(logRelative(rho, weight, reference), weight, reference);
          // A rounding of y counts relative to rho w + e.
          const double y = std::abs(logRelative(rho, weight, reference));
          const double bound = 4 * 2.3e-16 * (1 + y) * (rho * weight + logRelativeOffset) / weight;
          QVERIFY2(std::abs(back - rho) <= bound, qPrintable(QString("%1 %2 %3").arg(rho).arg(weight).arg(reference)));
        }
  }

  void hardCase38LogarithmOfZero() {
    QCOMPARE(logRelative(0, 1, 0), 0.0);
    for (const double reference : {0.0, 1e-9, 1.0, 1e6}) {
      QVERIFY(std::isfinite(logRelative(0, 1e-3, reference)));
      // Below the smallest y that a reflectance has, also at the end of the range.
      QCOMPARE(inverseLogRelative(-1e3, 1, reference), 0.0);
      QCOMPARE(inverseLogRelative(-HUGE_VAL, 1, reference), 0.0);
      QCOMPARE(inverseLogRelative(std::nan(""), 1, reference), 0.0);
    }
  }

  void hardCase39OverflowOfTheInverse() {
    for (const double y : {95.0, 700.0, 720.0, 1e300, HUGE_VAL}) QCOMPARE(inverseLogRelative(y, 1, 0.1), maxBrdfValue);
    QVERIFY(inverseLogRelative(85, 1, 0.1) < maxBrdfValue);
    QCOMPARE(inverseLogRelative(85, 1e-3, 100), maxBrdfValue);
  }

  /// At grazing angles, where the weight is at its floor, the inverse magnifies what is off by 1 / w and no more.
  void hardCase45FloorOfTheWeight() {
    const double weight = cosineWeight(1e-9, 1e-9);
    for (double rho = 1e-6; rho < 1e6; rho *= 10) {
      const double y = logRelative(rho, weight, 0.02), shifted = inverseLogRelative(y + 1e-9, weight, 0.02);
      const double expected = 1e-9 * (rho + logRelativeOffset / weight);
      QVERIFY(std::abs(shifted - rho) <= 1.001 * expected + 1e-12);
    }
  }

  void medians() {
    std::vector<float> odd{3, 1, 2}, even{4, 1, 2, 10}, one{7}, same{5, 5, 5, 5};
    QCOMPARE(medianOf(odd), 2.0f);
    QCOMPARE(medianOf(even), 3.0f);
    QCOMPARE(medianOf(one), 7.0f);
    QCOMPARE(medianOf(same), 5.0f);
    QCOMPARE(medianOf({}), 0.0f);
  }

  /// Each cell has the median of its own row; the same bits on any number of threads.
  void medianReferenceByCell() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const std::size_t count : {1, 2, 5, 8}) {
      constexpr std::size_t cells = 1000;
      std::vector<std::vector<float>> columns(count, std::vector<float>(cells));
      for (auto& column : columns)
        for (float& value : column) value = uniform(generator);
      const std::vector<std::span<const float>> spans(columns.begin(), columns.end());
      const std::vector<float> medians = medianReference(spans);
      for (std::size_t cell = 0; cell < cells; ++cell) {
        std::vector<float> row;
        for (const auto& column : columns) row.push_back(column[cell]);
        std::sort(row.begin(), row.end());
        QCOMPARE(medians[cell], float((double(row[(count - 1) / 2]) + double(row[count / 2])) / 2));
      }
      const ThreadLimit limit(1);
      QVERIFY(medianReference(spans) == medians);
    }
    QVERIFY(medianReference({}).empty());
  }
};

GONIO_TEST(LogRelativeTest)
}  // namespace log_relative_test

#include "log_relative_test.moc"
