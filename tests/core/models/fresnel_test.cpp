// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.h"

#include <QTest>
#include <cmath>
#include <complex>

#include "core/math/types.h"
#include "tests/support/test_program.h"

namespace fresnel_test {
using namespace gonio;
using namespace gonio::models;

/// Mean of the squared s and p amplitudes by Snell's law: the textbook form, which knows nothing of ours.
double fresnelBySnell(double cosI, std::complex<double> eta) {
  const std::complex<double> cosT = std::sqrt(1.0 - (1 - cosI * cosI) / (eta * eta));
  const auto s = (cosI - eta * cosT) / (cosI + eta * cosT), p = (eta * cosI - cosT) / (eta * cosI + cosT);
  return 0.5 * (std::norm(s) + std::norm(p));
}
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

  void conductorAgreesWithSnell() {
    for (const double eta : {0.05, 0.2, 1.0, 1.5, 4.0})
      for (const double k : {1e-3, 0.5, 1.0, 3.9, 10.0})
        for (double theta = 0; theta < 89.95; theta += 0.1) {
          const double c = std::cos(radians(theta));
          QVERIFY(std::abs(fresnelConductor(c, eta, k) - fresnelBySnell(c, {eta, k})) < 1e-12);
        }
  }

  void conductorWithoutAbsorptionIsADielectric() {
    for (const double eta : {0.6, 1.2, 1.5, 3.0})
      for (double c = 0; c <= 1; c += 1.0 / 64)
        QVERIFY(std::abs(fresnelConductor(c, eta, 0) - fresnelDielectric(c, eta)) < 1e-12);
  }

  /// Reflectance at normal incidence of evaporated metals at 0.589 um, from their indices (CRC Handbook, three digits).
  void publishedIndicesOfMetals() {
    QVERIFY(std::abs(fresnelConductor(1, 1.44, 7.12) - 0.90) < 0.005);  // aluminium
    QVERIFY(std::abs(fresnelConductor(1, 0.47, 2.83) - 0.815) < 0.02);  // gold
    QVERIFY(std::abs(fresnelConductor(1, 0.62, 2.57) - 0.73) < 0.02);   // copper
    // At normal incidence: ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
    QVERIFY(std::abs(fresnelConductor(1, 0.47, 2.83) - (0.53 * 0.53 + 2.83 * 2.83) / (1.47 * 1.47 + 2.83 * 2.83)) <
            1e-14);
  }

  void edgeTintKeepsTheNormalReflectance() {
    for (const double f0 : {0.0, 1e-3, 0.04, 0.5, 0.9, 0.999})
      for (const double tint : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const ComplexIndex index = indexFromEdgeTint(f0, tint);
        QVERIFY(index.eta > 0 && index.k >= 0);
        QVERIFY(std::abs(fresnelConductor(1, index.eta, index.k) - f0) < 1e-12);
        if (tint == 0) QVERIFY(std::abs(index.eta - indexFromNormalReflectance(f0)) < 1e-12 * index.eta);
      }
  }

  void edgeTintBrightensTheEdge() {
    for (const double f0 : {0.04, 0.3, 0.6, 0.9})
      for (const double degrees : {60.0, 80.0, 85.0})
        for (double tint = 0; tint < 0.95; tint += 0.1)
          QVERIFY(Fresnel(FresnelChoice::conductor, f0, tint + 0.1)(std::cos(radians(degrees))) >=
                  Fresnel(FresnelChoice::conductor, f0, tint)(std::cos(radians(degrees))));
  }

  void hardCase33TheChoiceOfTerms() {
    for (const FresnelChoice choice : {FresnelChoice::dielectric, FresnelChoice::conductor, FresnelChoice::schlick})
      for (const double tint : {0.0, 0.5, 1.0}) {
        for (const double f0 : {0.0, 1e-6, 0.04, 0.5, 0.99, 1.0}) {
          const Fresnel fresnel(choice, f0, tint);
          QVERIFY(std::abs(fresnel(1) - f0) < 1e-12);
          if (f0 > 0) QVERIFY(std::abs(fresnel(0) - 1) < 1e-12);
          for (double c = 0; c <= 1; c += 1.0 / 64) QVERIFY(fresnel(c) >= 0 && fresnel(c) <= 1);
        }
        QCOMPARE(Fresnel(choice, 1, tint)(0.3), 1.0);
      }
    QCOMPARE(Fresnel(FresnelChoice::schlick, 0.04, 0)(0.5), fresnelSchlick(0.5, 0.04));
    QCOMPARE(Fresnel(FresnelChoice::conductor, 0.3, 0)(0.5), Fresnel(FresnelChoice::dielectric, 0.3, 0)(0.5));
    QCOMPARE(Fresnel(FresnelChoice::dielectric, 0.04, 1)(0.5), fresnelDielectric(0.5, 1.5));
    // The term of a dielectric is evaluated as a conductor without absorption, which does not cancel either.
    for (const double f0 : {0.0, 1e-12, 1e-6, 0.04, 0.5, 0.999, 1 - 1e-9})
      for (const double c : {0.0, 1e-12, 1e-3, 0.1, 0.5, 0.999, 1.0}) {
        const double expected = fresnelDielectric(c, indexFromNormalReflectance(f0));
        QVERIFY(std::abs(Fresnel(FresnelChoice::dielectric, f0, 0)(c) - expected) <= 1e-11 * expected);
      }
  }

  void transmittanceIsTheRest() {
    for (const double eta : {0.7, 1.0, 1.0001, 1.5, 4.0, 1000.0})
      for (double c = 0; c <= 1; c += 1.0 / 256)
        QVERIFY(std::abs(fresnelTransmittance(c, eta) - (1 - fresnelDielectric(c, eta))) < 1e-14 * std::max(1.0, eta));
    // Toward grazing angles it is 2 c (1 + eta^2) / sqrt(eta^2 - 1), where 1 - F has lost its digits.
    for (const double c : {1e-9, 1e-12})
      QVERIFY(std::abs(fresnelTransmittance(c, 1.5) / (2 * c * 3.25 / std::sqrt(1.25)) - 1) < 1e-8);
    QCOMPARE(fresnelTransmittance(0.5, indexFromNormalReflectance(1)), 0.0);
  }

  void indexGivesTheReflectanceBack() {
    for (const double f0 : {0.0, 1e-8, 0.04, 0.2, 0.5, 0.99, 1 - 1e-12, 1.0})
      QVERIFY(std::abs(fresnelDielectric(1, indexFromNormalReflectance(f0)) - f0) < 1e-14);
    for (const double eta : {1.0, 1.5, 9.8, 100.0})
      QVERIFY(std::abs(indexFromNormalReflectance(normalReflectanceFromIndex(eta)) - eta) < 1e-12 * eta);
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

GONIO_TEST(FresnelTest)
}  // namespace fresnel_test

#include "fresnel_test.moc"
