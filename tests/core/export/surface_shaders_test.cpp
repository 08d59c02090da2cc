// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/export/shaders/shading_formulas.h"
#include "core/export/shaders/shading_models.h"
#include "core/sampling/directional_albedo.h"
#include "tests/support/function_brdf.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace surface_shaders_test {
using namespace gonio;
using exports::BlenderVersion;
using exports::SurfaceShader;
using exports::SurfaceValues;

constexpr double shaderF0 = 0.04;

/// Gonio's own GGX model: an evaluation that shares no code with the shaders' formulas.
std::unique_ptr<const Brdf> model(double f0, double alpha, const char* fresnel, bool correlated) {
  const models::ModelSpec& spec = models::ggx().spec();
  models::ParameterValues p = models::defaultParameters(spec);
  const auto set = [&](const char* id, double value) { p.values[*spec.find(id)] = Rgb(value); };
  set("diffuse", 0);
  set("specular", 1);
  set("f0", f0);
  set("roughness", alpha);
  set("masking", correlated ? 1 : 0);
  set("fresnel", std::string_view(fresnel) == "schlick" ? 2 : 0);
  return models::ggx().instantiate(p);
}

void expectEqual(const Brdf& found, const std::function<Rgb(const Direction&, const Direction&)>& expected) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 300; ++i) {
    const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
    const Rgb wanted = expected(wi, wo), value = found.evaluate(wi, wo);
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(value[c] - wanted[c]) < 1e-6 * (1 + wanted[c]));
  }
}

/// Largest relative error of energy-weighted values between two BRDFs.
double difference(const Brdf& a, const Brdf& b) {
  std::mt19937_64 random(9);
  double error = 0, energy = 0;
  for (int i = 0; i < 4000; ++i) {
    const Direction wo = test::randomUpper(random), h = test::randomUpper(random);
    const Direction wi = glm::reflect(-wo, glm::normalize(h + Direction(0, 0, 2)));
    if (wi.z < 0.05 || wo.z < 0.3) continue;
    const Rgb x = a.evaluate(wi, wo) * wi.z, y = b.evaluate(wi, wo) * wi.z;
    error += glm::dot(x - y, x - y);
    energy += glm::dot(y, y);
  }
  return std::sqrt(error / energy);
}

const std::vector<std::pair<const char*, const SurfaceShader*>>& shaders() {
  static const std::vector<std::pair<const char*, const SurfaceShader*>> all{
      {"gltf", &exports::gltfShader()},
      {"principled-3", &exports::principledShader(BlenderVersion::v3)},
      {"principled-4", &exports::principledShader(BlenderVersion::v4)},
      {"openpbr", &exports::openPbrShader()},
      {"standard-surface", &exports::standardSurfaceShader()},
      {"unreal", &exports::unrealShader()},
      {"unity", &exports::unityShader()},
  };
  return all;
}

class SurfaceShadersTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A grey metal of glTF is GGX with Schlick's term; a black dielectric the same with F0 = 0.04.
  void gltfIsTheModelOfGgx() {
    SurfaceValues v;
    v.baseColour = Rgb(0.3);
    v.metalness = 1;
    v.roughness = 0.5;
    const auto metal = model(0.3, 0.25, "schlick", true), dielectric = model(shaderF0, 0.25, "schlick", true);
    const auto alike = [](const auto& brdf) {
      return [&brdf](const Direction& wi, const Direction& wo) { return brdf->evaluate(wi, wo); };
    };
    expectEqual(*exports::gltfShader().brdf(v), alike(metal));
    v.metalness = 0;
    v.baseColour = Rgb(0);
    expectEqual(*exports::gltfShader().brdf(v), alike(dielectric));
  }

  /// KHR_materials_clearcoat by hand at normal incidence: 4 % of the coat's lobe, 96 % of the base.
  void theCoatOfGltfTakesFromTheBase() {
    SurfaceValues v{
        .baseColour = Rgb(1, 0.5, 0.25), .metalness = 1, .roughness = 0.7, .coat = 0.5, .coatRoughness = 0.4};
    const Direction up(0, 0, 1);
    const auto peak = [](double alpha) { return 1 / (4 * pi * alpha * alpha); };
    const Rgb found = exports::gltfShader().brdf(v)->evaluate(up, up);
    const Rgb expected = 0.02 * peak(0.16) + 0.98 * peak(0.49) * v.baseColour;
    QVERIFY(glm::length(found - expected) < 1e-9);
  }

  /// The Fresnel term of Blender's shader is that of a dielectric where the colour at normal incidence is; the masking
  /// is separable in Blender 3 and height-correlated in Blender 4.
  void principledIsTheModelOfGgx() {
    SurfaceValues v{.baseColour = Rgb(0), .roughness = 0.6, .specular = 0.5};
    for (const auto version : {BlenderVersion::v3, BlenderVersion::v4}) {
      const auto expected = model(shaderF0, 0.36, "dielectric", version == BlenderVersion::v4);
      expectEqual(*exports::principledShader(version).brdf(v),
                  [&](const Direction& wi, const Direction& wo) { return expected->evaluate(wi, wo); });
    }
  }

  /// A grey metal of Blender 4 has Schlick's term; the tint lowers it at 82 degrees alone.
  void aMetalOfBlender4IsTheModelOfGgx() {
    SurfaceValues v{.baseColour = Rgb(0.3), .metalness = 1, .roughness = 0.5};
    const auto plain = exports::principledShader(BlenderVersion::v4).brdf(v);
    const auto expected = model(0.3, 0.25, "schlick", true);
    expectEqual(*plain, [&](const Direction& wi, const Direction& wo) { return expected->evaluate(wi, wo); });
    v.specularColour = Rgb(0.8);
    const auto tinted = exports::principledShader(BlenderVersion::v4).brdf(v);
    const auto share = [&](double cosine) {
      const double sine = std::sqrt(1 - cosine * cosine);
      const Direction wi(-sine, 0, cosine), wo(sine, 0, cosine);
      return tinted->evaluate(wi, wo).x / plain->evaluate(wi, wo).x;
    };
    QVERIFY(std::abs(share(1.0 / 7) - 0.8) < 1e-9);
    QVERIFY(std::abs(share(1) - 1) < 1e-9);
  }

  /// The coat of Blender 4 by hand at normal incidence: 4 % of its lobe, 96 % of the base, a metal without loss.
  void theCoatOfBlender4TakesFromTheBase() {
    const SurfaceValues v{
        .baseColour = Rgb(1, 0.5, 0.25), .metalness = 1, .roughness = 0.7, .coat = 0.5, .coatRoughness = 0.4};
    const Direction up(0, 0, 1);
    const auto peak = [](double alpha) { return 1 / (4 * pi * alpha * alpha); };
    const Rgb found = exports::principledShader(BlenderVersion::v4).brdf(v)->evaluate(up, up);
    const Rgb expected = 0.02 * peak(0.16) + 0.98 * peak(0.49) * v.baseColour;
    QVERIFY(glm::length(found - expected) < 1e-9);
  }

  /// A white dielectric of Blender 4 reflects what its highlight leaves: all, but for what GGX loses between facets.
  void aWhiteDielectricOfBlender4KeepsTheEnergy() {
    const SurfaceValues v{.baseColour = Rgb(1), .roughness = 0.3, .specular = 0.5};
    const auto brdf = exports::principledShader(BlenderVersion::v4).brdf(v);
    for (const double theta : {0.0, 45.0, 70.0}) {
      const double albedo = directionalAlbedo(*brdf, radians(theta)).x;
      QVERIFY2(std::abs(albedo - 1) < 0.01, qPrintable(QString::number(albedo)));
    }
  }

  /// Burley 2012, eq. 4 at normal incidence of the light and grazing directions of the viewer, by hand.
  void principledDiffuseIsBurleys() {
    const SurfaceValues v{.baseColour = Rgb(0.8), .roughness = 0.5, .specular = 0};
    const Direction up(0, 0, 1), low(std::sqrt(0.96), 0, 0.2);
    const double s = std::pow(0.8, 5), f90 = 0.5 + 2 * 0.5 * (1 + 0.2) / 2;
    const double expected = 0.8 / pi * (1 + (f90 - 1) * s);
    QVERIFY(std::abs(exports::principledShader(BlenderVersion::v3).brdf(v)->evaluate(up, low).x - expected) < 1e-9);
  }

  /// A white mirror-like lobe of MaterialX reflects all light at all angles and widths: that is what the compensation
  /// of multiple scattering is for.
  void whiteLobesOfMaterialXKeepTheEnergy() {
    for (const double alpha : {0.09, 0.36, 1.0}) {
      const auto brdf =
          exports::schlickLobesBrdf({.diffuse = Rgb(0), .lobes = {{exports::GgxAlpha(alpha), Rgb(1), Rgb(1), Rgb(1)}}});
      for (const double theta : {0.0, 45.0, 70.0}) {
        const double albedo = directionalAlbedo(*brdf, radians(theta)).x;
        QVERIFY2(std::abs(albedo - 1) < 0.01, qPrintable(QString::number(albedo)));
      }
    }
  }

  /// A white dielectric reflects what the highlight leaves: no energy is made, and little lost.
  void layersOfMaterialXKeepTheEnergy() {
    for (const SurfaceShader* shader : {&exports::openPbrShader(), &exports::standardSurfaceShader()})
      for (const double coat : {0.0, 1.0}) {
        SurfaceValues v{.baseColour = Rgb(1), .roughness = 0.5, .coat = coat, .coatRoughness = 0.5};
        for (const double theta : {0.0, 60.0}) {
          const double albedo = directionalAlbedo(*shader->brdf(v), radians(theta)).x;
          QVERIFY2(albedo > 0.9 && albedo < 1.03, qPrintable(QString::number(albedo)));
        }
      }
  }

  /// Colours at normal incidence, by hand: OpenPBR's metal and Standard Surface's.
  void metalsHaveTheirColour() {
    const SurfaceValues v{
        .baseColour = Rgb(0.9, 0.5, 0.2), .metalness = 1, .roughness = 0.4, .specularColour = Rgb(0.3)};
    const Direction up(0, 0, 1);
    const double peak = 1 / (4 * pi * std::pow(0.16, 2));
    for (const SurfaceShader* shader : {&exports::openPbrShader(), &exports::standardSurfaceShader()}) {
      const Rgb found = shader->brdf(v)->evaluate(up, up);
      // The compensation: 4 % of the light of a white lobe of this width are lost without it.
      for (int c = 0; c < 3; ++c) {
        const double ratio = found[c] / (peak * v.baseColour[c]);
        QVERIFY2(ratio > 0.999 && ratio < 1.06, qPrintable(QString::number(ratio)));
      }
    }
  }

  /// The tables against an integration that knows nothing of them.
  void tablesOfAlbedos() {
    for (const double alpha : {0.1, 0.5})
      for (const double theta : {0.0, 50.0, 75.0}) {
        const double expected = directionalAlbedo(*model(0.2, alpha, "schlick", true), radians(theta)).x;
        const double found = exports::ggxAlbedo(std::cos(radians(theta)), alpha).at(0.2);
        QVERIFY2(std::abs(found - expected) < 0.004, qPrintable(QString("%1 %2").arg(found).arg(expected)));
      }
    QVERIFY(exports::charlieAlbedo(0.1, 0.1) > exports::charlieAlbedo(0.9, 0.1));
    QVERIFY(exports::charlieAlbedo(0, 1) <= 1);
  }

  /// All but those with layers for the viewer are reciprocal; none is negative, and none reflects below the horizon.
  void shadersAreSane() {
    std::mt19937_64 random(11);
    const SurfaceValues v{.baseColour = Rgb(0.7, 0.4, 0.1),
                          .metalness = 0.4,
                          .roughness = 0.3,
                          .anisotropy = 0.5,
                          .rotation = 0.4,
                          .specular = 0.5,
                          .coat = 0.6,
                          .sheenColour = Rgb(0.2)};
    for (const auto& [name, shader] : shaders()) {
      const auto brdf = shader->brdf(v);
      for (int i = 0; i < 200; ++i) {
        const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
        const Rgb value = brdf->evaluate(wi, wo);
        QVERIFY2(value.x >= 0 && value.y >= 0 && value.z >= 0, name);
        if (brdf->isReciprocal()) QVERIFY2(glm::length(value - brdf->evaluate(wo, wi)) < 1e-9 * (1 + value.x), name);
        QCOMPARE(brdf->evaluate(Direction(wi.x, wi.y, -wi.z), wo).x, 0.0);
      }
    }
  }

  /// A turned grain is the material turned.
  void rotationTurnsTheGrain() {
    for (const auto& [name, shader] : shaders()) {
      if (!shader->isFitted(exports::SurfaceField::anisotropy)) continue;
      SurfaceValues v{.baseColour = Rgb(0.7), .metalness = 0.8, .roughness = 0.5, .anisotropy = 0.6};
      const auto straight = shader->brdf(v);
      v.rotation = 0.7;
      const auto turned = shader->brdf(v);
      const Direction wi = glm::normalize(Direction(0.3, 0.1, 1)), wo = glm::normalize(Direction(-0.2, 0.4, 1));
      QVERIFY2(std::abs(turned->evaluate(test::rotateZ(wi, 0.7), test::rotateZ(wo, 0.7)).x -
                        straight->evaluate(wi, wo).x) < 1e-9,
               name);
      QVERIFY2(std::abs(turned->evaluate(wi, wo).x - straight->evaluate(wi, wo).x) > 1e-4, name);
      // The highlight is wider along the grain.
      const auto tilted = [](double x, double y) { return glm::normalize(Direction(x, y, 1)); };
      const Direction up(0, 0, 1);
      QVERIFY2(straight->evaluate(up, tilted(0.6, 0)).x > straight->evaluate(up, tilted(0, 0.6)).x, name);
    }
  }

  /// A material that is the shader's own is found again.
  void aFitFindsTheShadersOwnMaterial() {
    for (const auto& [name, shader] : shaders()) {
      SurfaceValues v = shader->defaults;
      v.baseColour = Rgb(0.6, 0.3, 0.15);
      v.metalness = 0;
      v.roughness = 0.6;
      if (shader->isFitted(exports::SurfaceField::coat)) {
        v.coat = 0.7;
        v.coatRoughness = 0.25;
      }
      const auto material = shader->brdf(v);
      const auto fitted = shader->brdf(exports::fitSurface(*shader, *material));
      const double found = difference(*fitted, *material);
      QVERIFY2(found < 0.03, qPrintable(QString("%1: %2").arg(name).arg(found)));
    }
  }

  void aFitFindsTheGrain() {
    const SurfaceShader& shader = exports::gltfShader();
    SurfaceValues v = shader.defaults;
    v.baseColour = Rgb(0.9, 0.7, 0.3);
    v.roughness = 0.45;
    v.anisotropy = 0.6;
    v.rotation = 0.5;
    const auto material = shader.brdf(v);
    const double found = difference(*shader.brdf(exports::fitSurface(shader, *material)), *material);
    QVERIFY2(found < 0.05, qPrintable(QString::number(found)));
  }
};

GONIO_TEST(SurfaceShadersTest)
}  // namespace surface_shaders_test

#include "surface_shaders_test.moc"
