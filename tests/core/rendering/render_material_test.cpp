// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_material.h"

#include <QTest>
#include <cmath>

#include "core/math/sampling.h"
#include "tests/support/function_brdf.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace render_material_test {
using namespace gonio;
using namespace gonio::rendering;

/// A GGX surface whose own density is the cosine, of a stated cost.
class PoorlySampled final : public Brdf {
 public:
  explicit PoorlySampled(double roughness) : brdf_(test::ggx(Rgb(0), Rgb(1), roughness, 0.9)) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    brdf_->evaluate(pairs, values);
  }
  bool hasImportanceSampling() const override { return true; }

 private:
  std::unique_ptr<const Brdf> brdf_;
};

/// The density of a material as that of a BRDF.
class Drawn final : public Brdf {
 public:
  explicit Drawn(const RenderMaterial& material) : material_(material) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair>, std::span<Rgb>) const override {}
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return material_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return material_.pdf(wi, wo); }

 private:
  const RenderMaterial& material_;
};

/// Second moment of the estimate of the albedo over the squared albedo; 1 without noise.
template <typename Sampler>
double momentOf(const Brdf& brdf, const Sampler& sampler, const Direction& wo) {
  constexpr std::uint32_t count = 1 << 14;
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const DirectionSample drawn = sampler.sample(wo, {scrambledVanDerCorput(i, 6), scrambledSobol(i, 5)});
    const double estimate = drawn.pdf > 0 ? brdf.evaluate(drawn.wi, wo).x * drawn.wi.z / drawn.pdf : 0;
    sum += estimate / count;
    squares += estimate * estimate / count;
  }
  return squares / (sum * sum);
}

class RenderMaterialTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A density of its own is left where another one has less noise; a good one stays.
  void theDensityWithLessNoiseIsTaken() {
    const Direction wo = fromSpherical(0.6, 1);
    const auto poor = std::make_shared<const PoorlySampled>(0.1);
    const RenderMaterial mended(poor);
    QVERIFY(momentOf(*poor, mended, wo) < 1.3);
    QVERIFY(momentOf(*poor, *poor, wo) > 4);

    const std::shared_ptr<const Brdf> good = test::ggx(Rgb(0), Rgb(1), 0.1, 0.9);
    const RenderMaterial kept(good);
    for (const double angle : {0.1, 0.9, 1.4})
      QCOMPARE(kept.pdf(fromSpherical(angle, 2), wo), good->pdf(fromSpherical(angle, 2), wo));
  }

  /// The density of a material that is known is weighed like one that is made.
  void aKnownLobeIsWeighedToo() {
    const Direction wo = fromSpherical(0.6, 1), wi = fromSpherical(0.5, 3.5);
    const auto poor = std::make_shared<const PoorlySampled>(0.1);
    const auto density = std::make_shared<const TabulatedDensity>(*poor);
    QCOMPARE(RenderMaterial(poor, density).pdf(wi, wo), RenderMaterial(poor).pdf(wi, wo));
    const std::shared_ptr<const Brdf> good = test::ggx(Rgb(0), Rgb(1), 0.1, 0.9);
    QCOMPARE(RenderMaterial(good, std::make_shared<const TabulatedDensity>(*good)).pdf(wi, wo), good->pdf(wi, wo));
  }

  void samplesFollowTheDensity_data() {
    QTest::addColumn<bool>("twoHighlights");
    QTest::addColumn<double>("theta");
    for (const double theta : {0.0, 50.0, 80.0}) {
      QTest::addRow("one highlight, %g", theta) << false << theta;
      QTest::addRow("two highlights, %g", theta) << true << theta;
    }
  }
  /// Pearson's test of a million draws: of a round density in place of the table, and of the table.
  void samplesFollowTheDensity() {
    QFETCH(bool, twoHighlights);
    QFETCH(double, theta);
    const auto wide = test::ggx(Rgb(0.2), Rgb(0.8), 0.3, 0.9), narrow = test::ggx(Rgb(0), Rgb(0.8), 0.03, 0.9);
    const RenderMaterial material(
        std::make_shared<const test::FunctionBrdf>([&](const Direction& wi, const Direction& wo) {
          return wide->evaluate(wi, wo) + (twoHighlights ? narrow->evaluate(wi, wo) : Rgb(0));
        }));
    const auto check = test::checkSampling(Drawn(material), fromSpherical(radians(theta), 0.7), 1 << 20, 1e-5);
    const QByteArray found = "integral " + QByteArray::number(check.integral, 'g', 8) + ", lost " +
                             QByteArray::number(check.lost) + ", p " + QByteArray::number(check.pValue);
    QVERIFY2(check.valid, found);
    QVERIFY2(std::abs(check.integral + check.lost - 1) < 2e-3, found);
    QVERIFY2(check.pValue > 1e-4, found);
    QVERIFY2(check.widerPValue < 1e-9, found);
  }
};

GONIO_TEST(RenderMaterialTest)
}  // namespace render_material_test

#include "render_material_test.moc"
