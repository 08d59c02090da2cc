// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_blend.h"

#include <QTest>
#include <cmath>
#include <functional>

#include "tests/support/test_program.h"

namespace width_blend_test {
using namespace gonio::factorization;

using Curve = std::vector<double>;

/// Close together at 0, as the nodes of |Dp|.
Curve someNodes(int count = 400) {
  Curve nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(2 * std::pow(double(i) / (count - 1), 3));
  return nodes;
}

Curve sampled(const Curve& nodes, const std::function<double(double)>& curve) {
  Curve result;
  for (const double x : nodes) result.push_back(curve(x));
  return result;
}

Curve blend(const Curve& nodes, const std::vector<Curve>& curves, const Curve& weights) {
  return blendedByWidth(nodes, curves, weights);
}

double maxDifference(const Curve& a, const Curve& b) {
  double largest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double bell(double x) { return std::exp(-x * x); }

class WidthBlendTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void widthsAreGeometricMeans() {
    const Curve nodes = someNodes();
    const auto wide = [&](double width) { return sampled(nodes, [&](double x) { return bell(x / width); }); };
    for (const double t : {0.1, 0.5, 0.8}) {
      const double between = std::pow(0.05, 1 - t) * std::pow(0.4, t);
      QVERIFY(maxDifference(blend(nodes, {wide(0.05), wide(0.4)}, {1 - t, t}), wide(between)) < 0.01);
    }
    const double between = std::pow(0.05, 0.2) * std::pow(0.4, 0.5) * std::pow(0.1, 0.3);
    QVERIFY(maxDifference(blend(nodes, {wide(0.05), wide(0.4), wide(0.1)}, {0.2, 0.5, 0.3}), wide(between)) < 0.01);
  }

  /// Curves that do not fall to 0: with the continuous form the blend nears each curve as its weight nears 1, also at
  /// the last node, where the published form jumps.
  void continuousInTheWeights() {
    const Curve nodes = someNodes();
    const std::vector<Curve> curves{sampled(nodes, [](double x) { return 0.3 + 0.7 * bell(x / 0.4); }),
                                    sampled(nodes, [](double x) { return bell(x / 0.1); }),
                                    sampled(nodes, [](double x) { return 0.1 + 0.9 * bell(x / 0.2); })};
    for (std::size_t end = 0; end < curves.size(); ++end) {
      Curve weights(3, 5e-7);
      weights[end] = 1 - 1e-6;
      QVERIFY(maxDifference(blendedByWidth(nodes, curves, weights, BlendForm::continuous), curves[end]) < 1e-4);
    }
    QVERIFY(maxDifference(blendedByWidth(nodes, curves, Curve{1 - 1e-6, 5e-7, 5e-7}), curves[0]) > 0.1);
    const std::vector<Curve> equal(2, curves[0]);
    QVERIFY(maxDifference(blendedByWidth(nodes, equal, Curve{0.5, 0.5}, BlendForm::continuous), curves[0]) < 1e-9);
  }

  /// Also where they rise again, and where they stay at a level.
  void equalCurvesGiveThemselves() {
    const Curve nodes = someNodes(50);
    const std::vector<std::function<double(double)>> curves{bell, [](double x) { return 0.3 + 0.7 * bell(5 * x); },
                                                            [](double x) { return std::max(bell(8 * x), 0.4 * x); },
                                                            [](double) { return 1.0; }};
    for (const auto& curve : curves) {
      const Curve values = sampled(nodes, curve);
      QVERIFY(maxDifference(blend(nodes, {values, values}, {0.3, 0.7}), values) < 1e-9);
      QVERIFY(maxDifference(blend(nodes, {values, sampled(nodes, bell)}, {1, 0}), values) < 1e-9);
    }
  }

  /// Curves of 0 do not count; where all are, so is the blend.
  void hardCase12BlackCurves() {
    const Curve nodes = someNodes(50), values = sampled(nodes, bell), black(50, 0.0);
    QVERIFY(maxDifference(blend(nodes, {black, values}, {0.7, 0.3}), values) < 1e-9);
    QVERIFY(blend(nodes, {black, black}, {0.7, 0.3}) == black);
  }

  /// Heights are 1, values stay between 0 and 1, and what falls in all falls in between.
  void staysInRange() {
    const Curve nodes = someNodes(90);
    const Curve a = sampled(nodes, [](double x) { return 0.05 + 0.95 * bell(30 * x); }),
                b = sampled(nodes, [](double x) { return 3 * (0.6 + 0.4 * bell(2 * x)); }),
                c = sampled(nodes, [](double x) { return bell(3 * x) + 0.5 * bell(6 * (x - 1.5)); });
    const Curve falling = blend(nodes, {a, b}, {0.5, 0.5});
    QVERIFY(std::abs(falling.front() - 1) < 1e-12);
    for (std::size_t i = 1; i < nodes.size(); ++i) QVERIFY(falling[i] <= falling[i - 1] + 1e-12 && falling[i] >= 0);
    for (const double value : blend(nodes, {a, b, c}, {0.2, 0.3, 0.5})) QVERIFY(value >= 0 && value <= 1);
  }
};

GONIO_TEST(WidthBlendTest)
}  // namespace width_blend_test

#include "width_blend_test.moc"
