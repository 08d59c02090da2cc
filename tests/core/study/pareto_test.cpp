// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/study_plot.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/test_program.h"

namespace pareto_test {
using namespace gonio::study;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double none = std::nan("");
using Indices = std::vector<std::size_t>;

bool beats(const CostAndError& a, const CostAndError& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

StudyRecord record(double frame, double snr, std::size_t bytes) {
  return {.representation = {}, .bytes = bytes, .frameMilliseconds = frame, .errors = {}, .renderedSnr = snr};
}

class ParetoTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The definition, tried on every pair; few distinct numbers make many ties.
  void frontIsWhatNoneBeats() {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> few(0, 9);
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<CostAndError> alternatives(std::size_t(few(random)) * 3);
      for (CostAndError& alternative : alternatives) {
        alternative = {double(few(random)), double(few(random))};
        if (few(random) == 0) alternative.cost = none;
        if (few(random) == 0) alternative.error = few(random) < 5 ? none : -infinity;
      }
      const Indices front = paretoFront(alternatives);
      for (std::size_t i = 0; i < alternatives.size(); ++i) {
        const bool isNumber = !std::isnan(alternatives[i].cost) && !std::isnan(alternatives[i].error);
        const bool beaten =
            std::ranges::any_of(alternatives, [&](const CostAndError& other) { return beats(other, alternatives[i]); });
        QCOMPARE(std::ranges::count(front, i) == 1, isNumber && !beaten);
      }
      QVERIFY(std::ranges::is_sorted(front, {}, [&](std::size_t i) { return alternatives[i].cost; }));
    }
  }

  void equalsStandTogetherInTheirOrder() {
    const std::vector<CostAndError> alternatives{{2, 1}, {1, 2}, {2, 1}, {1, 2}, {2, 2}};
    QCOMPARE(paretoFront(alternatives), (Indices{1, 3, 0, 2}));
  }

  void noErrorAtAllAndNoCostAtAll() {
    const std::vector<CostAndError> alternatives{
        {5, -infinity}, {0, 3}, {6, -infinity}, {4, none}, {infinity, -infinity}};
    QCOMPARE(paretoFront(alternatives), (Indices{1, 0}));
    QVERIFY(paretoFront({}).empty());
  }

  void theBestKeepsAllLimits() {
    const std::vector<StudyRecord> records{record(5, 60, 1000), record(1, 30, 100), record(2, 45, 500),
                                           record(1, 45, 900)};
    QCOMPARE(bestWithin(records, {}), std::size_t(0));
    QCOMPARE(bestWithin(records, {.frameMilliseconds = 1}), std::size_t(3));
    QCOMPARE(bestWithin(records, {.frameMilliseconds = 2, .bytes = 500}), std::size_t(2));
    QCOMPARE(bestWithin(records, {.renderedSnr = 30, .bytes = 100}), std::size_t(1));
    QVERIFY(!bestWithin(records, {.renderedSnr = 45.1, .bytes = 900}));
    QVERIFY(!bestWithin({}, {}));
  }

  void tiesGoToTheCheaper() {
    QCOMPARE(bestWithin(std::vector{record(3, 40, 5), record(2, 40, 9), record(2, 40, 8), record(2, 40, 8)}, {}),
             std::size_t(2));
  }

  void equalPicturesAndBlackMaterials() {
    const std::vector<StudyRecord> records{record(1, none, 1), record(9, infinity, 9), record(1, 50, 1)};
    QCOMPARE(bestWithin(records, {}), std::size_t(1));
    QCOMPARE(bestWithin(records, {.renderedSnr = 200}), std::size_t(1));
    QVERIFY(!bestWithin(std::vector{records[0]}, {.renderedSnr = -100}));
    // A black material is shown well by anything: the cheapest.
    QCOMPARE(bestWithin(std::vector{record(2, none, 1), record(1, none, 1)}, {}), std::size_t(1));
  }
};

GONIO_TEST(ParetoTest)
}  // namespace pareto_test

#include "pareto_test.moc"
