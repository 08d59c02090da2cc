// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/math/quadrature.h"
#include "tests/core/models/model_test_support.h"

using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test;

namespace {
using Changes = std::initializer_list<std::pair<std::string_view, double>>;

double red(const Model& model, Changes changes, const Direction& wi, const Direction& wo) {
  return model.instantiate(parametersOf(model, changes))->evaluate(wi, wo).x;
}

bool agrees(double value, double expected, double tolerance = 1e-12) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

constexpr Direction normal{0, 0, 1};
}  // namespace

/// Closed forms, limits and integrals of the models derived from physics.
class AnalyticModelsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void orenNayarWithoutSlopeIsLambert() {
    std::mt19937_64 random(1);
    const auto matte = orenNayar().instantiate(parametersOf(orenNayar(), {{"diffuse", 0.4}, {"roughness", 0}}));
    for (int n = 0; n < 100; ++n)
      QCOMPARE(matte->evaluate(randomDirection(random), randomDirection(random)), Rgb(0.4 / pi));
  }

  /// At normal incidence only A is left; tan(0) sin(0) is no 0/0.
  void hardCase46OrenNayarAtNormalIncidence() {
    const double a = 1 - 0.5 * 0.25 / (0.25 + 0.33);
    for (const double theta : {0.0, 1e-12, 0.7, 1.5})
      QVERIFY(
          agrees(red(orenNayar(), {{"diffuse", pi}, {"roughness", 0.5}}, normal, fromSpherical(theta, 1)), a, 1e-10));
  }

  /// By the angles of the paper, with trigonometry.
  void orenNayarByItsAngles() {
    const double b = 0.45 * 0.09 / (0.09 + 0.09), a = 1 - 0.5 * 0.09 / (0.09 + 0.33);
    for (const double thetaI : {0.3, 1.0})
      for (const double thetaO : {0.2, 1.4})
        for (const double phi : {0.0, 1.0, 3.0}) {
          const double bright = b * std::max(0.0, std::cos(phi)) * std::sin(std::max(thetaI, thetaO)) *
                                std::tan(std::min(thetaI, thetaO));
          QVERIFY(agrees(red(orenNayar(), {{"diffuse", pi}, {"roughness", 0.3}}, fromSpherical(thetaI, 0.5),
                             fromSpherical(thetaO, 0.5 + phi)),
                         a + bright));
        }
  }

  /// With a mirror F = 1 and light from above, rho 4 cos theta_o is D wherever nothing is masked: up to 30 degrees.
  void torranceSparrowFacetsCoverTheSurface() {
    for (const double m : {1e-3, 0.05, 0.12}) {
      const auto brdf =
          torranceSparrow().instantiate(parametersOf(torranceSparrow(), {{"diffuse", 0}, {"roughness", m}, {"f0", 1}}));
      const double area = compositeGaussLegendre(16, 8, 0, std::min(radians(30.0), 8 * m)).integrate([&](double theta) {
        const Direction wo = fromSpherical(2 * theta, 0);
        return brdf->evaluate(normal, wo).x * 4 * wo.z * std::cos(theta) * 2 * pi * std::sin(theta);
      });
      QVERIFY(std::abs(area - 1) < 1e-7);
    }
  }

  void torranceSparrowIsGaussianInTheAngle() {
    const auto at = [](double theta, double choice) {
      return red(torranceSparrow(), {{"diffuse", 0}, {"f0", 1}, {"roughness", 0.2}, {"normalisation", choice}}, normal,
                 fromSpherical(2 * theta, 0)) *
             4 * std::cos(2 * theta);
    };
    for (const double theta : {0.0, 1e-8, 0.1, 0.4}) {
      QVERIFY(agrees(at(theta, 1), std::exp(-theta * theta / 0.04)));
      QVERIFY(agrees(at(theta, 0) / at(0, 0), std::exp(-theta * theta / 0.04)));
    }
  }

  /// Torrance and Sparrow's and Beckmann's facets are the same where the tilt is small.
  void torranceSparrowAndCookTorranceMeet() {
    const double tilt = 2e-3;
    const Changes changes = {{"diffuse", 0}, {"roughness", 2e-3}, {"f0", 0.3}, {"fresnel", 0}};
    QVERIFY(agrees(red(torranceSparrow(), changes, normal, fromSpherical(2 * tilt, 0)),
                   red(cookTorrance(), changes, normal, fromSpherical(2 * tilt, 0)), 1e-4));
  }

  /// Light at 30, viewer at 40 degrees: cos theta_d is 0.8192 exactly, 0.8207 by the projected directions.
  void abcSmoothTakesTheAngleAsChosen() {
    const Direction wi = direction(30, 0), wo = direction(40, 180);
    const Changes plain = {{"diffuse", 0}, {"a", 1}, {"c", 0}, {"fresnel", 2}, {"index-of-refraction", 1}};
    // Schlick with F_0 = 0 is (1 - cos theta_d)^5; C = 0 leaves A F.
    QVERIFY(std::abs(1 - std::pow(red(abcSmooth(), plain, wi, wo), 0.2) - 0.8192) < 5e-5);
    const double projected = red(
        abcSmooth(),
        {{"diffuse", 0}, {"a", 1}, {"c", 0}, {"fresnel", 2}, {"index-of-refraction", 1}, {"fresnel-angle", 1}}, wi, wo);
    QVERIFY(std::abs(1 - std::pow(projected, 0.2) - 0.8207) < 5e-5);
    const glm::dvec2 apart = glm::dvec2(wi) - glm::dvec2(wo);
    QVERIFY(agrees(projected, std::pow(1 - std::sqrt(1 - glm::dot(apart, apart) / 4), 5), 1e-9));
  }

  void abcSmoothIsRadialOnTheDisk() {
    const Changes changes = {{"diffuse", 0}, {"a", 2}, {"b", 500}, {"c", 1.3}, {"index-of-refraction", 1000}};
    const auto brdf = abcSmooth().instantiate(parametersOf(abcSmooth(), changes));
    const Direction wo = direction(40, 0);
    for (const double radius : {0.0, 0.01, 0.2})
      for (const double phi : {0.0, 1.0, 2.5}) {
        const double x = radius * std::cos(phi) - wo.x, y = radius * std::sin(phi);
        const Direction wi(x, y, std::sqrt(1 - x * x - y * y));
        QVERIFY(agrees(brdf->evaluate(wi, wo).x, 2 * std::pow(1 + 500 * radius * radius, -1.3), 0.01));
      }
  }

  /// The extremes of Ngan et al. 2005 and Loew et al. 2012 over 100 materials.
  void hardRangesAdmitPublishedFits() {
    const auto admits = [](const Model& model, std::string_view id, double low, double high) {
      const ParameterSpec& p = model.spec().parameters[model.spec().find(id).value()];
      return p.hardMin <= low && high <= p.hardMax;
    };
    QVERIFY(admits(cookTorrance(), "roughness", 0.00178, 2.0943) && admits(cookTorrance(), "f0", 0.0017, 0.999));
    for (const Model* model : {&abc(), &abcSmooth()}) {
      QVERIFY(admits(*model, "b", 6.559, 8092575) && admits(*model, "c", 0.0143, 2.6681));
      QVERIFY(admits(*model, "a", 0, 5709.7) && admits(*model, "index-of-refraction", 1.039, 99.99961));
    }
  }
};

QTEST_APPLESS_MAIN(AnalyticModelsTest)
#include "analytic_models_test.moc"
