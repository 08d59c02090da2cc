// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/weighted_sum.h"

#include <QTest>
#include <limits>
#include <string>
#include <vector>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace weights_test {
using namespace gonio;

class WeightsTest : public QObject {
  Q_OBJECT
 private:
  static std::string errorOf(const std::vector<double>& weights, std::size_t materials) {
    try {
      checkWeights(weights, materials);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }

 private Q_SLOTS:
  void weightsThatAddUpAreTaken() {
    QCOMPARE(errorOf({0.25, 0.75}, 2), std::string());
    QCOMPARE(errorOf({1.0 / 3, 1.0 / 3, 1.0 / 3}, 3), std::string());
    QCOMPARE(errorOf({0, 1, 0}, 3), std::string());
  }

  void hardCase30ErrorsStateWhatIsWrong() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(errorOf({0.5, 0.5}, 3).find("found 2 weights, expected 3") != std::string::npos);
    QVERIFY(errorOf({1.5, -0.5}, 2).find("material 1") != std::string::npos);
    QVERIFY(errorOf({0.5, nan}, 2).find("material 2") != std::string::npos);
    QVERIFY(errorOf({0.5, 0.4}, 2).find("add up to 0.9") != std::string::npos);
    QVERIFY(!errorOf({0.5, 0.5 + 2e-9}, 2).empty());
  }

  void theWholeWeightIsFound() {
    QCOMPARE(indexOfFullWeight(std::vector<double>{0, 0, 1}), std::optional<std::size_t>(2));
    QVERIFY(!indexOfFullWeight(std::vector<double>{0.5, 0.5}));
  }
};

GONIO_TEST(WeightsTest)
}  // namespace weights_test

#include "weights_test.moc"
