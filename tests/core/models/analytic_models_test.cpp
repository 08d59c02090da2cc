// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/math/quadrature.h"
#include "core/models/fresnel.h"
#include "tests/core/models/model_test_support.h"
#include "tests/support/test_program.h"

namespace analytic_models_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;

using Changes = std::initializer_list<std::pair<std::string_view, double>>;

double red(const Model& model, Changes changes, const Direction& wi, const Direction& wo) {
  return model.instantiate(parametersOf(model, changes))->evaluate(wi, wo).x;
}

bool agrees(double value, double expected, double tolerance = 1e-12) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

constexpr Direction normal{0, 0, 1};
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

  void hardCase46BeardMaxwellWithoutOnset() {
    const double thetaD = radians(35);
    for (const double thetaH : {0.0, 0.2}) {
      const Direction h = fromSpherical(thetaH, 0), across(0, 1, 0);
      const Direction wi = std::cos(thetaD) * h + std::sin(thetaD) * across;
      const Direction wo = std::cos(thetaD) * h - std::sin(thetaD) * across;
      const auto at = [&](double omega, double tau) {
        return red(beardMaxwell(), {{"diffuse", 0}, {"volume", 0}, {"omega", omega}, {"tau", tau}}, wi, wo);
      };
      // At Omega = 0 all facets shadow each other, mirror pairs included; far beyond it none, and with a huge tau none.
      QVERIFY(agrees(at(0, 0.8) / at(0, 1e9), std::exp(-2 * thetaD * (1 / 0.8 - 1 / 100.0)), 1e-9));
      QVERIFY(agrees(at(1e-9, 0.8), thetaH == 0 ? at(100, 0.8) : at(0, 0.8), 1e-6));
      const double shadowed = std::exp(-2 * thetaD / 0.8),
                   expected = (1 + thetaH / 0.5 * shadowed) / (1 + thetaH / 0.5);
      QVERIFY(agrees(at(0.5, 0.8) / at(0, 0.8), expected / shadowed, 1e-9));
    }
  }

  /// Back to the light nothing is shadowed: the scan that the model is measured by, F(1) D / 4 / cos^2.
  void beardMaxwellBackToTheLight() {
    for (const double theta : {0.0, 0.3, 0.8}) {
      const Direction w = fromSpherical(theta, 1);
      const double tan2 = std::pow(std::tan(theta), 2), cos2 = std::pow(std::cos(theta), 2);
      const double scan = 0.1 * std::exp(-tan2 / 0.09) / (pi * 0.09 * cos2 * cos2) / (4 * cos2);
      QVERIFY(
          agrees(red(beardMaxwell(), {{"diffuse", 0}, {"volume", 0}, {"f0", 0.1}, {"roughness", 0.3}}, w, w), scan));
    }
  }

  void beardMaxwellVolume() {
    const double value = red(beardMaxwell(), {{"diffuse", 0.3}, {"volume", 0.2}, {"specular", 0}},
                             fromSpherical(0.4, 0), fromSpherical(1.2, 2));
    QVERIFY(agrees(value, (0.3 + 2 * 0.2 / (std::cos(0.4) + std::cos(1.2))) / pi));
  }

  /// Nothing is mirrored or bent at eta = 1 and nothing lost at depth 0: the two lobes of the base, added.
  void hardCase46WeidlichWilkieWithoutACoat() {
    const auto layered = weidlichWilkie().instantiate(parametersOf(
        weidlichWilkie(),
        {{"diffuse", 0.3}, {"specular", 0.6}, {"roughness", 0.25}, {"f0", 0.7}, {"coat-index", 1}, {"absorption", 0}}));
    const auto base = cookTorrance().instantiate(parametersOf(
        cookTorrance(), {{"diffuse", 0.3}, {"specular", 0.6}, {"roughness", 0.25}, {"f0", 0.7}, {"fresnel", 1}}));
    std::mt19937_64 random(2);
    for (int n = 0; n < 1000; ++n) {
      const Direction wi = randomDirection(random), wo = randomDirection(random);
      QVERIFY(agrees(layered->evaluate(wi, wo).x, base->evaluate(wi, wo).x, 1e-11));
    }
  }

  /// The way through the coat against the refraction of a vector library.
  void weidlichWilkieAbsorbsAlongTheRefractedPaths() {
    const auto matte = [](double depth) {
      return weidlichWilkie().instantiate(
          parametersOf(weidlichWilkie(), {{"specular", 0}, {"coat", 0}, {"coat-index", 1.7}, {"absorption", depth}}));
    };
    const auto clear = matte(0), tinted = matte(0.4);
    std::mt19937_64 random(4);
    for (int n = 0; n < 1000; ++n) {
      const Direction wi = randomDirection(random), wo = randomDirection(random), h = glm::normalize(wi + wo);
      const double cosI = -glm::refract(-wi, h, 1 / 1.7).z, cosO = -glm::refract(-wo, h, 1 / 1.7).z;
      QVERIFY(
          agrees(tinted->evaluate(wi, wo).x / clear->evaluate(wi, wo).x, std::exp(-0.4 * (1 / cosI + 1 / cosO)), 1e-9));
    }
  }

  /// A mirror pair by hand, from Snell's angle: the Lambertian base seen through both passages.
  void weidlichWilkieMirrorPair() {
    const double theta = 0.6, inside = std::asin(std::sin(theta) / 1.5), m1 = 0.1, m2 = 0.3;
    const double mirrored = fresnelDielectric(std::cos(theta), 1.5), through = 1 - mirrored;
    const double coat = 0.8 * mirrored / (pi * m1 * m1) / (4 * std::pow(std::cos(theta), 2));
    const double base = 0.5 / (pi * m2 * m2) / (4 * std::pow(std::cos(inside), 2));  // F_2 = 1, nothing is masked
    QVERIFY(agrees(red(weidlichWilkie(),
                       {{"diffuse", 0.2},
                        {"specular", 0.5},
                        {"roughness", m2},
                        {"f0", 1},
                        {"coat", 0.8},
                        {"coat-roughness", m1},
                        {"coat-index", 1.5},
                        {"absorption", 0.3}},
                       fromSpherical(theta, 0), fromSpherical(theta, pi)),
                   coat + through * through * std::exp(-2 * 0.3 / std::cos(inside)) * (0.2 / pi + base), 1e-11));
  }

  void carPaintIsTheSumOfItsLobes() {
    const auto paint = carPaint().instantiate(parametersOf(carPaint(), {{"diffuse", 0.1},
                                                                        {"coat", 0.9},
                                                                        {"coat-roughness", 0.03},
                                                                        {"coat-f0", 0.05},
                                                                        {"flakes", 0.5},
                                                                        {"flakes-roughness", 0.2},
                                                                        {"flakes-f0", 0.6},
                                                                        {"haze", 0.3},
                                                                        {"haze-roughness", 0.6},
                                                                        {"haze-f0", 0.4}}));
    const auto lobe = [](double strength, double roughness, double f0) {
      return cookTorrance().instantiate(
          parametersOf(cookTorrance(),
                       {{"diffuse", 0}, {"specular", strength}, {"roughness", roughness}, {"f0", f0}, {"fresnel", 2}}));
    };
    const auto coat = lobe(0.9, 0.03, 0.05), flakes = lobe(0.5, 0.2, 0.6), haze = lobe(0.3, 0.6, 0.4);
    std::mt19937_64 random(5);
    for (int n = 0; n < 1000; ++n) {
      const Direction wi = randomDirection(random), wo = randomDirection(random);
      const double sum = 0.1 / pi + coat->evaluate(wi, wo).x + flakes->evaluate(wi, wo).x + haze->evaluate(wi, wo).x;
      QVERIFY(agrees(paint->evaluate(wi, wo).x, sum));
    }
  }

  /// The extremes of Ngan et al. 2005 and Löw et al. 2012 over 100 materials.
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

GONIO_TEST(AnalyticModelsTest)
}  // namespace analytic_models_test

#include "analytic_models_test.moc"
