// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_vector_sampler.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/baselines/bilgili.h"
#include "tests/core/baselines/baseline_sampling_checks.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace tensor_half_vector_sampler_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;

std::shared_ptr<const Brdf> bilgiliOf(double roughness) {
  const auto table = bakeTable(*test::ggx(Rgb(0.1, 0.2, 0.05), Rgb(1), roughness, 0.05),
                               {.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60});
  return makeBilgiliBrdf(factorizeBilgili(sampleHalfOut(*table, makeHalfOutAxes(30, 20, 12)), 8));
}

class TensorHalfVectorSamplerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void samplesHaveTheirDensity_data() {
    QTest::addColumn<double>("roughness");
    QTest::addColumn<double>("theta");
    for (const double roughness : {0.15, 0.5})
      for (const double theta : {0.0, 30.0, 60.0, 80.0, 89.0})
        QTest::addRow("%g, %g degrees", roughness, theta) << roughness << theta;
  }
  void samplesHaveTheirDensity() {
    QFETCH(double, roughness);
    QFETCH(double, theta);
    const auto brdf = bilgiliOf(roughness);
    QVERIFY(brdf->hasImportanceSampling());
    test::verifyDensity(*brdf, theta);
  }

  void estimatesAreUnbiased() { test::verifyEstimates(*bilgiliOf(0.15), 0.3); }

  /// A density of one in all half vectors: the probability of a band of theta_h is its fraction of the solid angle.
  void uniformHalfVectors() {
    const HalfOutAxes axes = makeHalfOutAxes(12, 6, 5);
    const TensorHalfVectorSampler sampler(axes, std::vector<double>(axes.size(), 1));
    const Direction wo(0, 0, 1);
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform;
    constexpr int count = 100'000;
    int inside = 0;
    for (int i = 0; i < count; ++i) {
      const DirectionSample s =
          sampler.sample(wo, {0.1 + 0.9 * uniform(generator), uniform(generator), uniform(generator)});
      inside += std::acos(glm::normalize(s.wi + wo).z) < radians(30);
    }
    const double expected = (1 - std::cos(radians(30))) / (1 - std::cos(axes.thetaH.back()));
    QVERIFY2(std::abs(double(inside) / count / expected - 1) < 0.03,
             qPrintable(QString("%1 %2").arg(double(inside) / count).arg(expected)));
    // p(h) / (4 wo . h) with a tenth of cosine-weighted samples.
    const Direction wi = fromSpherical(radians(40), 0.3);
    const double solidAngle = 2 * pi * (1 - std::cos(axes.thetaH.back()));
    QVERIFY(std::abs(sampler.pdf(wi, wo) - (0.1 * wi.z / pi + 0.9 / (solidAngle * 4 * std::cos(radians(20))))) < 1e-9);
  }

  void hardCase40BlackMaterialsAreSampledByTheCosine() {
    const HalfOutAxes axes = makeHalfOutAxes(6, 4, 5);
    const TensorHalfVectorSampler sampler(axes, std::vector<double>(axes.size(), 0));
    const Direction wo(0, 0.6, 0.8);
    const DirectionSample sample = sampler.sample(wo, {0.99, 0.3, 0.7});
    QVERIFY(std::abs(sample.pdf - sample.wi.z / pi) < 1e-12);
  }

  /// Viewers between a black and a lit node use the lit one.
  void oneBlackViewer() {
    const HalfOutAxes axes = makeHalfOutAxes(6, 4, 5);
    std::vector<double> density(axes.size(), 1);
    for (std::size_t h = 0; h < 6; ++h)
      for (std::size_t p = 0; p < 4; ++p) density[axes.index(h, p, 0)] = 0;
    const TensorHalfVectorSampler sampler(axes, density);
    const Direction wo = fromSpherical(axes.thetaO[1] / 2, 0);
    const DirectionSample sample = sampler.sample(wo, {0.5, 0.1, 0.6});
    QVERIFY(sample.pdf > 0 && std::isfinite(sample.pdf));
    QVERIFY(std::abs(sampler.pdf(sample.wi, wo) - sample.pdf) < 1e-12);
  }
};

GONIO_TEST(TensorHalfVectorSamplerTest)
}  // namespace tensor_half_vector_sampler_test

#include "tensor_half_vector_sampler_test.moc"
