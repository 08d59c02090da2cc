// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_blend.h"

#include <QTest>
#include <cmath>
#include <tuple>

#include "core/factorization/pdv_operations.h"
#include "core/support/error.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace pdv_blend_test {
using namespace gonio;
using namespace gonio::factorization;

/// Two terms whose curves are simple functions; `width` of the first term's F2.
PdvFactors factors(double strength, double width, int nodes = 21, int terms = 2) {
  PdvFactors f;
  for (int i = 0; i < 5; ++i) f.thetaNodes.push_back(0.3 * i);
  for (int j = 0; j < nodes; ++j) f.deviationNodes.push_back(2.0 * j / (nodes - 1));
  for (int k = 0; k < 7; ++k) f.phiNodes.push_back(pi * k / 6);
  f.highest = 3 * strength;
  for (auto& channel : f.channels)
    for (int l = 0; l < terms; ++l) {
      PdvTerm term;
      for (const double theta : f.thetaNodes) term.f1.push_back(l == 0 ? strength * (1 + theta) : 0.1 * strength);
      for (const double d : f.deviationNodes)
        term.f2.push_back(l == 0 ? std::max(0.0, 1 - d / width) : std::cos(3 * d));
      for (const double phi : f.phiNodes) term.f3.push_back(l == 0 ? 1 : std::cos(phi));
      channel.push_back(term);
    }
  return f;
}

PdvFactors blend(const PdvFactors& a, const PdvFactors& b, double t) {
  const PdvFactors* ends[] = {&a, &b};
  const double weights[] = {1 - t, t};
  return blended(ends, weights);
}

double maxDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

class PdvBlendTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void firstTermIsBlendedCurveByCurve() {
    const PdvFactors a = factors(1, 0.4), b = factors(3, 1.2), c = blend(a, b, 0.25);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto& [f1, f2, f3] = c.channels[channel][0];
      const PdvTerm &ta = a.channels[channel][0], &tb = b.channels[channel][0];
      for (std::size_t i = 0; i < f1.size(); ++i)
        QVERIFY(std::abs(f1[i] - (0.75 * ta.f1[i] + 0.25 * tb.f1[i])) < 1e-15);
      for (std::size_t i = 0; i < f3.size(); ++i)
        QVERIFY(std::abs(f3[i] - (0.75 * ta.f3[i] + 0.25 * tb.f3[i])) < 1e-15);
      const std::vector<double> shapes[] = {ta.f2, tb.f2};
      QVERIFY(f2 == blendedByWidth(a.deviationNodes, shapes, std::vector{0.75, 0.25}));
    }
    QCOMPARE(c.highest, 0.75 * a.highest + 0.25 * b.highest);
  }

  /// A channel that is black, of curves that are 0, dims the other material and leaves its shape.
  void hardCase12BlackDimsOnce() {
    PdvFactors a = factors(1, 0.4), black = factors(3, 1.2);
    for (auto& channel : black.channels)
      for (PdvTerm& term : channel)
        for (std::vector<double>* curve : {&term.f1, &term.f2, &term.f3}) std::fill(curve->begin(), curve->end(), 0.0);
    const PdvFactors c = blend(a, black, 0.25);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const PdvTerm &term = c.channels[channel][0], &ta = a.channels[channel][0];
      for (std::size_t i = 0; i < term.f1.size(); ++i) QVERIFY(std::abs(term.f1[i] - 0.75 * ta.f1[i]) < 1e-15);
      QVERIFY(maxDifference(term.f2, ta.f2) < 1e-9);
      QVERIFY(maxDifference(term.f3, ta.f3) < 1e-15);
    }
  }

  /// The continuous form leaves out no term: near a weight of 1 all terms of the material are there, on the nodes of
  /// the first.
  void continuousBlendsHaveAllTerms() {
    const PdvFactors a = factors(1, 0.4, 21, 15), b = factors(3, 1.2, 33, 15);
    const PdvFactors* ends[] = {&a, &b};
    const std::vector<double> weights{1e-9, 1 - 1e-9};
    QCOMPARE(blended(ends, weights).terms(), maxPdvTerms);
    const PdvFactors c = blended(ends, weights, BlendForm::continuous), there = atNodesOf(a, b);
    QCOMPARE(c.terms(), 29);
    QVERIFY(there.thetaNodes == a.thetaNodes && there.deviationNodes == a.deviationNodes);
    const auto blend = makePdvBrdf(c), own = makePdvBrdf(there);
    for (double theta = 0.05; theta < 1.5; theta += 0.1) {
      const Direction wi = fromSpherical(theta, 0.3), wo = fromSpherical(0.8 * theta, 2.9);
      const Rgb expected = own->evaluate(wi, wo);
      QVERIFY(glm::length(blend->evaluate(wi, wo) - expected) < 1e-5 * (1 + glm::length(expected)));
    }
    QVERIFY(atNodesOf(a, a) == a);
    PdvFactors many = a;
    for (auto& channel : many.channels) channel.resize(std::size_t(maxEvaluatedTerms) + 1, channel[0]);
    QVERIFY_EXCEPTION_THROWN(makePdvBrdf(many), Error);
  }

  /// The others stay, each as strong as its material's weight.
  void furtherTermsFade() {
    const PdvFactors a = factors(1, 0.4), b = factors(3, 1.2, 21, 1), d = factors(2, 0.4, 21, 3);
    const PdvFactors* ends[] = {&a, &b, &d};
    const PdvFactors c = blended(ends, std::vector{0.2, 0.5, 0.3});
    QCOMPARE(c.terms(), 4);
    const std::tuple<int, const PdvTerm*, double> expected[] = {
        {1, &a.channels[1][1], 0.2}, {2, &d.channels[1][1], 0.3}, {3, &d.channels[1][2], 0.3}};
    for (const auto& [at, term, weight] : expected) {
      const PdvTerm& found = c.channels[1][std::size_t(at)];
      for (std::size_t i = 0; i < found.f1.size(); ++i) QVERIFY(std::abs(found.f1[i] - weight * term->f1[i]) < 1e-15);
      QVERIFY(found.f2 == term->f2 && found.f3 == term->f3);
    }
  }

  void equalMaterialsGiveThemselves() {
    const PdvFactors a = factors(1, 0.4);
    const auto brdf = makePdvBrdf(a), same = makePdvBrdf(blend(a, a, 0.3));
    std::mt19937_64 random(1);
    for (int i = 0; i < 200; ++i) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      const double value = brdf->evaluate(wi, wo).x;
      QVERIFY(std::abs(same->evaluate(wi, wo).x - value) < 1e-5 * (1 + value));
    }
  }

  /// An edited F2 of another height: F1 takes it up.
  void heightsOfF2() {
    const PdvFactors a = factors(1, 0.4, 21, 1);
    PdvFactors half = a;
    for (auto& channel : half.channels)
      for (double& value : channel[0].f2) value /= 2;
    const PdvFactors c = blend(a, half, 0.5);
    for (std::size_t i = 0; i < c.thetaNodes.size(); ++i)
      QVERIFY(std::abs(c.channels[0][0].f1[i] - 0.75 * a.channels[0][0].f1[i]) < 1e-12);
    QVERIFY(maxDifference(c.channels[0][0].f2, a.channels[0][0].f2) < 1e-9);
  }

  /// Terms that cancel one another in each material, but not with the other's curves: nothing shoots up in between.
  void termsThatCancelStayBounded() {
    PdvFactors a = factors(1, 0.4, 21, 3), b = a;
    for (auto& channel : a.channels) {
      for (double& value : channel[1].f1) value = 60;
      channel[2] = channel[1];
      for (double& value : channel[2].f1) value = -60;
    }
    for (auto& channel : b.channels) {
      for (double& value : channel[1].f1) value = 60;
      for (double& value : channel[1].f2) value = 1 - value;
      channel[2] = channel[1];
      for (double& value : channel[2].f1) value = -60;
    }
    const auto brdf = makePdvBrdf(blend(a, b, 0.5)), first = makePdvBrdf(blend(a.truncated(1), b.truncated(1), 0.5));
    std::mt19937_64 random(1);
    for (int i = 0; i < 200; ++i) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      QVERIFY(std::abs(brdf->evaluate(wi, wo).x - first->evaluate(wi, wo).x) < 1e-3);
    }
  }

  /// There is room for twenty: the first of each material.
  void maxTerms() {
    const PdvFactors a = factors(1, 0.4, 21, 20), b = factors(2, 0.4, 21, 20), c = blend(a, b, 0.5);
    QCOMPARE(c.terms(), maxPdvTerms);
    for (std::size_t l = 1; l < 20; ++l) {
      const PdvFactors& end = l % 2 == 1 ? a : b;
      QVERIFY(maxDifference(c.channels[0][l].f1, scaled(end.channels[0][(l + 1) / 2].f1, 0.5)) < 1e-15);
    }
  }

  void hardCase30WholeWeightsAreExact() {
    const PdvFactors a = factors(1, 0.4), b = factors(3, 1.2, 33, 1);
    QVERIFY(blend(a, b, 0) == a);
    QVERIFY(blend(a, b, 1) == b);
  }

  /// On other nodes of |Dp| the curves are read between them.
  void nodesThatDiffer() {
    const PdvFactors a = factors(1, 2), b = factors(1, 2, 41), c = blend(a, b, 0.5);
    QVERIFY(c.deviationNodes == a.deviationNodes);
    QVERIFY(maxDifference(c.channels[0][0].f2, a.channels[0][0].f2) < 1e-9);
  }

  void hardCase31MixedFormsAreRefused() {
    const PdvFactors a = factors(1, 0.4);
    PdvFactors other = a;
    other.transform = DataTransform::cosineLog;
    try {
      blend(a, other, 0.5);
      QFAIL("blended two transforms");
    } catch (const Error& error) {
      QVERIFY(QString(error.what()).contains("log-plus and cosine-log"));
    }
    other = a;
    other.form = PdvForm::twoFactors;
    QVERIFY_EXCEPTION_THROWN(blend(a, other, 0.5), Error);
    // At an end as well: what is refused does not depend on where the slider stands.
    QVERIFY_EXCEPTION_THROWN(blend(a, other, 0), Error);
  }
};

GONIO_TEST(PdvBlendTest)
}  // namespace pdv_blend_test

#include "pdv_blend_test.moc"
