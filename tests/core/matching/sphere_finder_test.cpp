// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/sphere_finder.h"

#include <QTest>

#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace sphere_finder_test {
using namespace gonio;
using matching::Disc;
using matching::findSphere;

/// A picture of a shiny sphere in the studio, of any shape; the outline from the camera's geometry.
struct Rendered {
  Image image;
  Disc disc;
};
Rendered rendered(int width, int height, bool showsEnvironment, double distance = 4) {
  rendering::Scene scene = rendering::comparisonScene();
  scene.showEnvironment = showsEnvironment;
  scene.camera.distance = distance;
  const auto brdf = test::ggx(Rgb(0.1, 0.2, 0.4), Rgb(0.9), 0.15, 0.05);
  Image image =
      rendering::renderPicture(*brdf, scene, {.width = width, .height = height, .samples = 16, .density = {}});
  const double half = std::min(width, height) / 2.0;
  return {std::move(image),
          {width / 2.0, height / 2.0,
           half / std::sqrt(distance * distance - 1) / rendering::cameraFrame(scene.camera).halfExtent}};
}

/// Over a background; clipped, as a picture in a file.
Image flattened(Image image, const Rgb& background) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = glm::min(image.pixels[i] + (1 - image.alpha[i]) * glm::vec3(background), glm::vec3(1));
  image.alpha.clear();
  return image;
}

/// A part of a picture.
Image cropped(const Image& image, int left, int top, int width, int height) {
  Image part(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) part.at(x, y) = image.at(x + left, y + top);
  return part;
}

void compare(const Disc& found, const Disc& expected) {
  const QByteArray text = QStringLiteral("found %1, %2, radius %3, expected %4, %5, radius %6")
                              .arg(found.x)
                              .arg(found.y)
                              .arg(found.radius)
                              .arg(expected.x)
                              .arg(expected.y)
                              .arg(expected.radius)
                              .toUtf8();
  QVERIFY2(std::hypot(found.x - expected.x, found.y - expected.y) < 1, text);
  QVERIFY2(std::abs(found.radius - expected.radius) < 1, text);
}

class SphereFinderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void findsItByTheAlpha() {
    const Rendered picture = rendered(300, 220, false, 5);
    compare(findSphere(picture.image), picture.disc);
  }

  void findsItOnPlainBackgrounds_data() {
    QTest::addColumn<double>("grey");
    QTest::newRow("black") << 0.0;
    QTest::newRow("dark") << 0.02;
    QTest::newRow("middle grey") << 0.2;
    QTest::newRow("white") << 1.0;
  }
  void findsItOnPlainBackgrounds() {
    QFETCH(double, grey);
    const Rendered picture = rendered(400, 400, false);
    compare(findSphere(flattened(picture.image, Rgb(grey))), picture.disc);
  }

  void findsItInTheEnvironment() {
    const Rendered picture = rendered(400, 300, true, 6);
    compare(findSphere(flattened(picture.image, Rgb(0))), picture.disc);
  }

  void findsItBesideTheMiddle() {
    const Rendered picture = rendered(640, 640, false, 8);
    compare(findSphere(cropped(flattened(picture.image, Rgb(0.3)), 170, 100, 400, 420)),
            {picture.disc.x - 170, picture.disc.y - 100, picture.disc.radius});
  }

  /// A part of the outline is outside the picture.
  void findsItWhenItIsCut() {
    const Rendered picture = rendered(400, 400, false);
    compare(findSphere(cropped(flattened(picture.image, Rgb(0.3)), 60, 0, 340, 400)),
            {picture.disc.x - 60, picture.disc.y, picture.disc.radius});
  }

  void saysWhereThereIsNone() {
    QVERIFY_THROWS_EXCEPTION(Error, findSphere(Image(200, 200)));
    QVERIFY_THROWS_EXCEPTION(Error, findSphere(Image(3, 3)));
    Image bars(200, 200);
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x) bars.at(x, y) = glm::vec3(x / 40 % 2 ? 0.8f : 0.1f);
    QVERIFY_THROWS_EXCEPTION(Error, findSphere(bars));
  }
};

GONIO_TEST(SphereFinderTest)

}  // namespace sphere_finder_test

#include "sphere_finder_test.moc"
