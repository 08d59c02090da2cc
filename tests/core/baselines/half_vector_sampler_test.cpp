// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_vector_sampler.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/baselines/lawrence.h"
#include "core/math/quadrature.h"
#include "tests/support/function_brdf.h"
#include "tests/support/random_directions.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace half_vector_sampler_test {
using namespace gonio;
using namespace gonio::factorization;

std::shared_ptr<const Brdf> lawrenceOf(double roughness) {
  const auto table = bakeTable(*test::ggx(Rgb(0.1, 0.2, 0.05), Rgb(1), roughness, 0.05),
                               {.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60});
  return makeLawrenceBrdf(
      factorizeLawrence(sampleHalfOut(*table, makeHalfOutAxes(30, 10, 12)), {.terms = 3, .products = 2}));
}

class HalfVectorSamplerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The integral below a sampled point is the fraction that was asked for; values are those of the curve.
  void linearDensityIsInverted() {
    const std::vector<double> nodes{0, 0.1, 0.5, 0.6, 2}, values{1, 0, 0, 3, 0.5};
    const LinearDensity density(nodes, values);
    QVERIFY(std::abs(density.integral() - (0.05 + 0 + 0.15 + 2.45)) < 1e-12);
    QCOMPARE(density.at(nodes, 0.05), 0.5);
    QCOMPARE(density.at(nodes, 2.1), 0.0);
    for (int i = 0; i <= 100; ++i) {
      const double u = i / 100.0, x = density.sample(nodes, u);
      double below = 0;
      for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
        if (const double end = std::min(x, nodes[k + 1]); end > nodes[k])
          below += (end - nodes[k]) * (density.at(nodes, nodes[k]) + density.at(nodes, end)) / 2;
      QVERIFY2(std::abs(below / density.integral() - u) < 1e-12, qPrintable(QString("%1 %2").arg(u).arg(x)));
    }
    const LinearDensity nothing(nodes, {0, 0, 0, 0, 0});
    QCOMPARE(nothing.integral(), 0.0);
    QVERIFY(std::isfinite(nothing.sample(nodes, 0.5)));
  }

  /// Samples have the density that is stated; with those that are lost it integrates to 1.
  void samplesHaveTheirDensity_data() {
    QTest::addColumn<double>("roughness");
    QTest::addColumn<double>("theta");
    for (const double roughness : {0.15, 0.5})
      for (const double theta : {0.0, 30.0, 60.0, 80.0})
        QTest::addRow("%g, %g degrees", roughness, theta) << roughness << theta;
  }
  void samplesHaveTheirDensity() {
    QFETCH(double, roughness);
    QFETCH(double, theta);
    const auto brdf = lawrenceOf(roughness);
    const auto check = test::checkSampling(*brdf, fromSpherical(radians(theta), 0.7), 1 << 17, 1e-4);
    QVERIFY(check.valid);
    QVERIFY2(std::abs(check.integral + check.lost - 1) < 6e-3,
             qPrintable(QString("%1 %2").arg(check.integral).arg(check.lost)));
    QVERIFY2(check.pValue > 1e-4, qPrintable(QString::number(check.pValue)));
  }

  /// Wherever the BRDF is positive directions are sampled, and estimates of the albedo agree with a quadrature of
  /// cosine-weighted samples, with less noise.
  void estimatesAreUnbiased() {
    const auto brdf = lawrenceOf(0.15);
    const Direction wo = fromSpherical(radians(40), 1.1);
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> uniform;
    const auto moments = [&](const auto& draw) {
      double sum = 0, squares = 0;
      constexpr int count = 200'000;
      for (int i = 0; i < count; ++i) {
        const glm::dvec3 u(uniform(generator), uniform(generator), uniform(generator));
        const DirectionSample s = draw(u);
        const double value = s.pdf > 0 ? brdf->evaluate(s.wi, wo).y * s.wi.z / s.pdf : 0;
        sum += value / count;
        squares += value * value / count;
      }
      return std::pair(sum, std::sqrt(squares - sum * sum));
    };
    const auto own = moments([&](const glm::dvec3& u) { return brdf->sample(wo, u); });
    const auto cosine = moments([&](const glm::dvec3& u) { return test::lambert(Rgb(1)).sample(wo, u); });
    QVERIFY2(std::abs(own.first / cosine.first - 1) < 0.02,
             qPrintable(QString("%1 %2").arg(own.first).arg(cosine.first)));
    QVERIFY2(own.second < 0.5 * cosine.second, qPrintable(QString("%1 %2").arg(own.second).arg(cosine.second)));
    for (int i = 0; i < 2000; ++i) {
      const Direction wi = test::randomUpper(generator);
      if (maxChannel(brdf->evaluate(wi, wo)) > 0) QVERIFY(brdf->pdf(wi, wo) > 0);
    }
  }

  void hardCase40BlackMaterialsAreSampledByTheCosine() {
    const HalfOutAxes axes = makeHalfOutAxes(6, 4, 5);
    const std::vector<double> none(6, 0), azimuth(4, 0), viewer(5, 0);
    const HalfVectorSampler sampler(axes, {{none, azimuth, viewer}});
    const Direction wo(0, 0.6, 0.8);
    const DirectionSample sample = sampler.sample(wo, {0.99, 0.3, 0.7});
    QVERIFY(std::abs(sample.pdf - sample.wi.z / pi) < 1e-12);
  }
};

GONIO_TEST(HalfVectorSamplerTest)
}  // namespace half_vector_sampler_test

#include "half_vector_sampler_test.moc"
