// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_vector_sampler.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/baselines/lawrence.h"
#include "core/math/quadrature.h"
#include "tests/core/baselines/baseline_sampling_checks.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace half_vector_sampler_test {
using namespace gonio;
using namespace gonio::baselines;
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
    test::verifyDensity(*brdf, theta);
  }

  void estimatesAreUnbiased() { test::verifyEstimates(*lawrenceOf(0.15), 0.5); }

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
