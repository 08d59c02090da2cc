// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/plausibility.h"

#include <QTest>
#include <cmath>

#include "core/brdf/tabulated_brdf.h"
#include "tests/support/function_brdf.h"
#include "tests/support/spiky_table.h"
#include "tests/support/test_program.h"

namespace plausibility_test {
using namespace gonio;
using namespace gonio::metrics;

PlausibilityCheck find(const std::vector<PlausibilityCheck>& checks, const std::string& name) {
  for (const PlausibilityCheck& check : checks)
    if (check.name == name) return check;
  return {.name = "missing", .passed = false, .worst = -1, .where = {}};
}

std::vector<std::string> failures(const Brdf& brdf) {
  std::vector<std::string> names;
  for (const PlausibilityCheck& check : checkPlausibility(brdf))
    if (!check.passed) names.push_back(check.name);
  return names;
}

using Names = std::vector<std::string>;

class PlausibilityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void physicalModelsPass() {
    for (const double roughness : {1e-3, 0.05, 0.3, 1.0})
      QCOMPARE(failures(*test::ggx(Rgb(0), Rgb(1), roughness, 1)), Names{});
    QCOMPARE(failures(test::lambert(Rgb(1))), Names{});
    QCOMPARE(failures(test::lambert(Rgb(0))), Names{});
  }

  void bakedTablesPass() { QCOMPARE(failures(*bakeTable(*test::ggx(Rgb(0.2), Rgb(1), 0.1, 0.04))), Names{}); }

  void aBrdfThatIsNotReciprocalIsFound() {
    const test::FunctionBrdf brdf([](const Direction& wi, const Direction&) { return Rgb(0.2 * wi.z); });
    const auto checks = checkPlausibility(brdf);
    QCOMPARE(failures(brdf), Names{"reciprocity"});
    const PlausibilityCheck check = find(checks, "reciprocity");
    QVERIFY(check.worst > 0.5 && check.worst <= 1);
    QVERIFY(QString::fromStdString(check.where).contains("theta_i"));
  }

  void slightDifferencesPass() {
    const test::FunctionBrdf brdf([](const Direction& wi, const Direction&) { return Rgb(0.2 + 0.002 * wi.z); });
    QCOMPARE(failures(brdf), Names{});
    QVERIFY(find(checkPlausibility(brdf), "reciprocity").worst > 0.005);
  }

  /// A spike of one cell for viewers between those that are always examined.
  void hardCase53SpikeBetweenTheAngles() {
    const auto table = test::spikyTable(0, 20, -1, 3e7f);
    const double expected = test::albedoOfSpike(*table, radians(20), 0, 1);
    QVERIFY(expected > 1.5);
    const PlausibilityCheck check = find(checkPlausibility(*table), "energy");
    QVERIFY(!check.passed);
    QCOMPARE(check.where, std::string("theta_o 20 degrees"));
    QVERIFY2(std::abs(check.worst / expected - 1) < 0.02,
             qPrintable(QString("%1, expected %2").arg(check.worst).arg(expected)));
  }

  void gainOfEnergyIsFound() {
    QCOMPARE(failures(test::lambert(Rgb(0.2, 1.2, 0.3))), Names{"energy"});
    QVERIFY(std::abs(find(checkPlausibility(test::lambert(Rgb(0.2, 1.2, 0.3))), "energy").worst - 1.2) < 1e-9);
    QCOMPARE(failures(test::lambert(Rgb(1.005))), Names{});
    QCOMPARE(failures(test::lambert(Rgb(1.02))), Names{"energy"});
  }

  void negativeValuesAreFound() {
    const test::FunctionBrdf brdf(
        [](const Direction& wi, const Direction& wo) { return Rgb(0.1, wi.z * wo.z > 0.5 ? -0.01 : 0.1, 0.1); });
    const PlausibilityCheck check = find(checkPlausibility(brdf), "negative");
    QVERIFY(!check.passed && std::abs(check.worst - 0.01) < 1e-12 && !check.where.empty());
  }

  void notFiniteValuesAreFound() {
    for (const double bad : {double(NAN), double(INFINITY)}) {
      const test::FunctionBrdf brdf([bad](const Direction& wi, const Direction& wo) {
        return Rgb(0.1, 0.1, wi.z > 0.9 && wo.z > 0.9 ? bad : 0.1);
      });
      const PlausibilityCheck check = find(checkPlausibility(brdf), "non-finite");
      QVERIFY(!check.passed && check.worst >= 1 && !check.where.empty());
    }
  }

  void order() {
    Names names;
    for (const PlausibilityCheck& check : checkPlausibility(test::lambert(Rgb(0.5)))) names.push_back(check.name);
    QCOMPARE(names, (Names{"reciprocity", "energy", "negative", "non-finite"}));
  }
};

GONIO_TEST(PlausibilityTest)
}  // namespace plausibility_test

#include "plausibility_test.moc"
