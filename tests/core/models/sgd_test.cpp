// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/sgd.h"

#include <QFile>
#include <QTest>
#include <cmath>

#include "core/math/quadrature.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace sgd_test {
using namespace gonio;
using namespace gonio::models;

/// D in 1/sr at tan^2 theta_h.
double distribution(double tan2H, double alpha, double p) {
  const double shifted = alpha + tan2H / alpha, logCos2H = -std::log1p(tan2H);
  return std::exp(sgdLogNormalisation(alpha, p) - shifted - p * std::log(shifted) - 2 * logCos2H) / pi;
}

/// The integral of D cos theta_h over the hemisphere, in w = ln(A / alpha), A = alpha + tan^2 / alpha.
double distributionIntegral(double alpha, double p) {
  const double end = std::log1p(800 / alpha);
  return compositeGaussLegendre(16, 200, 0, end).integrate([&](double w) {
    const double tan2 = alpha * alpha * std::expm1(w);
    const double cos2 = 1 / (1 + tan2);
    // cos theta_h d omega_h = pi cos^4 d(tan^2), d(tan^2) = alpha^2 e^w dw.
    return distribution(tan2, alpha, p) * pi * cos2 * cos2 * alpha * alpha * std::exp(w);
  });
}

class SgdTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void normalisationAsPublished() {
    // The red channel of alum-bronze and its tabulated K.
    QVERIFY(std::abs(std::exp(sgdLogNormalisation(0.014832, 0.459076)) / 46.3841 - 1) < 1e-5);
  }

  void hardCase35NormalisedDistribution() {
    for (const auto& [alpha, p] : {std::pair{0.1, 1.0},
                                   {0.1, 1 - 1e-9},
                                   {0.1, 1 + 1e-9},
                                   {1e-5, 1.5},
                                   {0.8, 0.5},
                                   {0.8, 1.776},
                                   {1.6e-5, 1e-13},
                                   {0.014832, 0.459076},
                                   {1e-6, 5.0},
                                   {10.0, 5.0}})
      QVERIFY(std::abs(distributionIntegral(alpha, p) - 1) < 1e-8);
  }

  void hardCase35ContinuousAtTheExponentialIntegral() {
    for (const double alpha : {1e-6, 1e-3, 0.1, 0.854, 3.0}) {
      const double at = sgdLogNormalisation(alpha, 1);
      QVERIFY(std::abs(at + std::log(alpha * -std::expint(-alpha))) < 1e-12);
      for (const double p : {1 - 1e-9, 1 + 1e-9}) QVERIFY(std::abs(sgdLogNormalisation(alpha, p) - at) < 1e-6);
    }
  }

  void hardCase36MaskingInLogSpace() {
    for (const double lambda : {0.0, 1e-12, 1.0, 1.5e7, 1e12})
      for (const double c : {1e-12, 1.0, 1e109, 1e120})
        for (const double k : {0.1, 5.57, 856.0, 2000.0})
          for (const double theta0 : {-halfPi, -0.66, 0.0, 1.2, halfPi}) {
            double previous = 1;
            for (double theta = 0; theta <= halfPi; theta += halfPi / 200) {
              const double g = sgdMasking(theta, lambda, std::log(c), k, theta0);
              QVERIFY(g >= 0 && g <= previous);
              if (theta <= theta0) QCOMPARE(g, 1.0);
              previous = g;
            }
          }
    // The hardest published kind: nothing is shadowed, then everything, within the last degrees.
    QCOMPARE(sgdMasking(1.2, 1, std::log(1e109), 856, 1.2), 1.0);
    QVERIFY(sgdMasking(1.2 + 0.75, 1, std::log(1e109), 856, 1.2) == 0);
    // Where nothing overflows the log form is the plain form.
    QVERIFY(std::abs(sgdMasking(1.2, 2.7, std::log(3e-4), 40, 0.07) -
                     (1 - 2.7 * std::expm1(3e-4 * std::pow(1.2 - 0.07, 40)))) < 1e-12);
  }

  /// All published rows lie inside the hard ranges and evaluate to finite values; our K is the tabulated one.
  void publishedRows() {
    QFile file(GONIO_SHARED_DIR "/data/tables/sgd_merl100.csv");
    if (!file.open(QIODevice::ReadOnly)) QSKIP("the published SGD table is not here");
    constexpr int firstColumn[] = {2, 5, 8, 11, 14, 17, 23, 26, 29, 32}, tabulatedK = 20;
    file.readLine();
    int rows = 0, farFromTable = 0;
    while (!file.atEnd()) {
      const QList<QByteArray> fields = file.readLine().split(',');
      ParameterValues values;
      for (const int column : firstColumn)
        values.values.emplace_back(fields[column].toDouble(), fields[column + 1].toDouble(),
                                   fields[column + 2].toDouble());
      QVERIFY(clampToHardRange(sgd().spec(), values).empty());
      const auto brdf = sgd().instantiate(values);
      for (const double theta : {0.0, 0.3, 1.0, 1.5, 1.5707})
        for (const double phi : {0.0, 2.0, pi}) {
          const Rgb value = brdf->evaluate(fromSpherical(theta, phi), fromSpherical(1.0, 0));
          for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]) && value[c] >= 0);
        }
      for (int c = 0; c < 3; ++c)
        farFromTable += std::abs(std::exp(sgdLogNormalisation(values.values[2][c], values.values[3][c])) /
                                     fields[tabulatedK + c].toDouble() -
                                 1) > 0.01;
      ++rows;
    }
    QCOMPARE(rows, 100);
    QVERIFY2(farFromTable <= 6, qPrintable(QString::number(farFromTable)));
  }
};

GONIO_TEST(SgdTest)
}  // namespace sgd_test

#include "sgd_test.moc"
