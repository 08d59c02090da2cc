// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/fitted_densities.h"

#include <QTest>
#include <cmath>

#include "core/math/sampling.h"
#include "core/sampling/tabulated_density.h"
#include "tests/support/function_brdf.h"
#include "tests/support/grain.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace grain_density_test {
using namespace gonio;

/// A BRDF that draws by the mixture of its tabulated density.
class Sampled final : public Brdf {
 public:
  explicit Sampled(const Brdf& brdf) : density_(brdf) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair>, std::span<Rgb>) const override {}
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override {
    return tabulatedMixture(density_).sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const override { return tabulatedMixture(density_).pdf(wi, wo); }
  const GrainDensity& grain() const { return density_.grain(); }

 private:
  TabulatedDensity density_;
};

class GrainDensityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void isotropicSurfacesHaveNone() {
    QCOMPARE(TabulatedDensity(*test::ggx(Rgb(0.1), Rgb(1), 0.2, 0.5)).grain().fraction, 0.0);
    // One that may be anisotropic, and is not, gains nothing by it.
    const auto round = test::ggx(Rgb(0.1), Rgb(1), 0.2, 0.5);
    const test::FunctionBrdf unsure([&](const Direction& wi, const Direction& wo) { return round->evaluate(wi, wo); },
                                    false);
    const GrainDensity grain = TabulatedDensity(unsure).grain();
    if (grain.fraction > 0) QVERIFY(std::abs(std::log(grain.alphaX / grain.alphaY)) < 0.3);
  }

  /// Of a metal it is the lobe that the surface has.
  void theGrainOfAKnownSurface_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("degrees");
    for (const double degrees : {0.0, 40.0, 100.0, 170.0}) {
      QTest::addRow("0.08 0.4, %g degrees", degrees) << 0.08 << 0.4 << degrees;
      QTest::addRow("0.02 0.2, %g degrees", degrees) << 0.02 << 0.2 << degrees;
    }
  }
  void theGrainOfAKnownSurface() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, degrees);
    GrainDensity grain = TabulatedDensity(*test::grainBrdf({"ggx-anisotropic", x, y, radians(degrees)})).grain();
    const QByteArray found = QByteArray::number(grain.alphaX) + " " + QByteArray::number(grain.alphaY) + ", " +
                             QByteArray::number(gonio::degrees(grain.rotation)) + " degrees, share " +
                             QByteArray::number(grain.fraction);
    if (grain.alphaX > grain.alphaY) {
      std::swap(grain.alphaX, grain.alphaY);
      grain.rotation += halfPi;
    }
    QVERIFY2(grain.fraction >= 0.4, found);
    QVERIFY2(std::abs(std::log(grain.alphaX / x)) < 0.4 && std::abs(std::log(grain.alphaY / y)) < 0.4, found);
    QVERIFY2(std::abs(std::remainder(grain.rotation - radians(degrees), pi)) < 0.5 * x / y, found);
  }

  void hardCase41SamplesFollowTheDensity_data() {
    QTest::addColumn<double>("theta");
    for (const double theta : {0.0, 40.0, 75.0, 88.0}) QTest::addRow("%g", theta) << theta;
  }
  /// A million draws each.
  void hardCase41SamplesFollowTheDensity() {
    QFETCH(double, theta);
    static const Sampled sampled(*test::grainBrdf({"beckmann-anisotropic", 0.1, 0.4, 0.7}));
    QVERIFY(sampled.grain().fraction > 0);
    const auto check = test::checkSampling(sampled, fromSpherical(radians(theta), 0.9), 1 << 20, 1e-5);
    const QByteArray found = "integral " + QByteArray::number(check.integral, 'g', 8) + ", lost " +
                             QByteArray::number(check.lost) + ", p " + QByteArray::number(check.pValue);
    QVERIFY2(check.valid, found);
    QVERIFY2(std::abs(check.integral + check.lost - 1) < 2e-3, found);
    QVERIFY2(check.pValue > 1e-4, found);
    QVERIFY2(check.widerPValue < 1e-9, found);
  }

  /// The estimate of an albedo stays, and its variance falls to less than half of what the mean over the azimuths
  /// gives.
  void estimatesAreUnbiasedWithLessNoise() {
    const auto brdf = test::grainBrdf({"ggx-anisotropic", 0.04, 0.3, 0.6});
    const TabulatedDensity density(*brdf);
    for (const double theta : {0.2, 0.9}) {
      const Direction wo = fromSpherical(theta, 2);
      const auto moments = [&](const auto& sampler) {
        constexpr int count = 1 << 16;
        glm::dvec2 sums(0);
        for (std::uint32_t i = 0; i < count; ++i) {
          const DirectionSample drawn =
              sampler.sample(wo, glm::dvec3(scrambledVanDerCorput(i, 6), scrambledSobol(i, 5)));
          const double estimate = drawn.pdf > 0 ? brdf->evaluate(drawn.wi, wo).x * drawn.wi.z / drawn.pdf : 0;
          sums += glm::dvec2(estimate, estimate * estimate) / double(count);
        }
        return glm::dvec2(sums.x, sums.y - sums.x * sums.x);
      };
      constexpr double cosine = TabulatedDensity::cosineFraction;
      const DensityMixture<CosineDensity, TabulatedDensityView> azimuthMean({cosine, 1 - cosine}, CosineDensity{},
                                                                            TabulatedDensityView{density});
      const glm::dvec2 grain = moments(tabulatedMixture(density)), mean = moments(azimuthMean);
      QVERIFY(std::abs(grain.x / mean.x - 1) < 0.02);
      QVERIFY2(grain.y < 0.5 * mean.y, qPrintable(QString("%1, %2").arg(grain.y).arg(mean.y)));
    }
  }

  void similarGrains() {
    const GrainDensity one{0.05, 0.5, 0.3, 0.7};
    QVERIFY(areSimilar(one, one));
    QVERIFY(areSimilar(one, {0.05, 0.5, 0.3 - pi, 0.7}));
    QVERIFY(!areSimilar(one, {}));
    QVERIFY(!areSimilar(one, {0.1, 0.5, 0.3, 0.7}));
    QVERIFY(!areSimilar(one, {0.05, 0.5, 0.4, 0.7}));
    QVERIFY(areSimilar(GrainDensity{}, {0.1, 0.2, 1, 0}));
  }
};

GONIO_TEST(GrainDensityTest)
}  // namespace grain_density_test

#include "grain_density_test.moc"
