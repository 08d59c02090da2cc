// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/scene_files.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <random>

#include "core/io/exr_codec.h"
#include "core/rendering/render_picture.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace scene_files_test {
using namespace gonio;

/// Radiance that is the direction itself, shifted to positive values: every turn and mirror shows.
std::shared_ptr<const EnvironmentMap> directions() {
  Image image(256, 128);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.at(x, y) =
          glm::vec3(EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height) + Direction(2));
  return std::make_shared<const EnvironmentMap>(std::move(image), "directions");
}

/// The square's position of a direction: the inverse of Clarberg's mapping in the form with an arc tangent.
glm::dvec2 squarePosition(const Direction& w) {
  const double r = std::sqrt(1 - std::abs(w.z));
  const double phi = std::atan2(std::abs(w.y), std::abs(w.x)) * 2 / pi;  // [0, 1]
  double v = r * phi, u = r - v;
  if (w.z < 0) {
    std::swap(u, v);
    u = 1 - u;
    v = 1 - v;
  }
  return {(std::copysign(u, w.x) + 1) / 2, (std::copysign(v, w.y) + 1) / 2};
}

QString textOf(const exports::MadeExport::Part& part) {
  return QString::fromUtf8(reinterpret_cast<const char*>(part.bytes.data()), qsizetype(part.bytes.size()));
}

class SceneFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theSquareHasTheDirections() {
    const auto environment = directions();
    constexpr double turn = 0.7;
    constexpr int side = 256;
    const Image image = exports::octahedralEnvironment(*environment, turn, side);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 400; ++i) {
      const Direction w = glm::normalize(Direction(normal(random), normal(random), normal(random)));
      const glm::dvec2 at = squarePosition(w) * double(side);
      const glm::vec3 found = image.at(std::min(side - 1, int(at.x)), std::min(side - 1, int(at.y)));
      const Rgb expected = EnvironmentRotation(turn).toEnvironment(w) + Direction(2);
      QVERIFY(glm::length(Rgb(found) - expected) < 0.05);
    }
  }

  /// Areas are equal: the mean of the square is that of the sphere.
  void theSquareKeepsTheLight() {
    const Image image = exports::octahedralEnvironment(*directions(), 0, 128);
    Rgb mean(0);
    for (const glm::vec3& pixel : image.pixels) mean += Rgb(pixel) / double(image.pixels.size());
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(mean[c] - 2) < 0.01);
  }

  void mitsubaSceneIsWhole() {
    Scene scene = comparisonScene();
    scene.environmentRotation = radians(30);
    const auto parts = exports::mitsubaScene(scene, "a \"b\" & c");
    QCOMPARE(parts.size(), exports::findExportTarget("mitsuba")->sceneSuffixes.size());
    QXmlStreamReader xml(textOf(parts[0]));
    QStringList values;
    while (!xml.atEnd())
      if (xml.readNext() == QXmlStreamReader::StartElement)
        for (const auto& attribute : xml.attributes()) values << attribute.value().toString();
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    for (const char* value :
         {"31.5127", "0, 0, 4", "0, 0, 3", "150", "a _b_ _ c_rgb.bsdf", "a _b_ _ c_environment.exr"})
      QVERIFY2(values.contains(value), value);
    const Image image = io::decodeExr(parts[1].bytes);
    QCOMPARE(image.width, scene.environment->image().width);
    QVERIFY(glm::length(image.at(100, 80) - scene.environment->image().at(100, 80)) <
            1e-2f * (1 + image.at(100, 80).x));
  }

  void pbrtSceneIsWhole() {
    const auto parts = exports::pbrtScene(comparisonScene(), "chrome");
    QCOMPARE(parts.size(), exports::findExportTarget("pbrt")->sceneSuffixes.size());
    const QString text = textOf(parts[0]);
    QVERIFY(text.startsWith("Scale -1 1 1\nLookAt 0 0 4  0 0 3  0 1 0\n"));
    QVERIFY(text.contains("\"string filename\" \"chrome_spec.bsdf\""));
    QCOMPARE(text.count('"') % 2, 0);
    const Image image = io::decodeExr(parts[1].bytes);
    QCOMPARE(image.width, image.height);
  }

  void whatCannotBeShownIsAnError() {
    Scene dark = comparisonScene(), flat = comparisonScene();
    dark.environment = nullptr;
    flat.camera.fieldOfView = 0;
    for (const Scene& scene : {dark, flat}) {
      QVERIFY_THROWS_EXCEPTION(Error, exports::mitsubaScene(scene, "a"));
      QVERIFY_THROWS_EXCEPTION(Error, exports::pbrtScene(scene, "a"));
    }
  }
};

GONIO_TEST(SceneFilesTest)
}  // namespace scene_files_test

#include "scene_files_test.moc"
