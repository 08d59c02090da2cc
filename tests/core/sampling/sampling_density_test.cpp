// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/fitted_densities.h"

#include <QTest>
#include <cmath>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/math/sampling.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace sampling_density_test {
using namespace gonio;

const SamplingDensity densities[] = {{0.1, 0.5}, {0.3, 0.95}, {0.6, 0.3}, {1, 0.8}, {0.5, 0}};

DirectionSample draw(const SamplingDensity& density, const Direction& wo, std::uint32_t i) {
  const glm::dvec2 u = scrambledSobol(i, 5);
  return density.sample(wo, {scrambledVanDerCorput(i, 6), u.x, u.y});
}

/// Integral of the density over a cell of polar angle and azimuth, midpoint rule.
double integrate(const SamplingDensity& density, const Direction& wo, glm::dvec2 theta, glm::dvec2 phi, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double t = theta.x + (theta.y - theta.x) * (i + 0.5) / steps;
      sum += density.pdf(fromSpherical(t, phi.x + (phi.y - phi.x) * (j + 0.5) / steps), wo) * std::sin(t);
    }
  return sum * (theta.y - theta.x) * (phi.y - phi.x) / (double(steps) * steps);
}

/// Over the hemisphere, with the points drawn together at the horizon and at the mirror azimuth, where peaks are
/// narrow.
double integrateAll(const SamplingDensity& density, double thetaO, double phiO) {
  constexpr int steps = 500;
  const Direction wo = fromSpherical(thetaO, phiO);
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double u = (i + 0.5) / steps, v = 2 * (j + 0.5) / steps - 1;
      const double theta = halfPi * (1 - u * u), phi = phiO + pi + pi * v * v * v;
      sum += density.pdf(fromSpherical(theta, phi), wo) * std::sin(theta) * (pi * u) * (3 * pi * v * v);
    }
  return sum * 2 / (double(steps) * steps);
}

/// Mean and spread of the estimate of the albedo with samples of the density.
glm::dvec2 albedoEstimate(const Brdf& brdf, const SamplingDensity& density, const Direction& wo) {
  constexpr std::uint32_t count = 4096;
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const DirectionSample sample = draw(density, wo, i);
    if (!(sample.pdf > 0)) continue;
    const double estimate = brdf.evaluate(sample.wi, wo).x * sample.wi.z / sample.pdf;
    sum += estimate / count;
    squares += estimate * estimate / count;
  }
  return {sum, std::sqrt(std::max(0.0, squares - sum * sum))};
}

class SamplingDensityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// What is missing to 1 are the draws that fail: reflections below the horizon.
  void densityIntegratesToTheShareOfDrawsThatSucceed() {
    for (const SamplingDensity& density : densities)
      for (const double degreesO : {0.0, 30.0, 60.0, 75.0, 85.0, 89.9}) {
        const Direction wo = fromSpherical(radians(degreesO), 0.4);
        constexpr std::uint32_t count = 1 << 16;
        int succeeded = 0;
        for (std::uint32_t i = 0; i < count; ++i) succeeded += draw(density, wo, i).pdf > 0;
        const double integral = integrateAll(density, radians(degreesO), 0.4);
        QVERIFY2(std::abs(integral - double(succeeded) / count) < 1e-3,
                 qPrintable(QString("roughness %1, theta_o %2: %3 of %4")
                                .arg(density.roughness)
                                .arg(degreesO)
                                .arg(integral)
                                .arg(double(succeeded) / count)));
        if (density.specularFraction == 0) QVERIFY(std::abs(integral - 1) < 1e-4);
      }
  }

  /// Pearson's chi-squared test of independent draws against the density.
  void samplesFollowTheDensity() {
    constexpr int rings = 12, spokes = 24, count = 200000;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const SamplingDensity& density : densities)
      for (const double degreesO : {0.0, 40.0, 75.0, 89.0}) {
        const Direction wo = fromSpherical(radians(degreesO), 0);
        std::vector<double> counts(rings * spokes, 0.0);
        for (int n = 0; n < count; ++n) {
          const DirectionSample sample = density.sample(wo, {uniform(random), uniform(random), uniform(random)});
          if (!(sample.pdf > 0)) continue;
          QVERIFY(sample.wi.z > 0 && std::abs(glm::length(sample.wi) - 1) < 1e-9);
          QCOMPARE(sample.pdf, density.pdf(sample.wi, wo));
          const int ring = std::min(rings - 1, int(polarAngle(sample.wi) / halfPi * rings));
          const int spoke = std::min(spokes - 1, int((azimuth(sample.wi) + pi) / (2 * pi) * spokes));
          ++counts[std::size_t(ring * spokes + spoke)];
        }
        double chiSquared = 0;
        int cells = 0;
        for (int cell = 0; cell < rings * spokes; ++cell) {
          const double t = halfPi / rings, p = 2 * pi / spokes;
          const int ring = cell / spokes, spoke = cell % spokes;
          const double expected =
              count * integrate(density, wo, {ring * t, (ring + 1) * t}, {spoke * p - pi, (spoke + 1) * p - pi}, 40);
          if (expected < 5) continue;
          const double difference = counts[std::size_t(cell)] - expected;
          chiSquared += difference * difference / expected;
          ++cells;
        }
        QVERIFY2(chiSquared < cells + 4 * std::sqrt(2.0 * cells),
                 qPrintable(QString("roughness %1, theta_o %2: %3 of %4 cells")
                                .arg(density.roughness)
                                .arg(degreesO)
                                .arg(chiSquared)
                                .arg(cells)));
      }
  }

  void hardCase41EverySampleHasADensity() {
    for (const double roughness : {1e-3, 0.01, 1.0})
      for (const double degreesO : {0.0, 1e-6, 45.0, 89.9, 89.99999}) {
        const Direction wo = fromSpherical(radians(degreesO), 1);
        const SamplingDensity density{roughness, 0.5};
        for (const double a : {0.0, 0.499, 0.5, 1 - 0x1p-32})
          for (const double b : {0.0, 0x1p-32, 0.5, 1 - 0x1p-32})
            for (const double c : {0.0, 0.25, 0.75, 1 - 0x1p-32}) {
              const DirectionSample sample = density.sample(wo, {a, b, c});
              QVERIFY(std::isfinite(sample.pdf) && sample.pdf >= 0);
              if (sample.pdf > 0) QVERIFY(sample.wi.z > 0);
            }
      }
    QCOMPARE((SamplingDensity{0.3, 0.5}.pdf({0, 0.6, -0.8}, {0, 0, 1})), 0.0);
  }

  void lambertNeedsNoHighlight() { QCOMPARE(estimateSamplingDensity(test::lambert(Rgb(0.5))).specularFraction, 0.0); }

  void metalsFindTheirRoughness() {
    for (const double roughness : {0.003, 0.01, 0.05, 0.2}) {
      const SamplingDensity density = estimateSamplingDensity(*test::ggx(Rgb(0), Rgb(1), roughness, 0.9));
      QVERIFY2(density.roughness > roughness / 1.5 && density.roughness < roughness * 1.5,
               qPrintable(QString("%1 of %2").arg(density.roughness).arg(roughness)));
      QVERIFY(density.specularFraction >= 0.9);
    }
  }

  void aMirrorIsSampledWithoutNoise() {
    const auto mirror = test::ggx(Rgb(0), Rgb(1), 1e-3, 0.95);
    const SamplingDensity density = estimateSamplingDensity(*mirror);
    QVERIFY(density.roughness <= 2e-3);
    const glm::dvec2 estimate = albedoEstimate(*mirror, density, fromSpherical(0.5, 0));
    QVERIFY(std::abs(estimate.x - 0.95) < 0.01);
    QVERIFY(estimate.y < 0.5 * estimate.x);
  }

  void plasticIsSampledBetterThanByItsCosine() {
    const auto plastic = test::ggx(Rgb(0.3), Rgb(1), 0.03, 0.04);
    const SamplingDensity density = estimateSamplingDensity(*plastic);
    for (const double theta : {0.2, 0.7, 1.2}) {
      const Direction wo = fromSpherical(theta, 0);
      QVERIFY(albedoEstimate(*plastic, density, wo).y < 0.5 * albedoEstimate(*plastic, {0.3, 0}, wo).y);
    }
  }

  /// A fifth of the cells missing, the sharpest ones among them: still a usable density.
  void tablesWithHoles() {
    const auto whole = bakeTable(*test::ggx(Rgb(0.1), Rgb(1), 0.1, 0.5));
    std::vector<TabulatedBrdf::Value> values(whole->values().begin(), whole->values().end());
    std::vector<std::uint8_t> valid(whole->valid().begin(), whole->valid().end());
    std::mt19937_64 random(2);
    for (std::size_t i = 0; i < valid.size(); ++i)
      if (i < 2 * 90 * 180 || random() % 5 == 0) valid[i] = 0;
    const SamplingDensity density = estimateSamplingDensity(TabulatedBrdf(whole->grid(), values, valid));
    QVERIFY(density.roughness > 0.05 && density.roughness < 0.2 && density.specularFraction > 0.3);
  }

  void blackAndBrokenBrdfsGetADefault() {
    for (const double value : {0.0, -1.0, double(NAN)}) {
      const SamplingDensity density =
          estimateSamplingDensity(test::FunctionBrdf([&](const Direction&, const Direction&) { return Rgb(value); }));
      QVERIFY(density.roughness >= 1e-3 && density.roughness <= 1 && density.specularFraction >= 0 &&
              density.specularFraction <= 0.95);
    }
  }
};

GONIO_TEST(SamplingDensityTest)
}  // namespace sampling_density_test

#include "sampling_density_test.moc"
