// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment.h"

#include <QTest>
#include <cmath>

#include "core/rendering/render_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace blurred_environment_test {
using namespace gonio;
using namespace gonio::rendering;

/// Means over the sphere.
Rgb meanRadiance(const EnvironmentMap& map) {
  const Image& image = map.image();
  Rgb sum(0);
  for (int y = 0; y < image.height; ++y) {
    const double fraction = (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height)) / 2 / image.width;
    for (int x = 0; x < image.width; ++x) sum += fraction * Rgb(image.at(x, y));
  }
  return sum;
}

class BlurredEnvironmentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aConstantStays() {
    const auto blurred = blurredEnvironment(furnaceEnvironment());
    for (const glm::vec3& pixel : blurred->image().pixels)
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(pixel[c] - 1) < 1e-5f);
  }

  void lightIsSpreadNotLost() {
    for (const std::string& name : bundledEnvironmentNames()) {
      const auto map = bundledEnvironment(name);
      const Rgb before = meanRadiance(*map), after = meanRadiance(*blurredEnvironment(map));
      for (int c = 0; c < 3; ++c) QVERIFY2(std::abs(after[c] / before[c] - 1) < 0.01, name.c_str());
    }
  }

  /// A small source becomes the distribution of the blur, on the equator and near the pole, across the seam too.
  void aSourceBecomesTheDistribution() {
    QFETCH(double, u);
    QFETCH(double, v);
    Image image(512, 256);
    image.at(int(u * 512), int(v * 256)) = glm::vec3(1e4f);
    const auto map = std::make_shared<const EnvironmentMap>(image, "a source");
    const auto blurred = blurredEnvironment(map);
    const Direction source = EnvironmentMap::directionAt((int(u * 512) + 0.5) / 512, (int(v * 256) + 0.5) / 256);
    double peak = 0;
    for (const glm::vec3& pixel : blurred->image().pixels) peak = std::max(peak, double(pixel.x));
    for (int y = 0; y < blurredHeight; ++y)
      for (int x = 0; x < blurredWidth; ++x) {
        const Direction at = EnvironmentMap::directionAt((x + 0.5) / blurredWidth, (y + 0.5) / blurredHeight);
        const double angle = std::acos(std::clamp(glm::dot(at, source), -1.0, 1.0));
        const double expected = angle < radians(18) ? std::exp(blurConcentration * (std::cos(angle) - 1)) : 0;
        // The source lies within a pixel of the blurred picture, 2.8 degrees.
        QVERIFY(std::abs(blurred->image().at(x, y).x / peak - expected) < 0.3);
        if (angle > radians(23)) QCOMPARE(blurred->image().at(x, y).x, 0.f);
      }
  }
  void aSourceBecomesTheDistribution_data() {
    QTest::addColumn<double>("u");
    QTest::addColumn<double>("v");
    QTest::newRow("ahead") << 0.5 << 0.5;
    QTest::newRow("at the seam") << 0.999 << 0.4;
    QTest::newRow("near the pole") << 0.3 << 0.03;
  }

  /// It is computed once, and shown behind objects without lighting them.
  void itLightsNothing() {
    const auto sky = bundledEnvironment("sky");
    QCOMPARE(blurredEnvironment(sky), blurredEnvironment(sky));
    Scene scene = sphereScene(sky);
    scene.showEnvironment = true;
    const RenderOptions options{.width = 24, .height = 24, .samples = 4};
    const Image sharp = renderPicture(test::lambert(Rgb(0.5)), scene, options);
    scene.blurBackground = true;
    const Image blurred = renderPicture(test::lambert(Rgb(0.5)), scene, options);
    QCOMPARE(blurred.at(12, 12), sharp.at(12, 12));
    QVERIFY(blurred.at(0, 0) != sharp.at(0, 0));
    QVERIFY(blurred.alpha[blurred.index(0, 0)] == 1);
  }
};

GONIO_TEST(BlurredEnvironmentTest)
}  // namespace blurred_environment_test

#include "blurred_environment_test.moc"
