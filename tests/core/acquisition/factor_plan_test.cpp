// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/factor_plan.h"

#include <QTest>
#include <cmath>
#include <set>

#include "core/support/error.h"
#include "tests/core/acquisition/factor_oracles.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace factor_plan_test {
using namespace gonio;
using namespace gonio::acquisition;

class FactorPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void bothCurvesLieInThePlaneOfIncidence_data() {
    QTest::addColumn<int>("axes");
    for (int axes = 0; axes < int(factorAxesNames.size()); ++axes)
      QTest::newRow(factorAxesNames[std::size_t(axes)].data()) << axes;
  }
  void bothCurvesLieInThePlaneOfIncidence() {
    QFETCH(int, axes);
    const auto which = FactorAxes(axes);
    const FactorPlan plan = planFactors({.axes = which, .fixedAngle = radians(40)});
    QCOMPARE(plan.plan.samples.size() + std::size_t(plan.blocked), std::size_t(180));
    QCOMPARE(plan.curves.size(), plan.plan.samples.size());
    for (std::size_t i = 0; i < plan.curves.size(); ++i) {
      const auto& [wi, wo] = plan.plan.samples[i].directions;
      QVERIFY(std::abs(glm::cross(wi, wo).z) < 1e-9 || std::abs(wi.y * wo.x - wi.x * wo.y) < 1e-9);
      QVERIFY(polarAngle(wi) < radians(89.001) && polarAngle(wo) < radians(89.001));
      QVERIFY(glm::length(wi - wo) >= 2 * std::sin(radians(1)) - 1e-12);
      const glm::dvec2 at = test::factorPlaceOf(readAxes(which), wi, wo);
      if (plan.curves[i] == FactorCurve::along)
        QVERIFY(at.y < 1e-9);
      else if (plan.curves[i] == FactorCurve::across)
        QVERIFY(std::abs(at.x - radians(40)) < 1e-9);
    }
  }

  /// As many readings as with other axes; the further ones on both sides of the mirror direction, at up to five angles
  /// other than the fixed one.
  void furtherReadings() {
    for (const auto& [each, angles] : {std::pair(10, 1), std::pair(30, 3), std::pair(90, 5)}) {
      const FactorPlan plan = planFactors({.axes = FactorAxes::adaptive, .angles = each, .distances = each});
      QCOMPARE(int(plan.curves.size()) + plan.blocked, 2 * each);
      std::set<int> viewers;
      int lower = 0, upper = 0;
      for (std::size_t i = 0; i < plan.curves.size(); ++i) {
        if (plan.curves[i] != FactorCurve::further) continue;
        const auto& [wi, wo] = plan.plan.samples[i].directions;
        QVERIFY(std::abs(wi.x + wo.x) > 1e-6);
        viewers.insert(int(std::lround(degrees(polarAngle(wo)))));
        ++(wi.x < -wo.x ? lower : upper);
      }
      QCOMPARE(int(viewers.size()), angles);
      QVERIFY(!viewers.contains(60) && lower > 0 && upper > lower);
    }
    // The fixed angle may be one of them: no curve twice.
    const FactorPlan plan = planFactors({.axes = FactorAxes::adaptive, .fixedAngle = radians(25)});
    for (std::size_t i = 0; i < plan.curves.size(); ++i)
      QVERIFY(plan.curves[i] != FactorCurve::further ||
              std::abs(polarAngle(plan.plan.samples[i].directions.wo) - radians(25)) > radians(5));
  }

  /// One arm occludes the other: no reading along the normal, nor at retro-reflection.
  void blockedReadingsAreLeftOut() {
    const FactorPlan plan = planFactors({.fixedAngle = 0.5, .minSeparation = 0.035});
    for (const PlannedSample& sample : plan.plan.samples)
      QVERIFY(std::acos(glm::dot(sample.directions.wi, sample.directions.wo)) > 0.0349);
    QVERIFY(plan.blocked > planFactors({.fixedAngle = 0.5, .minSeparation = 0}).blocked);
    QVERIFY(
        test::contains(test::errorOf([] { planFactors({.minSeparation = pi}); }), "reaches no reading of the curve"));
  }

  void methodsStateTheirAxes() {
    QCOMPARE(factorMethod(FactorAxes::halfOut), std::string("factors, half-out"));
    for (std::size_t axes = 0; axes < factorAxesNames.size(); ++axes) {
      const FactorPlan plan = planFactors({.axes = FactorAxes(axes)});
      QVERIFY(axesOfFactorMethod(plan.plan.method) == FactorAxes(axes));
    }
    for (const char* other : {"", "somp", "factors, ", "factors, half-outer", "half-out"})
      QVERIFY(!axesOfFactorMethod(other));
  }

  /// Also those that the arms obstruct near the normal.
  void plannedReadingsOfTheirAngles() {
    for (const int count : {5, 40, 90, 500})
      for (const double separation : {0.0, 2.0, 20.0}) {
        const FactorPlan plan = planFactors({.angles = count, .minSeparation = radians(separation)});
        std::vector<double> angles;
        for (std::size_t i = 0; i < plan.curves.size(); ++i)
          if (plan.curves[i] == FactorCurve::along) angles.push_back(polarAngle(plan.plan.samples[i].directions.wo));
        QVERIFY(separation == 0 || angles.front() > 0);
        QCOMPARE(plannedReadings(angles), count);
      }
    // Not evenly spaced, or not from 0: as many as there are.
    QCOMPARE(plannedReadings(std::vector{0.2, 0.3, 0.5}), 3);
    QCOMPARE(plannedReadings(std::vector{0.25, 0.35, 0.45}), 3);
    QCOMPARE(plannedReadings(std::vector{0.25}), 1);
    QCOMPARE(plannedReadings({}), 0);
  }

  void wrongOptionsAreErrors() {
    for (const FactorPlanOptions& wrong :
         {FactorPlanOptions{.fixedAngle = 1.6}, FactorPlanOptions{.fixedAngle = -0.1}, FactorPlanOptions{.angles = 1},
          FactorPlanOptions{.distances = 20'000}, FactorPlanOptions{.fixedAngle = 1, .maxPolarAngle = 0.9},
          FactorPlanOptions{.maxPolarAngle = std::nan("")}, FactorPlanOptions{.minSeparation = -1}})
      QVERIFY_EXCEPTION_THROWN(planFactors(wrong), Error);
    QVERIFY(test::contains(test::errorOf([] { factorAxesNamed("pdv"); }), "found 'pdv', expected projected-deviation"));
  }
};

GONIO_TEST(FactorPlanTest)
}  // namespace factor_plan_test

#include "factor_plan_test.moc"
