// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/models/model.h"
#include "core/rendering/render_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace bundled_environments_test {
using namespace gonio;
using namespace gonio::rendering;

std::vector<double> luminances(const EnvironmentMap& map) {
  std::vector<double> values;
  for (const glm::vec3& pixel : map.image().pixels) values.push_back(luminance(Rgb(pixel)));
  std::ranges::sort(values);
  return values;
}
class BundledEnvironmentsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void namesAndSizes() {
    for (const std::string name : {"studio", "rim-lights", "sky", "sunset", "window", "furnace"}) {
      const auto map = bundledEnvironment(name);
      QCOMPARE(map->name(), name);
      QCOMPARE(map->image().width, 512);
      QCOMPARE(map->image().height, 256);
      QVERIFY(map == bundledEnvironment(name));
    }
    QCOMPARE(comparisonScene().environment->name(), std::string("studio"));
  }

  /// Exposure 0 suits: the visible half of a white matte sphere is about mid-bright.
  void whiteMatteSpheresAreMidBright() {
    for (const std::string name : {"studio", "rim-lights", "sky", "sunset", "window"}) {
      const Scene scene = sphereScene(bundledEnvironment(name));
      RenderOptions options;
      options.width = options.height = 32;
      const Image image = renderPicture(test::lambert(Rgb(1)), scene, options);
      double sum = 0, covered = 0;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        sum += luminance(Rgb(image.pixels[i]));
        covered += image.alpha[i];
      }
      QVERIFY2(sum / covered > 0.4 && sum / covered < 0.65, qPrintable(QString::number(sum / covered)));
    }
  }

  /// Bright lamps in a dark room: what makes chrome look like chrome.
  void theStudioIsDarkWithBrightLamps() {
    const std::vector<double> values = luminances(*studioEnvironment());
    QVERIFY(values.back() > 7 && values.back() < 15);
    QVERIFY(values[values.size() / 2] < 0.1 && values.front() > 0.005);
  }

  /// A shiny black sphere has a bright outline nearly all around, which it has on one side in the studio.
  void rimLightsOutlineBlackThings() {
    const auto outlined = [](const char* name) {
      const models::Model& model = models::findModel("ggx");
      models::ParameterValues black = models::defaultParameters(model.spec());
      black.values[*model.spec().find("diffuse")] = Rgb(0);
      black.values[*model.spec().find("roughness")] = Rgb(0.1);
      RenderOptions options;
      options.width = options.height = 96;
      options.samples = 32;
      const Image image = renderPicture(*model.instantiate(black), sphereScene(bundledEnvironment(name)), options);
      // The brightest pixel of the outermost sixth of the sphere in each direction from its centre.
      double radius = 0;
      for (const float alpha : image.alpha) radius += alpha;
      radius = std::sqrt(radius / pi);
      constexpr int directions = 36;
      constexpr double visible = 0.05;  // clearly above the dark ground of the editor
      std::array<double, directions> brightest{};
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          const double across = x + 0.5 - image.width / 2.0, down = y + 0.5 - image.height / 2.0;
          const double distance = std::hypot(across, down) / radius;
          if (distance < 5.0 / 6 || distance > 0.98) continue;
          const int direction = int((std::atan2(down, across) / (2 * pi) + 0.5) * directions) % directions;
          brightest[std::size_t(direction)] =
              std::max(brightest[std::size_t(direction)], luminance(Rgb(image.at(x, y))));
        }
      return double(std::ranges::count_if(brightest, [](double value) { return value > visible; })) / directions;
    };
    const double studio = outlined("studio"), rim = outlined("rim-lights");
    QVERIFY2(studio < 0.6, qPrintable(QString::number(studio)));
    QVERIFY2(rim > 0.7, qPrintable(QString::number(rim)));
  }

  /// Of the sun's 2.5 degrees: solid angle 1.495e-3 sr, whatever pixels it falls on.
  void theSunIsResolved() {
    const auto sky = skyEnvironment();
    const double sunRadiance = luminances(*sky).back();
    QVERIFY(sunRadiance > 500);
    double solidAngle = 0;
    const Image& image = sky->image();
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        solidAngle += luminance(Rgb(image.at(x, y))) > 20
                          ? luminance(Rgb(image.at(x, y))) / sunRadiance * 2 * pi / image.width * pi / image.height *
                                std::sin(pi * (y + 0.5) / image.height)
                          : 0;
    QVERIFY(std::abs(solidAngle / 1.495e-3 - 1) < 0.03);
  }
};

GONIO_TEST(BundledEnvironmentsTest)
}  // namespace bundled_environments_test

#include "bundled_environments_test.moc"
