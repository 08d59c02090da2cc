// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/curve_drag.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/math/monotone_cubic.h"
#include "tests/support/test_program.h"

namespace curve_drag_test {
using namespace gonio;
using namespace gonio::editing;

std::vector<double> nodes() {
  std::vector<double> result;
  for (int i = 0; i <= 200; ++i) result.push_back(i / 100.0);
  return result;
}
std::vector<double> curveOf(double (*f)(double)) {
  std::vector<double> result;
  for (const double x : nodes()) result.push_back(f(x));
  return result;
}

class CurveDragTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void noDragLeavesEveryBit() {
    const auto curve = curveOf([](double x) { return std::exp(-x * x); });
    QVERIFY(draggedCurve(nodes(), curve, {{0, 1, 2}, {0, 1, 2}, {0, 0, 0}, CurveDrag::Mode::add}) == curve);
    QVERIFY(draggedCurve(nodes(), curve, {{0, 1, 2}, {0, 1, 2}, {1, 1, 1}, CurveDrag::Mode::multiply}) == curve);
    QVERIFY(draggedCurve(nodes(), curve, {}) == curve);
  }

  /// The dragged point stands where the hand put it, the others where they were.
  void theCurvePassesThroughThePoints() {
    const auto curve = curveOf([](double x) { return 2 - x / 2; });
    const auto added = draggedCurve(nodes(), curve, {{0, 0.5, 1, 2}, {0, 0.5, 1, 2}, {0, 0.75, 0, 0}});
    QVERIFY(std::abs(added[50] - 2.5) < 1e-12);
    for (const std::size_t i : {0u, 100u, 150u, 200u}) QVERIFY(std::abs(added[i] - curve[i]) < 1e-12);
    const auto times =
        draggedCurve(nodes(), curve, {{0, 0.5, 1, 2}, {0, 0.5, 1, 2}, {1, 3, 1, 1}, CurveDrag::Mode::multiply});
    QVERIFY(std::abs(times[50] - 3 * 1.75) < 1e-12);
    QVERIFY(std::abs(times[150] - curve[150]) < 1e-12);
  }

  /// A point that moves along the axis takes its value with it; the ends stay.
  void movingAPointStretchesTheCurve() {
    const auto curve = curveOf([](double x) { return std::exp(-8 * x); });
    const auto moved = draggedCurve(nodes(), curve, {{0, 0.25, 2}, {0, 0.5, 2}, {0, 0, 0}});
    QVERIFY(std::abs(moved[50] - curve[25]) < 1e-9);
    QVERIFY(std::abs(moved[0] - curve[0]) < 1e-12 && std::abs(moved[200] - curve[200]) < 1e-12);
    QVERIFY(std::is_sorted(moved.rbegin(), moved.rend()));
  }

  /// Between two points a falling curve falls, however high or far one of them is dragged: no dip, no wall behind it.
  void aFallingCurveFallsBetweenThePoints() {
    const auto curve = curveOf([](double x) { return 1 / (1 + 400 * x * x); });
    for (const auto mode : {CurveDrag::Mode::add, CurveDrag::Mode::multiply})
      for (const double height : {0.004, 0.1, 0.5, 0.9})
        for (const double place : {0.3, 0.5, 1.2}) {
          const double before = 1 / (1 + 400 * 0.25);
          const double amount = mode == CurveDrag::Mode::add ? height - before : height / before;
          const double none = mode == CurveDrag::Mode::add ? 0 : 1;
          const auto dragged = draggedCurve(nodes(), curve, {{0, 0.5, 2}, {0, place, 2}, {none, amount, none}, mode});
          QVERIFY(std::is_sorted(dragged.rbegin(), dragged.rend()));
          QVERIFY(std::abs(dragged[std::size_t(std::lround(100 * place))] - height) < 1e-9);
          QCOMPARE(dragged.front(), curve.front());
          QCOMPARE(dragged.back(), curve.back());
        }
  }

  void nothingFallsBelowZero() {
    const auto curve = curveOf([](double) { return 1.0; });
    for (const double value : draggedCurve(nodes(), curve, {{0, 1, 2}, {0, 1, 2}, {0, -5, 0}})) QVERIFY(value >= 0);
  }

  void controlPointsFollowTheCurve() {
    const auto curve = curveOf([](double x) { return std::exp(-20 * x * x); });
    const auto points = controlPoints(nodes(), curve, 0.02, 20);
    QVERIFY(points.size() < 12);
    QCOMPARE(points.front(), 0.0);
    QCOMPARE(points.back(), 2.0);
    std::vector<double> values;
    for (const double x : points) values.push_back(std::exp(-20 * x * x));
    const auto slopes = monotoneSlopes(points, values);
    for (std::size_t i = 0; i < curve.size(); ++i)
      QVERIFY(std::abs(evaluateMonotoneCubic(points, values, slopes, nodes()[i]) - curve[i]) <= 0.02 + 1e-12);
    QCOMPARE(controlPoints(nodes(), curve, 1e-9, 5).size(), std::size_t(5));
    QCOMPARE(controlPoints(nodes(), curveOf([](double) { return 0.0; }), 0.02, 9).size(), std::size_t(2));
    const double one[] = {0.0};
    QCOMPARE(controlPoints(one, one, 0.1, 5).size(), std::size_t(1));
  }
};

GONIO_TEST(CurveDragTest)
}  // namespace curve_drag_test

#include "curve_drag_test.moc"
