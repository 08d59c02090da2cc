// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/scenes/scene_files.h"

#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/export/export_target.h"
#include "core/geometry/bundled_meshes.h"
#include "core/io/exr_codec.h"
#include "core/io/mesh_file.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/scene_file.h"
#include "tests/support/test_program.h"

namespace scene_files_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;

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

QString textOf(const exports::ExportPart& part) {
  return QString::fromUtf8(reinterpret_cast<const char*>(part.bytes.data()), qsizetype(part.bytes.size()));
}

/// Of all attributes; empty where the text is no XML.
QStringList xmlValues(const QString& text) {
  QXmlStreamReader xml(text);
  QStringList values;
  while (!xml.atEnd())
    if (xml.readNext() == QXmlStreamReader::StartElement)
      for (const auto& attribute : xml.attributes()) values << attribute.value().toString();
  return xml.hasError() ? QStringList() : values;
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
    const auto parts = exports::sceneParts(exports::mitsubaSceneFormat(), scene, "a \"b\" & c");
    const QStringList values = xmlValues(textOf(parts[0]));
    for (const char* value :
         {"31.5127", "0, 0, 4", "0, 0, 3", "150", "a \"b\" & c_rgb.bsdf", "a \"b\" & c_environment.exr"})
      QVERIFY2(values.contains(value), value);
    const Image image = io::decodeExr(parts[1].bytes).image;
    QCOMPARE(image.width, scene.environment->image().width);
    QVERIFY(glm::length(image.at(100, 80) - scene.environment->image().at(100, 80)) <
            1e-2f * (1 + image.at(100, 80).x));
  }

  void pbrtSceneIsWhole() {
    const auto parts = exports::sceneParts(exports::pbrtSceneFormat(), comparisonScene(), "chrome");
    const QString text = textOf(parts[0]);
    QVERIFY(text.startsWith("Scale -1 1 1\nLookAt 0 0 4  0 0 3  0 1 0\n"));
    QVERIFY(text.contains("\"string filename\" \"chrome_spec.bsdf\""));
    const io::ImageFile file = io::decodeExr(parts[1].bytes);
    QCOMPARE(file.layout, std::string("equal-area octahedral"));  // so that it is not opened as another one
    const Image& image = file.image;
    QCOMPARE(image.width, image.height);
    // Where Gonio hides the environment, the picture has the normals, by which it can be masked.
    for (const bool shown : {false, true}) {
      Scene scene = comparisonScene();
      scene.showEnvironment = shown;
      const QString film = textOf(exports::sceneParts(exports::pbrtSceneFormat(), scene, "chrome")[0]);
      QVERIFY(film.contains(shown ? "\nFilm \"rgb\"" : "\nFilm \"gbuffer\"") && film.contains("Ns.X") == !shown);
    }
  }

  /// Every scene of the project in every renderer: all files that are announced, none besides, each of them named in
  /// the scene, whose text is well-formed.
  void everySceneIsWritten() {
    for (const std::string& sceneName : bundledSceneNames()) {
      const Scene scene = openScene(sceneName);
      for (const exports::ExportTarget& target : exports::exportTargets()) {
        if (!target.scene) continue;
        QVERIFY(std::ranges::count(target.suffixes, target.scene->materialSuffix) == 1);
        const auto parts = exports::sceneParts(*target.scene, scene, "name");
        const auto suffixes = exports::sceneSuffixes(*target.scene, scene);
        QCOMPARE(parts.size(), suffixes.size());
        const QString text = textOf(parts[0]);
        for (std::size_t i = 0; i < parts.size(); ++i) {
          QCOMPARE(parts[i].suffix, suffixes[i]);
          if (i > 0) QVERIFY2(text.contains(QString::fromStdString("name" + suffixes[i])), suffixes[i].c_str());
        }
        QVERIFY(text.contains(QString::fromStdString("name" + std::string(target.scene->materialSuffix))));
        QCOMPARE(text.count('"') % 2, 0);
        if (target.id == "mitsuba") QVERIFY(!xmlValues(text).isEmpty());
      }
    }
  }

  /// A mesh comes back from its file as it is, normals and all.
  void meshesSurvive() {
    for (const char* name : {"shader-ball", "cylinder"}) {
      const auto mesh = bundledMesh(name);
      const std::vector<std::byte> bytes = io::encodePly(*mesh);
      const TriangleMesh read = io::readPly(io::MemorySource(bytes)).mesh;
      QCOMPARE(read.triangles().size(), mesh->triangles().size());
      for (std::size_t i = 0; i < mesh->triangles().size(); ++i)
        for (int k = 0; k < 3; ++k) {
          QCOMPARE(read.positions()[read.triangles()[i][k]], mesh->positions()[mesh->triangles()[i][k]]);
          QVERIFY(glm::distance(read.cornerNormals()[3 * i + std::size_t(k)],
                                mesh->cornerNormals()[3 * i + std::size_t(k)]) < 1e-6f);
        }
    }
  }

  /// Rectangles stand where they are: Mitsuba's matrix and pbrt's corners give the rectangle's points and its front.
  void rectanglesKeepTheirPlace() {
    Scene scene = comparisonScene();
    scene.environment = nullptr;
    const Rectangle rectangle{.centre = {1, 2, 3}, .halfU = {0, 0, 0.5}, .halfV = {2, 0, 0}};
    scene.objects = {{.name = "lamp", .shape = rectangle, .radiance = Rgb(3, 2, 1)}};
    const auto mitsuba = exports::sceneParts(exports::mitsubaSceneFormat(), scene, "a");
    QCOMPARE(mitsuba.size(), std::size_t(1));
    QVERIFY(xmlValues(textOf(mitsuba[0])).contains("0 2 0 1 0 0 1 2 0.5 0 0 3 0 0 0 1"));
    QVERIFY(xmlValues(textOf(mitsuba[0])).contains("3, 2, 1"));
    const QString pbrt = textOf(exports::sceneParts(exports::pbrtSceneFormat(), scene, "a")[0]);
    QVERIFY(pbrt.contains("[ -1 2 2.5  -1 2 3.5  3 2 2.5  3 2 3.5 ]"));
  }

  void orthographicCamerasAreWritten() {
    Scene scene = comparisonScene();
    scene.camera.fieldOfView = 0;
    QVERIFY(textOf(exports::sceneParts(exports::mitsubaSceneFormat(), scene, "a")[0]).contains("orthographic"));
    QVERIFY(textOf(exports::sceneParts(exports::pbrtSceneFormat(), scene, "a")[0]).contains("-1.15 1.15 -1.15 1.15"));
    QVERIFY(textOf(exports::sceneParts(exports::blenderSceneFormat(), scene, "a")[0]).contains("\"width\": 2.3"));
  }
};

GONIO_TEST(SceneFilesTest)
}  // namespace scene_files_test

#include "scene_files_test.moc"
