// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/half_vector_densities.h"

#include <QTest>
#include <cmath>

#include "core/brdf/density_mixture.h"
#include "core/math/quadrature.h"
#include "core/sampling/direction_densities.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace visible_normal_density_test {
using namespace gonio;

struct Widths {
  double x, y;
};
constexpr Widths widths[] = {{0.3, 0.3}, {0.05, 0.4}, {0.7, 0.15}, {1, 1}};
constexpr double viewerDegrees[] = {0, 30, 60, 80, 89};

/// A density as samples of a BRDF; the values do not matter.
template <typename Density>
class DensityBrdf final : public Brdf {
 public:
  explicit DensityBrdf(Density density) : mixture_({1.0}, density) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair>, std::span<Rgb>) const override {}
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return mixture_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return mixture_.pdf(wi, wo); }

 private:
  DensityMixture<Density> mixture_;
};

class VisibleNormalDensityTest : public QObject {
  Q_OBJECT
 private:
  /// Integral over the half vectors by the slopes' polar coordinates on the unit disk of widths, which makes both
  /// distributions round.
  template <typename Integrand>
  static double overNormals(const Widths& width, const Integrand& integrand) {
    const QuadratureRule azimuth = compositeGaussLegendre(16, 24, 0, 2 * pi),
                         radius = compositeGaussLegendre(16, 24, 0, halfPi);
    double sum = 0;
    for (std::size_t a = 0; a < azimuth.nodes.size(); ++a)
      sum += azimuth.weights[a] * radius.integrate([&](double angle) {
        const double r = std::tan(angle), c = std::cos(azimuth.nodes[a]), s = std::sin(azimuth.nodes[a]);
        const Direction h = glm::normalize(Direction(width.x * r * c, width.y * r * s, 1));
        // d omega_h = cos^3 theta_h d(slope x) d(slope y)
        return integrand(h) * h.z * h.z * h.z * width.x * width.y * r * (1 + r * r);
      });
    return sum;
  }

 private Q_SLOTS:
  /// The normals' area seen from above is that of the surface: the integral of D cos theta_h is 1; and seen from
  /// anywhere, cos theta (1 + Lambda) is that of D max(0, h . wo), which is how Smith's masking is defined.
  void theDistributionsAreNormalisedAndMaskAsSmithHasIt() {
    for (const Widths& width : widths)
      for (const double degrees : viewerDegrees) {
        const Direction wo = fromSpherical(radians(degrees), 0.6);
        const auto projected = [&](auto density) {
          return overNormals(
              width, [&](const Direction& h) { return density(h, width.x, width.y) * std::max(0.0, glm::dot(h, wo)); });
        };
        const double ggx = projected(ggxDensity), beckmann = projected(beckmannDensity);
        QVERIFY(std::abs(ggx - ggxCosineOverG1(wo, width.x, width.y)) < 2e-4);
        QVERIFY(std::abs(beckmann - beckmannCosineOverG1(wo, width.x, width.y)) < 2e-4);
        if (degrees == 0) QVERIFY(std::abs(ggx - 1) < 1e-6 && std::abs(beckmann - 1) < 1e-6);
      }
  }

  void hardCase01ShadowedCosinesAtTheHorizonAndTheNormal() {
    QCOMPARE(beckmannCosineOverG1({0, 0, 1}, 0.1, 0.3), 1.0);
    QCOMPARE(ggxCosineOverG1({0, 0, 1}, 0.1, 0.3), 1.0);
    QVERIFY(std::abs(beckmannCosineOverG1({1, 0, 0}, 0.1, 0.3) - 0.1 / (2 * std::sqrt(pi))) < 1e-15);
    QVERIFY(std::abs(ggxCosineOverG1({0, 1, 0}, 0.1, 0.3) - 0.15) < 1e-15);
  }

  /// A million draws of the narrow grain at 60 degrees.
  void hardCase41SamplesFollowTheDensity_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("width");
    for (int kind = 0; kind < 2; ++kind)
      for (int width = 0; width < int(std::size(widths)); ++width)
        QTest::addRow("%s %g %g", kind == 0 ? "ggx" : "beckmann", widths[width].x, widths[width].y) << kind << width;
  }
  void hardCase41SamplesFollowTheDensity() {
    QFETCH(int, kind);
    QFETCH(int, width);
    const Widths& at = widths[width];
    const auto check = [&](const auto& density) {
      for (const double degrees : viewerDegrees) {
        const int draws = width == 1 && degrees == 60 ? 1 << 20 : 1 << 15;
        const DensityBrdf sampled(RotatedDensity(density, 0.4));
        const Direction wo = fromSpherical(radians(degrees), 0.9);
        test::SamplingCheck found = test::checkSampling(sampled, wo, draws, 1e-5);
        // Some densities at grazing angles need finer cells for the integral.
        if (std::abs(found.integral - 1) > 5e-5) found = test::checkSampling(sampled, wo, draws);
        const QByteArray where = QByteArray::number(degrees) + " degrees: integral " +
                                 QByteArray::number(found.integral, 'g', 9) + ", p " + QByteArray::number(found.pValue);
        QVERIFY2(found.valid, where);
        QVERIFY2(std::abs(found.integral - 1) < 1e-4, where);
        QVERIFY2(found.pValue > 1e-6, where);
        if (draws == 1 << 20) QVERIFY2(found.widerPValue < 1e-9, where);
      }
    };
    if (kind == 0)
      check(VisibleNormalDensity{at.x, at.y});
    else
      check(BeckmannVisibleDensity{at.x, at.y});
  }
};

GONIO_TEST(VisibleNormalDensityTest)
}  // namespace visible_normal_density_test

#include "visible_normal_density_test.moc"
