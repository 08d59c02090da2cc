// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "tests/core/models/model_test_support.h"
#include "tests/support/test_program.h"

namespace model_limits_test {
using namespace gonio;
using namespace gonio::models;
using namespace gonio::models::test_support;

double red(const Model& model, std::initializer_list<std::pair<std::string_view, double>> changes, const Direction& wi,
           const Direction& wo) {
  return model.instantiate(parametersOf(model, changes))->evaluate(wi, wo).x;
}

/// wo whose half vector with the vertical wi stands `thetaH` from the normal.
Direction atHalfAngle(double thetaH) { return fromSpherical(2 * thetaH, 0); }

bool agrees(double value, double expected, double tolerance = 1e-13) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

constexpr Direction normal{0, 0, 1};
/// Closed forms at the ends of the parameters.
class ModelLimitsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hardCase32RoughnessZeroIsClamped() {
    for (const Model* model : {&ward(), &cookTorrance(), &ggx()})
      for (const double thetaH : {0.0, 1e-6, 1e-4, 0.1}) {
        const double zero = red(*model, {{"roughness", 0}}, normal, atHalfAngle(thetaH));
        QVERIFY(std::isfinite(zero));
        QCOMPARE(zero, red(*model, {{"roughness", 1e-4}}, normal, atHalfAngle(thetaH)));
      }
  }

  /// D = 1/pi: what is left is 1 / (pi (1 + cos theta_i)(1 + cos theta_o)).
  void hardCase32GgxOfRoughnessOneIsUniform() {
    for (const double thetaI : {0.0, 0.5, 1.2})
      for (const double thetaO : {0.0, 0.9, 1.5})
        QVERIFY(agrees(red(ggx(), {{"diffuse", 0}, {"roughness", 1}, {"f0", 1}}, fromSpherical(thetaI, 0),
                           fromSpherical(thetaO, 2)),
                       1 / (pi * (1 + std::cos(thetaI)) * (1 + std::cos(thetaO)))));
  }

  void hardCase32BeckmannOfTheSmallestRoughness() {
    const double thetaH = std::sqrt(2e-10);  // cos theta_h = 1 - 1e-10, tan^2 / m^2 = 2e-2
    const double tan2 = std::pow(std::tan(thetaH), 2), cosH = std::cos(thetaH), cosO = std::cos(2 * thetaH);
    const double distribution = std::exp(-tan2 * 1e8) / (pi * 1e-8 * std::pow(cosH, 4));
    QVERIFY(agrees(red(cookTorrance(), {{"diffuse", 0}, {"roughness", 1e-4}, {"f0", 1}}, normal, atHalfAngle(thetaH)),
                   distribution / (4 * cosO), 1e-9));
    // cos theta_h = 0.5: exp(-3e8) is exactly 0, only the diffuse part is left.
    const Direction wi = fromSpherical(radians(70), 0), wo = fromSpherical(radians(70), radians(20));
    for (const Model* model : {&ward(), &cookTorrance()})
      QCOMPARE(red(*model, {{"diffuse", 0.5 * pi}, {"roughness", 1e-4}}, wi, wo), 0.5);
  }

  void hardCase33FresnelOfTheModels() {
    for (const Model* model : {&cookTorrance(), &ggx()})
      for (const double theta : {0.0, 0.7, 1.5}) {
        const Direction wi = fromSpherical(theta, 0), wo = fromSpherical(theta, pi);
        const double mirror = red(*model, {{"diffuse", 0}, {"f0", 1}}, wi, wo);
        QCOMPARE(red(*model, {{"diffuse", 0}, {"f0", 0}}, wi, wo), 0.0);
        if (theta == 0) QVERIFY(agrees(red(*model, {{"diffuse", 0}, {"f0", 0.3}}, wi, wo), 0.3 * mirror));
      }
    QCOMPARE(red(abc(), {{"diffuse", 0}, {"index-of-refraction", 1}}, normal, normal), 0.0);
    // Schlick's curve with F_0 = 0 and F_1 = 0 is (1 - cos theta_d)^5.
    const auto sgdAt = [](double f0, double f1, double cosD) {
      const double theta = std::acos(cosD);
      return red(sgd(), {{"diffuse", 0}, {"f0", f0}, {"f1", f1}}, fromSpherical(theta, 0), fromSpherical(theta, pi));
    };
    QVERIFY(agrees(sgdAt(0, 0, 0.5) / sgdAt(1, 0, 0.5), std::pow(0.5, 5)));
    QCOMPARE(sgdAt(0, 1, 0.9), 0.0);                      // below 0: clamped
    QVERIFY(agrees(sgdAt(5, 0, 1), 5 * sgdAt(1, 0, 1)));  // above 1: kept, published fits go there
  }

  void hardCase34BlinnPhongAtTheEndsOfTheExponent() {
    const auto at = [](double exponent, double thetaH) {
      return red(blinnPhong(), {{"diffuse", 0}, {"specular", 1}, {"exponent", exponent}, {"normalisation", 2}}, normal,
                 atHalfAngle(thetaH));
    };
    for (const double thetaH : {0.0, 0.3, 0.7}) QVERIFY(agrees(at(0, thetaH), 1, 1e-5));
    QCOMPARE(at(1e5, 0), 1.0);
    QCOMPARE(at(1e5, 0.5), 0.0);
    // cos^n by the exact series of ln cos: -x^2/2 - x^4/12.
    QVERIFY(agrees(at(1e5, 1e-3), std::exp(1e5 * (-0.5e-6 - 1e-12 / 12)), 1e-10));
  }

  void hardCase34PhongAtTheEndsOfTheExponent() {
    const auto at = [](double exponent, double alpha) {
      return red(phong(), {{"diffuse", 0}, {"specular", 1}, {"exponent", exponent}}, normal, fromSpherical(alpha, 0));
    };
    for (const double alpha : {0.0, 0.3, 1.5}) QVERIFY(agrees(at(0, alpha), 1, 1e-5));
    QCOMPARE(at(1e5, 0), 1.0);
    QCOMPARE(at(1e5, 0.5), 0.0);
    QVERIFY(agrees(at(1e5, 1e-3), std::exp(1e5 * (-0.5e-6 - 1e-12 / 12)), 1e-10));
  }

  /// With equal parameters along both axes the form for one.
  void hardCase49EqualAxesAreIsotropic() {
    std::mt19937_64 random(2);
    for (const double roughness : {0.02, 0.2, 1.0})
      for (int n = 0; n < 1000; ++n) {
        const Direction wi = randomDirection(random), wo = randomDirection(random);
        const double one = red(ward(), {{"roughness", roughness}}, wi, wo);
        const double two = red(wardAnisotropic(), {{"roughness-x", roughness}, {"roughness-y", roughness}}, wi, wo);
        QVERIFY(agrees(two, one, 1e-14));
        // Ashikhmin and Shirley's lobe, written out for one exponent.
        const double exponent = 1 / (roughness * roughness);
        const Direction h = glm::normalize(wi + wo);
        const double cosD = glm::length(wi + wo) / 2, power = exponent * std::log(h.z);
        const double lobe = (exponent + 1) / (8 * pi) * std::exp(power) / (cosD * std::max(wi.z, wo.z));
        if (lobe < 1e-300) continue;  // no digits left
        QVERIFY(agrees(red(ashikhminShirley(),
                           {{"diffuse", 0}, {"f0", 1}, {"exponent-x", exponent}, {"exponent-y", exponent}}, wi, wo),
                       lobe, 1e-15 * (10 + exponent)));
      }
  }

  /// The anisotropic microfacets with equal axes are the isotropic ones, whatever the rotation; and closed forms at
  /// normal incidence, where nothing is masked: F / (4 pi alpha_x alpha_y).
  void hardCase49EqualAxesOfMicrofacets() {
    std::mt19937_64 random(2);
    for (const double roughness : {0.02, 0.2, 1.0})
      for (const double masking : {0.0, 1.0})
        for (int n = 0; n < 300; ++n) {
          const Direction wi = randomDirection(random), wo = randomDirection(random);
          const double one = red(ggx(), {{"roughness", roughness}, {"masking", masking}}, wi, wo);
          const auto two = {std::pair<std::string_view, double>{"roughness-x", roughness},
                            {"roughness-y", roughness},
                            {"rotation", 0.7},
                            {"masking", masking}};
          QVERIFY(agrees(red(ggxAnisotropic(), two, wi, wo), one, 1e-11));
        }
    for (const Model* model : {&ggxAnisotropic(), &beckmannAnisotropic()})
      QVERIFY(
          agrees(red(*model, {{"diffuse", 0}, {"f0", 1}, {"roughness-x", 0.1}, {"roughness-y", 0.4}}, normal, normal),
                 1 / (4 * pi * 0.04)));
  }

  /// Lafortune's lobe where the closed form can be read off: C_xy = 0 is a power of both cosines.
  void lafortuneAlongTheNormal() {
    const Direction wi = fromSpherical(0.4, 0), wo = fromSpherical(1.1, 2);
    QVERIFY(
        agrees(red(lafortune(), {{"diffuse", 0}, {"specular", 1}, {"c-xy", 0}, {"c-z", 0.5}, {"exponent", 7}}, wi, wo),
               9 / (2 * pi) * std::pow(wi.z * wo.z, 7)));
    // Backward and flat, not normalised.
    const Direction back = fromSpherical(1.2, 1.6);
    const double base = 0.8 * (back.x * wo.x + back.y * wo.y) + 0.1 * back.z * wo.z;
    const auto flat = {std::pair<std::string_view, double>{"diffuse", 0},
                       {"specular", 1},
                       {"c-xy", 0.8},
                       {"c-z", 0.1},
                       {"exponent", 3},
                       {"normalisation", 1}};
    QVERIFY(agrees(red(lafortune(), flat, back, wo), std::pow(std::max(0.0, base), 3)));
    QCOMPARE(red(lafortune(), {{"diffuse", pi}, {"specular", 1}, {"c-xy", 0}, {"c-z", 0}}, wi, wo), 1.0);
  }

  void edwardsDiskOfExponentZeroIsLambert() {
    for (const double theta : {0.0, 0.7, 1.5})
      QVERIFY(agrees(red(edwardsDisk(), {{"diffuse", 0}, {"specular", 1}, {"exponent", 0}}, fromSpherical(0.6, 1),
                         fromSpherical(theta, 2)),
                     1 / pi, 1e-5));
    // In the plane of incidence: the way from sin theta_o at the mirror side to the rim is 1 - sin, backward 1 + sin.
    const double s = std::sin(0.5), toward = (std::sin(0.9) - s) / (1 - s), backward = (s - std::sin(-0.2)) / (1 + s);
    const auto at = [](double theta) {
      return red(edwardsDisk(), {{"diffuse", 0}, {"specular", 1}, {"exponent", 6}}, fromSpherical(theta, pi),
                 fromSpherical(0.5, 0));
    };
    QVERIFY(agrees(at(0.9), 7 / pi * std::pow(1 - toward * toward, 6), 1e-12));
    QVERIFY(agrees(at(-0.2), 7 / pi * std::pow(1 - backward * backward, 6), 1e-12));
  }

  /// Both directions nearly horizontal and on one side: the half vector is horizontal.
  void hardCase37GgxWithAHorizontalHalfVector() {
    const double z = 1e-9, alpha = 0.3, a2 = alpha * alpha;
    const Direction w(std::sqrt(1 - z * z), 0, z);
    const double distribution = a2 / pi;  // alpha^2 / (pi (sin^2 + alpha^2 cos^2)^2) with sin = 1, cos = 0
    QVERIFY(agrees(red(ggx(), {{"diffuse", 0}, {"roughness", alpha}, {"f0", 1}}, w, w), distribution / a2, 1e-7));
  }

  void abcWithoutFalloffIsItsAmplitude() {
    // C = 0: S = A, G = 1 and F = F_0 at normal incidence.
    QVERIFY(agrees(red(abc(), {{"diffuse", 0}, {"a", 7}, {"c", 0}, {"index-of-refraction", 1.5}}, normal, normal),
                   7 * 0.04 / pi));
  }

  void sgdOfPowerZeroIsAnExponential() {
    // p = 0: Gamma(1, alpha) = exp(-alpha), so D at the pole is exp(-alpha) / (pi alpha exp(-alpha)) = 1 / (pi alpha).
    QVERIFY(agrees(red(sgd(), {{"diffuse", 0}, {"specular", 1}, {"alpha", 0.25}, {"p", 0}, {"f0", 1}}, normal, normal),
                   1 / (pi * pi * 0.25)));
  }
};

GONIO_TEST(ModelLimitsTest)
}  // namespace model_limits_test

#include "model_limits_test.moc"
