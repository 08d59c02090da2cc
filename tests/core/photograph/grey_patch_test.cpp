// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/grey_patch.h"

#include <QTest>

#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace grey_patch_test {
using namespace gonio;
using namespace gonio::photograph;

/// Two distant lights and a small one.
Light threeLights() {
  Light light;
  light.directional = {{glm::normalize(Direction(1, 2, 2)), Rgb(3, 2, 1)}, {Direction(0, 0, -1), Rgb(100)}};
  light.points = {{Direction(0, 3, 4), Rgb(50)}};
  return light;
}

Photograph photographWith(const Light& light, int side = 64) {
  Photograph photograph{.name = "grey", .image = Image(side, side), .disc = {}, .camera = {}, .light = light};
  photograph.disc = discOf(photograph.camera, side, side);
  return photograph;
}

class GreyPatchTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Closed forms: the radiance of the light times pi under a constant environment, cosines under other lights.
  void irradiance() {
    const Light furnace{.environment = rendering::furnaceEnvironment(), .rotation = 0.3};
    const Rgb constant = irradianceOn(furnace, glm::normalize(Direction(1, 2, 3)), Direction(0));
    QVERIFY2(std::abs(constant.y / pi - 1) < 1e-3, QByteArray::number(constant.y));
    const Rgb found = irradianceOn(threeLights(), Direction(0, 0, 1), Direction(0));
    const Rgb expected = Rgb(3, 2, 1) * (2.0 / 3) + Rgb(50.0 / 25 * 0.8);
    QVERIFY(glm::length(found - expected) < 1e-12);
    const Rgb nearer = irradianceOn(threeLights(), Direction(0, 0, 1), Direction(0, 3, 0));
    QVERIFY(glm::length(nearer - (Rgb(3, 2, 1) * (2.0 / 3) + Rgb(50.0 / 16))) < 1e-12);
  }

  /// A turned environment lights as it renders.
  void irradianceOfATurnedEnvironment() {
    const auto studio = rendering::studioEnvironment();
    const Light light{.environment = studio, .rotation = 1.1};
    const Direction normal = glm::normalize(Direction(0.3, 0.2, 1));
    Rgb expected(0);
    const rendering::EnvironmentRotation turn(1.1);
    const int width = 360, height = 180;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Direction direction = rendering::EnvironmentMap::directionAt((x + 0.5) / width, (y + 0.5) / height);
        const double solidAngle = 2 * pi / width * (std::cos(pi * y / height) - std::cos(pi * (y + 1) / height));
        const double cosine = std::max(0.0, glm::dot(direction, normal));
        expected += studio->radiance(turn.toEnvironment(direction)) * (cosine * solidAngle);
      }
    const Rgb found = irradianceOn(light, normal, Direction(0));
    QVERIFY2(glm::length(found / expected - Rgb(1)) < 0.01, QByteArray::number(found.x / expected.x));
  }

  void cardShowsTheExposure() {
    Photograph photograph = photographWith(threeLights());
    const GreyPatch card{.reflectance = 0.5, .x = 10, .y = 20, .width = 8, .height = 6, .normal = {0, 0, 1}};
    const Rgb exposure(2, 3, 4);
    const Rgb radiance = irradianceOn(photograph.light, card.normal, card.position) * (0.5 / pi);
    for (int y = 20; y < 26; ++y)
      for (int x = 10; x < 18; ++x) photograph.image.at(x, y) = glm::vec3(exposure * radiance);
    std::vector<std::string> warnings;
    QVERIFY(glm::length(exposureOf(photograph, card, warnings) - exposure) < 1e-5);
    QVERIFY(warnings.empty());
    GreyPatch elsewhere = card;
    elsewhere.x = 40;
    QVERIFY_THROWS_EXCEPTION(Error, exposureOf(photograph, elsewhere, warnings));
    elsewhere.x = 100;
    QVERIFY_THROWS_EXCEPTION(Error, exposureOf(photograph, elsewhere, warnings));
    GreyPatch turned = card;
    turned.normal = {0, -1, 0};
    photograph.light.directional.pop_back();
    QVERIFY_THROWS_EXCEPTION(Error, exposureOf(photograph, turned, warnings));
  }

  /// The picture of a diffuse sphere by the path tracer, beside the axis of the camera. A glossy one does not look like
  /// that.
  void sphereShowsTheExposure() {
    const int side = 192;
    const Light light{.environment = rendering::studioEnvironment(), .rotation = 0.5};
    Photograph photograph = photographWith(light, side);
    rendering::Scene scene = sceneOf(photograph, side, side);
    scene.camera.fieldOfView = radians(70);
    photograph.disc = discOf(scene.camera, side, side);
    // Of half the size, beside and above the middle, at the distance of the centre.
    const rendering::CameraFrame frame = rendering::cameraFrame(scene.camera);
    const Direction centre = 1.3 * frame.right + 0.9 * frame.up;
    scene.objects[0].shape = rendering::Sphere{centre, 0.5};
    const double scale = 0.5 * side / (4 * frame.halfExtent);
    const matching::Disc disc{0.5 * side + 1.3 * scale, 0.5 * side - 0.9 * scale, 0.5 * scale};
    const rendering::RenderOptions options{.width = side, .height = side, .samples = 64, .density = {}};
    std::vector<std::string> warnings;
    photograph.image = rendering::renderPicture(test::lambert(Rgb(0.4)), scene, options);
    for (glm::vec3& pixel : photograph.image.pixels) pixel *= 3.0f;
    const GreyPatch grey{.reflectance = 0.4, .sphere = disc};
    const Rgb found = exposureOf(photograph, grey, warnings);
    for (int channel = 0; channel < 3; ++channel)
      QVERIFY2(std::abs(found[channel] / 3 - 1) < 0.03, QByteArray::number(found[channel]));
    QVERIFY2(warnings.empty(), warnings.empty() ? "" : warnings[0].c_str());
    photograph.image = rendering::renderPicture(*test::ggx(Rgb(0.1), Rgb(1), 0.2, 0.5), scene, options);
    exposureOf(photograph, grey, warnings);
    QCOMPARE(warnings.size(), std::size_t(1));
  }
};

GONIO_TEST(GreyPatchTest)

}  // namespace grey_patch_test

#include "grey_patch_test.moc"
