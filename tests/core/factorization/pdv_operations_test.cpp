// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_operations.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/coordinates/projected_deviation.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace pdv_operations_test {
using namespace gonio;
using namespace gonio::factorization;

constexpr int nodeCount = 41;

std::vector<double> evenNodes(double last) {
  std::vector<double> nodes;
  for (int i = 0; i < nodeCount; ++i) nodes.push_back(last * i / (nodeCount - 1));
  return nodes;
}

/// Two terms; the first a Gaussian of the given width in |Dp| and a strength that rises by `rise` with the angle.
PdvFactors gaussian(double width, double rise) {
  PdvFactors f{.form = PdvForm::twoFactors,
               .thetaNodes = evenNodes(1.5),
               .deviationNodes = evenNodes(2),
               .phiNodes = {0},
               .channels = {},
               .highest = 4};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    PdvTerm first{{}, {}, {1}}, second{{}, {}, {1}};
    for (int i = 0; i < nodeCount; ++i) {
      const double dp = f.deviationNodes[std::size_t(i)];
      first.f1.push_back(1 + double(channel) + rise * f.thetaNodes[std::size_t(i)]);
      first.f2.push_back(std::exp(-dp * dp / (width * width)));
      second.f1.push_back(0.1);
      second.f2.push_back(std::cos(dp));
    }
    f.channels[channel] = {first, second};
  }
  return f;
}

double valueAt(const PdvFactors& f, double theta, double deviation) {
  const auto at = fromProjectedDeviation({theta, deviation, 0});
  return std::log1p(makePdvBrdf(f)->evaluate(at.pair.wi, at.pair.wo).y);
}

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

class PdvOperationsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void resamplingGoesThroughTheNodes() {
    const std::vector<double> nodes{0, 1, 3}, curve{2, 4, 8};
    QVERIFY(resampled(nodes, curve, nodes) == curve);
    // A straight line stays one; beyond the ends it is held.
    const std::vector<double> other{-1, 0.5, 2, 3, 9};
    const std::vector<double> read = resampled(nodes, curve, other), expected{2, 3, 6, 8, 8};
    for (std::size_t i = 0; i < expected.size(); ++i) QVERIFY(near(read[i], expected[i], 1e-12));
  }

  void tiltTurnsAboutTheMiddle() {
    const std::vector<double> nodes{1, 2, 5}, curve{3, -3, 3};
    const std::vector<double> expected{2.4, -2.7, 3.6}, turned = tilted(nodes, curve, 0.2);
    for (std::size_t i = 0; i < 3; ++i) QVERIFY(near(turned[i], expected[i], 1e-12));
    QVERIFY(tilted({{0.0}}, {{7.0}}, 1) == std::vector<double>{7});
  }

  void smoothingKeepsConstantsAndRange() {
    for (const double value : smoothed(std::vector<double>(9, 2.5), 3)) QVERIFY(near(value, 2.5, 1e-12));
    std::vector<double> step(20, 0.0);
    std::fill(step.begin() + 10, step.end(), 1.0);
    const std::vector<double> soft = smoothed(step, 2);
    // Odd about the step, rising all the way, flat where it does not reach.
    for (std::size_t i = 0; i < 20; ++i) QVERIFY(near(soft[i] + soft[19 - i], 1, 1e-12));
    for (std::size_t i = 1; i < 20; ++i) QVERIFY(soft[i] >= soft[i - 1]);
    QCOMPARE(soft[2], 0.0);
    // Half of the Gaussian's mass beyond half a node: 1/2 erfc(1 / (2 sqrt(2) 2)) where sums stand for integrals.
    QVERIFY2(near(soft[9], 0.5 * std::erfc(0.25 / std::sqrt(2.0)), 0.01), QByteArray::number(soft[9]));
    QVERIFY(smoothed(step, 0) == step);
  }

  /// Widened by c, the value at c |Dp| is what it was at |Dp|, in all terms.
  void wideningScalesTheDeviation() {
    const PdvFactors f = gaussian(0.5, 0.3), wide = widenF2(f, 1.6);
    for (const double deviation : {0.0, 0.2, 0.35, 0.6}) {
      const double before = valueAt(f, 0.2, deviation), after = valueAt(wide, 0.2, 1.6 * deviation);
      QVERIFY2(near(after, before, 2e-3), QByteArray::number(after) + " " + QByteArray::number(before));
    }
    QCOMPARE(wide.terms(), 2);
    QVERIFY(wide.channels[0][0].f1 == f.channels[0][0].f1);
    QVERIFY(widenF2(f, 1) == f);
    for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
      QVERIFY_EXCEPTION_THROWN(widenF2(f, wrong), Error);
  }

  /// With separable materials a swapped curve is known: the strength of the other, or its width.
  void swapsTakeOneCurve() {
    const PdvFactors f = gaussian(0.5, 0.3), other = gaussian(0.2, -0.2);
    const PdvFactors strength = withF1Of(f, other), width = withF2Of(f, other);
    for (const PdvFactors* swapped : {&strength, &width}) QCOMPARE(swapped->terms(), 1);
    for (const double theta : {0.15, 0.6})
      for (const double deviation : {0.05, 0.2, 0.3}) {
        const double ofF = std::exp(-deviation * deviation / 0.25), ofOther = std::exp(-deviation * deviation / 0.04);
        QVERIFY(near(valueAt(strength, theta, deviation), (2 - 0.2 * theta) * ofF, 0.01));
        QVERIFY(near(valueAt(width, theta, deviation), (2 + 0.3 * theta) * ofOther, 0.01));
      }
    const PdvFactors kept = withF2Of(f, other, FurtherTerms::preserve);
    QCOMPARE(kept.terms(), 2);
    QVERIFY(kept.channels[1][1] == f.channels[1][1] && kept.channels[1][0] == width.channels[1][0]);
    QVERIFY(withF1Of(f, f) == f.truncated(1));
    QVERIFY(withF2Of(f, f, FurtherTerms::preserve) == f);
  }

  /// From other nodes the curve is read between them.
  void swapsResample() {
    const PdvFactors f = gaussian(0.5, 0);
    PdvFactors other = gaussian(0.3, 0);
    for (double& node : other.deviationNodes) node *= 1.1;
    const PdvFactors swapped = withF2Of(f, other);
    QVERIFY(swapped.deviationNodes == f.deviationNodes);
    // The curve of `other` is a Gaussian of width 0.33 over its stretched nodes.
    for (std::size_t j = 0; j < f.deviationNodes.size(); ++j) {
      const double dp = f.deviationNodes[j] / 0.33;
      QVERIFY(near(swapped.channels[0][0].f2[j], std::exp(-dp * dp), 0.01));
    }
  }

  void differentTransformsDoNotMix() {
    PdvFactors other = gaussian(0.5, 0);
    other.transform = DataTransform::root;
    QVERIFY_EXCEPTION_THROWN(withF1Of(gaussian(0.5, 0), other), Error);
  }

  /// The bound on the model must not cut what an edit asks for.
  void editsGetRoom() {
    PdvFactors f = gaussian(0.5, 0).truncated(1);
    for (auto& channel : f.channels) channel[0].f1 = scaled(channel[0].f1, 3);
    QVERIFY(near(valueAt(f, 0.1, 0), 4, 1e-6));
    QVERIFY(near(valueAt(withRoomForEdits(f), 0.1, 0), 6, 1e-5));
    QVERIFY(near(valueAt(withF1Of(gaussian(0.5, 0), f), 0.1, 0), 6, 1e-5));
    QVERIFY(withRoomForEdits(gaussian(0.5, 0)) == gaussian(0.5, 0));
  }
};

GONIO_TEST(PdvOperationsTest)
}  // namespace pdv_operations_test

#include "pdv_operations_test.moc"
