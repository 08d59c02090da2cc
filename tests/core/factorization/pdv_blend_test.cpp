// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_blend.h"

#include <QTest>
#include <cmath>

#include "core/support/error.h"

using namespace gonio;
using namespace gonio::factorization;

namespace {

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

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = a.size() == b.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

class PdvBlendTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void curvesAreWeightedMeans() {
    const PdvFactors a = factors(1, 0.4), b = factors(3, 1.2), c = blend(a, b, 0.25);
    QCOMPARE(c.terms(), 2);
    for (int l = 0; l < 2; ++l) {
      const auto& [f1, f2, f3] = c.channels[2][std::size_t(l)];
      const PdvTerm &ta = a.channels[2][std::size_t(l)], &tb = b.channels[2][std::size_t(l)];
      for (std::size_t i = 0; i < f1.size(); ++i)
        QVERIFY(std::abs(f1[i] - (0.75 * ta.f1[i] + 0.25 * tb.f1[i])) < 1e-15);
      for (std::size_t i = 0; i < f2.size(); ++i)
        QVERIFY(std::abs(f2[i] - (0.75 * ta.f2[i] + 0.25 * tb.f2[i])) < 1e-15);
      for (std::size_t i = 0; i < f3.size(); ++i)
        QVERIFY(std::abs(f3[i] - (0.75 * ta.f3[i] + 0.25 * tb.f3[i])) < 1e-15);
    }
  }

  void equalMaterialsGiveThemselves() {
    const PdvFactors a = factors(1, 0.4), same = blend(a, a, 0.3);
    for (std::size_t l = 0; l < 2; ++l) {
      QVERIFY(largestDifference(same.channels[0][l].f1, a.channels[0][l].f1) < 1e-15);
      QVERIFY(largestDifference(same.channels[0][l].f2, a.channels[0][l].f2) < 1e-15);
      QVERIFY(largestDifference(same.channels[0][l].f3, a.channels[0][l].f3) < 1e-15);
    }
    QVERIFY(same.highest >= a.highest * (1 - 1e-15));
  }

  void hardCase30WholeWeightsAreExact() {
    const PdvFactors a = factors(1, 0.4), b = factors(3, 1.2, 33, 1);
    QVERIFY(blend(a, b, 0) == a);
    QVERIFY(blend(a, b, 1) == b);
  }

  /// A term is the same when two of its curves change their signs: blending must not see it.
  void signsOfFurtherTermsDoNotMatter() {
    const PdvFactors a = factors(1, 0.4), b = factors(2, 0.4);
    PdvFactors turned = b;
    for (auto& channel : turned.channels) {
      for (double& value : channel[1].f1) value = -value;
      for (double& value : channel[1].f2) value = -value;
    }
    const PdvFactors expected = blend(a, b, 0.5), c = blend(a, turned, 0.5);
    QVERIFY(largestDifference(c.channels[1][1].f1, expected.channels[1][1].f1) < 1e-15);
    QVERIFY(largestDifference(c.channels[1][1].f2, expected.channels[1][1].f2) < 1e-15);
    PdvFactors last = b;
    for (auto& channel : last.channels) {
      for (double& value : channel[1].f1) value = -value;
      for (double& value : channel[1].f3) value = -value;
    }
    QVERIFY(largestDifference(blend(a, last, 0.5).channels[1][1].f3, expected.channels[1][1].f3) < 1e-15);
  }

  /// On other nodes of |Dp| the curves are read between them.
  void nodesThatDiffer() {
    const PdvFactors a = factors(1, 2), b = factors(1, 2, 41), c = blend(a, b, 0.5);
    QVERIFY(c.deviationNodes == a.deviationNodes);
    QVERIFY(largestDifference(c.channels[0][0].f2, a.channels[0][0].f2) < 1e-12);
  }

  /// A further term that one material lacks fades with the weight of the others, at its own shape.
  void countsOfTermsThatDiffer() {
    const PdvFactors a = factors(1, 0.4), b = factors(1, 0.4, 21, 1);
    for (const PdvFactors& c : {blend(a, b, 0.75), blend(b, a, 0.25)}) {
      QCOMPARE(c.terms(), 2);
      const PdvTerm &term = c.channels[0][1], &whole = a.channels[0][1];
      for (std::size_t i = 0; i < term.f1.size(); ++i) QVERIFY(std::abs(term.f1[i] - 0.25 * whole.f1[i]) < 1e-15);
      QVERIFY(largestDifference(term.f2, whole.f2) < 1e-15);
      QVERIFY(largestDifference(term.f3, whole.f3) < 1e-15);
    }
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

QTEST_APPLESS_MAIN(PdvBlendTest)
#include "pdv_blend_test.moc"
