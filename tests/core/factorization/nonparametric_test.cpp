// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/nonparametric.h"

#include <QTest>
#include <cmath>
#include <random>

#include "tests/core/factorization/half_difference_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace nonparametric_test {
using namespace gonio;
using namespace gonio::factorization;
using factorization::test_support::halfDifferenceSamples;
using factorization::test_support::worstAtNodes;

/// A glossy material of the model.
NonparametricFactors someFactors() {
  NonparametricFactors factors;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    NonparametricFactors::Channel& c = factors.channels[channel];
    c.diffuse = 0.2 + 0.1 * double(channel);
    c.specular = 30;
    for (std::size_t i = 0; i < NonparametricFactors::nodes; ++i) {
      const double x = double(i) / 90;
      c.d[i] = std::exp(-8 * x);
      c.f[i] = x < 0.5 ? 0.1 + x : 1.1 - x;
      c.g[i] = std::cos(radians(double(i) + 0.5)) * (1 - 0.6 * x * x);
    }
  }
  return factors;
}

HalfDifferenceSamples samplesOf(const Brdf& brdf) {
  return halfDifferenceSamples(nonparametricAxes(),
                               [&](const auto&, const auto& pair) { return brdf.evaluate(pair.wi, pair.wo); });
}

class NonparametricTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The formula by hand where all factors stand on nodes: theta_h = (30 / 90)^2 90 = 10, theta_d = 20 degrees and
  /// phi_d = 90 degrees, of which both polar angles have the cosine cos 10 cos 20.
  void formulaAtNodes() {
    const NonparametricFactors f = someFactors();
    const DirectionPair at = fromHalfDifference(radians(10), radians(20), halfPi);
    const double cosine = std::cos(radians(10)) * std::cos(radians(20));
    const double position = degrees(std::acos(cosine)) - 0.5;
    const auto node = std::size_t(position);
    const double fraction = position - double(node);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const NonparametricFactors::Channel& c = f.channels[channel];
      const double g = (1 - fraction) * c.g[node] + fraction * c.g[node + 1];
      const double expected = (c.diffuse + c.specular * c.d[30] * c.f[20] * g * g / (cosine * cosine)) / pi;
      const double found = makeNonparametricBrdf(f)->evaluate(at.wi, at.wo)[int(channel)];
      QVERIFY(std::abs(found - expected) < 1e-9 * expected);
    }
  }

  /// Data of the model: the fit comes back to them, slowly at the end.
  void fitsItsOwnData() {
    const HalfDifferenceSamples s = samplesOf(*makeNonparametricBrdf(someFactors()));
    const NonparametricFit fit = fitNonparametric(s, {.maxSweeps = 150, .tolerance = 0});
    for (const std::vector<double>& residuals : fit.residuals) {
      QVERIFY2(residuals.back() < 0.01, qPrintable(QString::number(residuals.back())));
      QVERIFY(residuals.front() > 0.1);
    }
    const double worst = worstAtNodes(s, *makeNonparametricBrdf(fit.factors));
    QVERIFY2(worst < 0.04, qPrintable(QString::number(worst)));
  }

  /// Data that no factors make: the residual falls all the same, and is that of the factors by brute force.
  void residualFallsAndIsTrue() {
    const HalfDifferenceSamples s = halfDifferenceSamples(nonparametricAxes(), [](const auto& at, const auto&) {
      return Rgb(0.1 + 5 * std::exp(-9 * at.thetaH * (1 + at.thetaD * std::cos(2 * at.phiD))));
    });
    const NonparametricFit fit = fitNonparametric(s, {.maxSweeps = 12, .tolerance = 0});
    for (const std::vector<double>& residuals : fit.residuals)
      for (std::size_t i = 1; i < residuals.size(); ++i) QVERIFY(residuals[i] <= residuals[i - 1] * (1 + 1e-12));
    const auto brdf = makeNonparametricBrdf(fit.factors);
    double left = 0, total = 0;
    factorization::test_support::visitNodes(
        s.axes, [&](std::size_t h, std::size_t d, std::size_t p, std::size_t i, const DirectionPair& at) {
          const double cosines = at.wi.z * at.wo.z, x = s.values[i].x * cosines;
          const double weight = projectedMeasure(s, h, d, p) / cosines * std::pow(std::log1p(x) / x, 2);
          left += weight * std::pow((s.values[i].x - brdf->evaluate(at.wi, at.wo).x) * cosines, 2);
          total += weight * x * x;
        });
    QVERIFY(std::abs(std::sqrt(left / total) / fit.residuals[0].back() - 1) < 1e-6);
  }

  void reciprocalAndFinite() {
    const auto brdf = makeNonparametricBrdf(someFactors());
    std::mt19937_64 generator(3);
    for (int i = 0; i < 2000; ++i) {
      const Direction wi = test::randomUpper(generator), wo = test::randomUpper(generator);
      const double a = brdf->evaluate(wi, wo).y, b = brdf->evaluate(wo, wi).y;
      QVERIFY(std::isfinite(a) && a >= 0);
      QVERIFY(std::abs(a - b) < 1e-9 * (1 + a));
    }
    QVERIFY(std::isfinite(brdf->evaluate({1, 0, 0}, {0, 1, 0}).x));  // both at the horizon: G / cos is held
    QCOMPARE(NonparametricFactors::bytes(), std::size_t(3264));
  }

  void hardCase12Black() {
    const HalfDifferenceSamples s =
        halfDifferenceSamples(nonparametricAxes(), [](const auto&, const auto&) { return Rgb(0); });
    QCOMPARE(worstAtNodes(s, *makeNonparametricBrdf(fitNonparametric(s).factors)), 0.0);
  }

  void hardCase14Constant() {
    const HalfDifferenceSamples s =
        halfDifferenceSamples(nonparametricAxes(), [](const auto&, const auto&) { return Rgb(0.3, 0.2, 0.1); });
    const double worst = worstAtNodes(s, *makeNonparametricBrdf(fitNonparametric(s, {.maxSweeps = 20}).factors));
    QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst)));
  }

  void hardCase15Spike() {
    HalfDifferenceSamples s =
        halfDifferenceSamples(nonparametricAxes(), [](const auto&, const auto&) { return Rgb(0); });
    s.values[s.axes.index(0, 20, 5)] = Rgb(1e6);
    const auto brdf = makeNonparametricBrdf(fitNonparametric(s, {.maxSweeps = 10}).factors);
    std::mt19937_64 generator(4);
    for (int i = 0; i < 2000; ++i) {
      const Rgb value = brdf->evaluate(test::randomUpper(generator), test::randomUpper(generator));
      QVERIFY(std::isfinite(value.x) && value.x >= 0);
    }
  }
};

GONIO_TEST(NonparametricTest)
}  // namespace nonparametric_test

#include "nonparametric_test.moc"
