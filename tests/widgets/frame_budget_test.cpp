// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/picture_drawer.h"

#include <QTest>

#include "tests/support/test_program.h"

namespace frame_budget_test {
using gonio::widgets::FrameBudget;

class FrameBudgetTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void slowMachineDrawsTheFirstFrameAtHalfResolution() {
    FrameBudget budget;
    for (int i = 0; i < 20; ++i) budget.record(1e6, 1, 40);  // 40 ns per sample: not one sample in the budget
    const auto first = budget.next(1e6, 0, 1024, false);
    QCOMPARE(first.scale, 0.5);
    QVERIFY(first.samples >= 1);
    QCOMPARE(budget.next(4e7, 0, 1024, false).scale, 0.25);  // 15 ns per sample at first: 0.15 s at half
    // Also where the change is not recent, because another frame was in the way.
    QCOMPARE(budget.next(1e6, 0, 1024, true).scale, 0.5);
    QCOMPARE(budget.next(1e6, 8, 1024, false).scale, 1.0);
  }

  void fastMachineTakesAllSamplesItMay() {
    FrameBudget budget;
    for (int i = 0; i < 20; ++i) budget.record(1e6, 64, 0.5);
    const auto frame = budget.next(1e6, 0, 1024, false);
    QCOMPARE(frame.scale, 1.0);
    QCOMPARE(frame.samples, FrameBudget::maxSamplesPerFrame);
  }

  /// A frame of the samples that were granted fits the budget once the cost is known.
  void grantedSamplesFitTheBudget() {
    for (const double nsPerSample : {0.1, 1.0, 10.0, 35.0}) {
      FrameBudget budget;
      for (int i = 0; i < 30; ++i) budget.record(5e5, 4, nsPerSample * 4 * 5e5 * 1e-6);
      const auto frame = budget.next(5e5, 100, 1024, true);
      QVERIFY(frame.samples == 1 || frame.samples * nsPerSample * 5e5 * 1e-6 <= FrameBudget::restingMs * 1.001);
    }
  }

  /// A step of a slider is visible within a frame of a display of 60 Hz.
  void theFirstFrameIsShort() {
    for (const double nsPerSample : {0.1, 1.0, 10.0}) {
      FrameBudget budget;
      for (int i = 0; i < 30; ++i) budget.record(2e6, 1, nsPerSample * 2e6 * 1e-6);
      const auto frame = budget.next(2e6, 0, 1024, true);
      QVERIFY(frame.samples * nsPerSample * 2e6 * frame.scale * frame.scale * 1e-6 <= 1000.0 / 60);
    }
  }

  void neverMoreThanConvergence() {
    FrameBudget budget;
    for (int i = 0; i < 20; ++i) budget.record(1e4, 64, 0.001);
    QCOMPARE(budget.next(1e4, 1021, 1024, true).samples, 3);
  }
};

GONIO_TEST(FrameBudgetTest)
}  // namespace frame_budget_test

#include "frame_budget_test.moc"
