// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/models/fresnel.h"
#include "core/models/he_series.h"
#include "tests/core/models/model_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace gonio::models::glsl {
#include "core/models/microfacets.glsl"
}

namespace he_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;

constexpr double wavelengths[] = {0.6114, 0.5491, 0.4643};

/// The series term by term in the order of the paper, with long double.
double seriesByBruteForce(double g, double a) {
  long double sum = 0;
  for (int m = 1; m <= int(20 * (g + std::sqrt(a)) + 400); ++m)
    sum += std::exp(m * std::log((long double)(g)) - g - a / m - std::lgamma((long double)(m) + 1)) / m;
  return double(sum);
}

/// t with t exp(t^2 / 2) = c, by bisection.
double visibleByBisection(double c) {
  double low = 0, high = 50;
  for (int step = 0; step < 200; ++step) {
    const double middle = (low + high) / 2;
    (middle * std::exp(middle * middle / 2) < c ? low : high) = middle;
  }
  return low;
}

/// The directional-diffuse part as in the paper: vectors s and p of both directions (eq. 76), v = k_r - k_i, S of eq.
/// 23 to 25 with the exponential of the errata.
double byThePaper(const Direction& wi, const Direction& wo, double sigma0, double tau, double lambda, double fresnel) {
  const Direction n{0, 0, 1}, ki = -wi, kr = wo;
  const auto tangent = [](const Direction& w) { return std::hypot(w.x, w.y) / w.z; };
  const auto openings = [&](const Direction& w) { return tangent(w) * std::erfc(tau / (2 * sigma0 * tangent(w))); };
  const auto shadowing = [&](const Direction& w) {
    const double x = tau / (2 * sigma0 * tangent(w)), half = std::erfc(x) / 2;
    return (1 - half) / (std::exp(-x * x) / (2 * std::sqrt(pi) * x) - half + 1);
  };
  const double t = visibleByBisection((openings(wi) + openings(wo)) / 4 / std::sqrt(pi / 2));
  const double sigma = sigma0 / std::sqrt(1 + t * t);
  const Direction si = glm::normalize(glm::cross(ki, n)), sr = glm::normalize(glm::cross(kr, n));
  const Direction pi_ = glm::cross(si, ki), pr = glm::cross(sr, kr), v = kr - ki;
  const auto square = [](double value) { return value * value; };
  const double across = square(glm::dot(glm::cross(kr, ki), glm::cross(kr, ki)));
  const double geometry = square(glm::dot(v, v) / v.z) / across *
                          (square(glm::dot(sr, ki)) + square(glm::dot(pr, ki))) *
                          (square(glm::dot(si, kr)) + square(glm::dot(pi_, kr)));
  const double k = 2 * pi / lambda, g = square(k * sigma * (wi.z + wo.z));
  const double a = square(k * tau) * (v.x * v.x + v.y * v.y) / 4;
  const double d = square(pi * tau / (2 * lambda)) * seriesByBruteForce(g, a);
  return fresnel * geometry * shadowing(wi) * shadowing(wo) * d / (pi * wi.z * wo.z);
}

ParameterValues lobe(double sigma, double tau) {
  return parametersOf(he(), {{"diffuse", 0},
                             {"specular", 1},
                             {"roughness", sigma},
                             {"correlation-length", tau},
                             {"index-of-refraction", 1000}});
}

class HeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void seriesIsTheSumOfItsTerms() {
    for (const double g : {1e-3, 0.1, 1.0, 7.0, 20.0, 26.0, 60.0, 400.0})
      for (const double a : {0.0, 1e-3, 1.0, 30.0, 500.0, 5000.0}) {
        // Other channels, with terms of other orders, have their own sums.
        const Rgb found = heSeries(Rgb(2 * g, g, 0.01), Rgb(a / 3, a, 1));
        for (const auto& [value, expected] : {std::pair{found.x, seriesByBruteForce(2 * g, a / 3)},
                                              {found.y, seriesByBruteForce(g, a)},
                                              {found.z, seriesByBruteForce(0.01, 1)}})
          QVERIFY2(std::abs(value - expected) <= 1e-7 * expected,
                   qPrintable(QString("%1 %2: %3 %4").arg(g).arg(a).arg(value).arg(expected)));
      }
  }

  /// Of a very rough surface the heights are all that counts: exp(-a / g) / g.
  void seriesOfARoughSurfaceIsAGaussian() {
    for (const double a : {0.0, 1e5, 1e6}) {
      const double g = 1e6;
      QVERIFY(std::abs(heSeries(Rgb(g), Rgb(a)).x * g / std::exp(-a / g) - 1) < 1e-4);
    }
  }

  void visibleRoughnessSolvesItsEquation() {
    QCOMPARE(heVisibleRoughness(0), 1.0);
    for (const double c : {1e-6, 1e-3, 0.1, 0.9, 1.0, 1.7, 10.0, 1e6, 1e18}) {
      const double t = visibleByBisection(c);
      QVERIFY2(std::abs(heVisibleRoughness(c) * (1 + t * t) - 1) < 1e-10, qPrintable(QString::number(c)));
    }
  }

  void isTheFormulaOfThePaper() {
    std::mt19937_64 random(11);
    for (const auto& [sigma, tau] :
         {std::pair(0.05, 1.0), std::pair(0.28, 1.77), std::pair(0.2, 3.0), std::pair(1.0, 4.0)}) {
      const auto brdf = he().instantiate(lobe(sigma, tau));
      for (int i = 0; i < 60; ++i) {
        const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
        if (wi.z < 0.02 || wo.z < 0.02) continue;
        const double cosD = glm::dot(wi, glm::normalize(wi + wo));
        const double fresnel = fresnelDielectric(cosD, 1000);
        const Rgb value = brdf->evaluate(wi, wo);
        for (int c = 0; c < 3; ++c) {
          const double expected = byThePaper(wi, wo, sigma, tau, wavelengths[c], fresnel);
          QVERIFY2(std::abs(value[c] - expected) <= 1e-6 * expected + 1e-14,
                   qPrintable(QString("%1: %2, expected %3").arg(i).arg(value[c]).arg(expected)));
        }
      }
    }
  }

  /// Geometrical optics: D F / (4 cos theta_i cos theta_o) of Beckmann with the slope 2 sigma / tau, where nothing is
  /// hidden, for all colours.
  void roughSurfaceIsBeckmann() {
    const double sigma = 15, tau = 300, slope = 2 * sigma / tau;
    const auto brdf = he().instantiate(lobe(sigma, tau));
    for (const double angle : {0.0, 5.0, 10.0, 15.0}) {
      const SurfaceGeometry g = surfaceGeometry({direction(20, 0), direction(20 + angle, 180)});
      const double expected =
          glsl::beckmannDistribution(g, 1 / (slope * slope)) * fresnelDielectric(g.cosD, 1000) / (4 * g.cosI * g.cosO);
      const Rgb value = brdf->evaluate(g.wi, g.wo);
      for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(value[c] / expected - 1) < 2e-3, qPrintable(QString::number(value[c] / expected)));
    }
  }

  /// The light that a smooth surface scatters grows as lambda^-4 and with sigma^2 (Rayleigh and Rice).
  void smoothSurfaceScattersAsRayleighRice() {
    const Direction wi = direction(10, 0), wo = direction(20, 180);
    const Rgb one = he().instantiate(lobe(0.001, 0.05))->evaluate(wi, wo),
              two = he().instantiate(lobe(0.002, 0.05))->evaluate(wi, wo);
    QVERIFY(std::abs(two.x / one.x / 4 - 1) < 5e-3);
    QVERIFY(std::abs(one.z / one.x / std::pow(wavelengths[0] / wavelengths[2], 4) - 1) < 5e-3);
  }
};

GONIO_TEST(HeTest)
}  // namespace he_test

#include "he_test.moc"
