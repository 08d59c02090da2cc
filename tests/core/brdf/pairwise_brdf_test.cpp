// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/brdf.h"

#include <QTest>
#include <atomic>

#include "tests/support/test_program.h"

namespace pairwise_brdf_test {
using namespace gonio;

class PairwiseBrdfTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The function sees the pair as it was given, and none with a direction below the horizon.
  void asksAboveTheHorizonAlone() {
    std::atomic<int> calls = 0;
    const auto brdf = makePairwiseBrdf([&calls](const Direction& wi, const Direction& wo) {
      ++calls;
      return Rgb(wi.x, wo.y, wi.z * wo.z);
    });
    const Direction above(0.6, 0, 0.8), other(0, 0.8, 0.6), below(0.6, 0, -0.8), grazing(1, 0, -1e-13);
    QCOMPARE(brdf->evaluate(above, other), Rgb(0.6, 0.8, 0.48));
    QCOMPARE(brdf->evaluate(below, above), Rgb(0));
    QCOMPARE(brdf->evaluate(above, below), Rgb(0));
    QCOMPARE(calls.load(), 1);
    QCOMPARE(brdf->evaluate(grazing, other).x, 1.0);  // z = -1e-13 counts as the horizon
    const DirectionPair pairs[] = {{above, other}, {below, other}, {other, above}};
    Rgb values[3];
    brdf->evaluate(pairs, values);
    QCOMPARE(values[0], Rgb(0.6, 0.8, 0.48));
    QCOMPARE(values[1], Rgb(0));
    QCOMPARE(values[2], Rgb(0, 0, 0.48));
  }
};

GONIO_TEST(PairwiseBrdfTest)
}  // namespace pairwise_brdf_test

#include "pairwise_brdf_test.moc"
