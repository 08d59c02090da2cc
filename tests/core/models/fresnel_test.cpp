// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.h"

#include <QTest>
#include <cmath>
#include <complex>

#include "core/math/types.h"

using namespace gonio;
using namespace gonio::models;

namespace {
/// Mean of the squared s and p amplitudes by Snell's law: the textbook form, which knows nothing of ours.
double fresnelBySnell(double cosI, double eta) {
  const std::complex<double> cosT = std::sqrt(std::complex<double>(1 - (1 - cosI * cosI) / (eta * eta)));
  const auto s = (cosI - eta * cosT) / (cosI + eta * cosT), p = (eta * cosI - cosT) / (eta * cosI + cosT);
  return 0.5 * (std::norm(s) + std::norm(p));
}
}  // namespace

class FresnelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithSnell() {
    for (const double eta : {0.5, 0.9, 1.0001, 1.33, 1.5, 2.4, 10.0, 1000.0})
      for (double theta = 0; theta < 89.95; theta += 0.1) {
        const double c = std::cos(radians(theta));
        QVERIFY(std::abs(fresnelDielectric(c, eta) - fresnelBySnell(c, eta)) < 1e-12);
      }
  }

  void hardCase33Limits() {
    for (double c = 0; c <= 1; c += 1.0 / 64) {
      QVERIFY(std::abs(fresnelSchlick(c, 0) - std::pow(1 - c, 5)) < 1e-15);
      QCOMPARE(fresnelSchlick(c, 1), 1.0);
      QCOMPARE(fresnelDielectric(c, indexFromNormalReflectance(1)), 1.0);
      QCOMPARE(fresnelDielectric(c, 1), 0.0);
      // A huge index: 1 - F is about 2 (c + 1 / c) / eta.
      QVERIFY(c == 0 || fresnelDielectric(c, 1e6) > 1 - 5e-6 / c);
      QVERIFY(fresnelDielectric(c, 1e6) <= 1);
      // Total reflection: sin theta > eta.
      if (std::sqrt(1 - c * c) > 0.8 + 1e-9) QCOMPARE(fresnelDielectric(c, 0.8), 1.0);
    }
    QCOMPARE(fresnelDielectric(0, 1.5), 1.0);
  }

  void indexGivesTheReflectanceBack() {
    for (const double f0 : {0.0, 1e-8, 0.04, 0.2, 0.5, 0.99, 1 - 1e-12, 1.0})
      QVERIFY(std::abs(fresnelDielectric(1, indexFromNormalReflectance(f0)) - f0) < 1e-14);
  }

  /// An index a little above 1 reflects next to nothing: that still has its digits. The textbook form in the longest
  /// arithmetic at hand loses six of its nineteen.
  void noCancellationNearOne() {
    for (const double eta : {1 + 1e-3, 1 + 1e-6})
      for (const double c : {1.0, 0.9, 0.6, 0.3}) {
        const long double n = eta, cosT = std::sqrt(1 - (1 - (long double)c * c) / (n * n));
        const long double s = (c - n * cosT) / (c + n * cosT), p = (n * c - cosT) / (n * c + cosT);
        QVERIFY(std::abs(fresnelDielectric(c, eta) / double((s * s + p * p) / 2) - 1) < 1e-11);
      }
  }
};

QTEST_APPLESS_MAIN(FresnelTest)
#include "fresnel_test.moc"
