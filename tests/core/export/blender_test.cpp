// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/export/export_target.h"
#include "core/export/scenes/scene_files.h"
#include "core/export/shaders/shading_models.h"
#include "core/export/target_table.h"
#include "core/geometry/bundled_meshes.h"
#include "core/io/image_io.h"
#include "core/materials/material.h"
#include "core/metrics/image_metrics.h"
#include "core/rendering/render_picture.h"
#include "tests/core/export/sun_picture.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace blender_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::geometry;

constexpr int sunSamples = 64;

bool runBlender(const QStringList& arguments,
                const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment()) {
  QProcess blender;
  blender.setProcessEnvironment(environment);
  blender.start("blender", QStringList{"--background", "--python-exit-code", "1", "--python"} + arguments);
  const bool done = blender.waitForFinished(240000) && blender.exitCode() == 0;
  if (!done) qWarning() << blender.readAll() << blender.readAllStandardError();
  return done;
}

/// What Cycles shows of a material (render_in_blender.py), the bottom row first.
QVector<float> rendered(const QString& folder, const std::string& script) {
  QFile file(folder + "/material.py");
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write(script.data(), qint64(script.size()));
  file.close();
  if (!runBlender({BLENDER_TEST_SCRIPT, "--", file.fileName(), folder + "/out.raw",
                   QString::number(test::sunPictureSide), QString::number(sunSamples),
                   QString::number(test::sunAngle)}))
    return {};
  QFile raw(folder + "/out.raw");
  if (!raw.open(QIODevice::ReadOnly)) return {};
  const QByteArray bytes = raw.readAll();
  QVector<float> values(bytes.size() / qsizetype(sizeof(float)));
  std::memcpy(values.data(), bytes.data(), std::size_t(bytes.size()));
  return values;
}

/// dB of Cycles' picture of the script against the prediction.
double snrInBlender(const QString& folder, const std::string& script, const Brdf& brdf) {
  return test::sunPictureSnr(rendered(folder, script), brdf, test::TangentAxis::view);
}

/// A sphere and a mesh on the ground, all that a light's place, sense and unit shows in; without lights.
Scene unlitScene() {
  Scene scene;
  scene.camera = {.yaw = 0.5, .pitch = 0.35, .distance = 8, .target = {0.3, -0.4, 0}};
  const auto mesh = std::make_shared<const MeshIntersector>(
      std::make_shared<const TriangleMesh>(transformed(*bundledMesh("shader-ball"), placement(1, 0.6, {1.3, 0, 0.2}))));
  scene.objects = {{.name = "sphere", .shape = Sphere{.centre = {-1, -0.1, 0}, .radius = 0.9}},
                   {.name = "mesh", .shape = mesh},
                   {.name = "ground",
                    .shape = Rectangle{.centre = {0, -1, 0}, .halfU = {0, 0, 5}, .halfV = {5, 0, 0}},
                    .material = Diffuse{Rgb(0.5, 0.4, 0.3)}}};
  return scene;
}

/// What Cycles shows of a scene with a material, in the test's number of pixels and samples.
Image renderedScene(const QTemporaryDir& folder, const Scene& scene, const std::string& material, int pixels,
                    int samples, int seed = 0) {
  std::vector<exports::ExportPart> parts = exports::sceneParts(exports::blenderSceneFormat(), scene, "test");
  QString text =
      QString::fromUtf8(reinterpret_cast<const char*>(parts[0].bytes.data()), qsizetype(parts[0].bytes.size()));
  text.replace(QStringLiteral("\"pixels\": 512"), QStringLiteral("\"pixels\": %1").arg(pixels));
  text.replace(QStringLiteral("\"samples\": 256"), QStringLiteral("\"samples\": %1").arg(samples));
  text.replace(QStringLiteral("    cycles = scene.cycles\n"),
               QStringLiteral("    cycles = scene.cycles\n    cycles.seed = %1\n").arg(seed));
  parts[0] = exports::textPart(parts[0].suffix, text.toStdString());
  parts.push_back(exports::textPart("_blender.py", material));
  std::vector<exports::ExportFile> files;
  for (exports::ExportPart& part : parts)
    files.push_back({folder.filePath("test").toStdString() + part.suffix, std::move(part.bytes)});
  exports::writeExport(files);
  const QString picture = folder.filePath("picture.exr");
  return runBlender({folder.filePath("test_scene.py"), "--", picture}) ? io::readImage(picture.toStdString()) : Image();
}

class BlenderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (QStandardPaths::findExecutable("blender").isEmpty())
      QSKIP("blender is not installed (scripts/install_export_clients.sh)");
    QProcess blender;
    blender.start("blender", {"--version"});
    QVERIFY(blender.waitForFinished(60000));
    const QString version = QString::fromUtf8(blender.readAllStandardOutput()).section(' ', 1, 1);
    qInfo() << "Blender" << version;
    m_version = version.startsWith('3') ? exports::BlenderVersion::v3 : exports::BlenderVersion::v4;
  }

  /// Cycles shows the node graph as Gonio predicts it.
  void cyclesShowsThePrediction() {
    const auto material = test::ggx(Rgb(0.3, 0.12, 0.05), Rgb(0.9), 0.25, 0.06);
    const exports::ViewLobes lobes = exports::fitViewLobes(*material, {.lobes = 3, .knots = 16, .blender = m_version});
    const double snr =
        snrInBlender(m_folder.path(), exports::blenderScript(lobes, "test", "A test."), *exports::viewLobesBrdf(lobes));
    qInfo() << "Cycles against the prediction:" << snr << "dB";
    QVERIFY(snr > 40);
  }

  /// The same of the Principled BSDF, with all that the formula has: body, tinted highlight, part metal, coat.
  void cyclesShowsThePrincipledBsdf() {
    const exports::SurfaceValues values{.baseColour = Rgb(0.6, 0.3, 0.1),
                                        .metalness = 0.3,
                                        .roughness = 0.5,
                                        .specularColour = Rgb(0.9, 0.7, 0.5),
                                        .specular = 0.7,
                                        .specularTint = 0.5,
                                        .coat = 0.8,
                                        .coatRoughness = 0.4};
    const double snr = snrInBlender(m_folder.path(), exports::principledScript(values, m_version, "test", "A test."),
                                    *exports::principledShader(m_version).brdf(values));
    qInfo() << "Cycles against the prediction:" << snr << "dB";
    QVERIFY(snr > 60);
  }

  /// A turned grain: the mapping of anisotropy to widths, the direction of the rotation, the tangent.
  void cyclesShowsTheGrain() {
    const exports::SurfaceValues values{.baseColour = Rgb(0.8, 0.6, 0.3),
                                        .metalness = 1,
                                        .roughness = 0.5,
                                        .anisotropy = 0.7,
                                        .rotation = 0.6,
                                        .specular = 0.5,
                                        .coatRoughness = 0.03};
    const double snr = snrInBlender(m_folder.path(), exports::principledScript(values, m_version, "test", "A test."),
                                    *exports::principledShader(m_version).brdf(values));
    qInfo() << "Cycles against the prediction:" << snr << "dB";
    QVERIFY(snr > 50);
  }

  /// The add-on opens an exported script and a document, and shows what changes in them (check_addon.py).
  void theAddonFollowsItsFiles() {
    const QTemporaryDir folder;
    QProcessEnvironment own = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"RESOURCES", "CONFIG", "SCRIPTS", "DATAFILES"}) {
      const QString path = folder.filePath(QString(name).toLower());
      QVERIFY(QDir().mkpath(path));
      own.insert(QString("BLENDER_USER_%1").arg(name), path);
    }
    // Without goniotool, which no library of core needs, the script alone is followed.
    const QString goniotool = QFile::exists(GONIOTOOL) ? GONIOTOOL : "";
    QVERIFY(runBlender({CHECK_ADDON_SCRIPT, "--", BLENDER_ADDON, goniotool, folder.path()}, own));
  }

  void cyclesShowsTheScene_data() {
    QTest::addColumn<QString>("light");
    for (const char* light : {"environment", "sun", "point", "lamp", "orthographic"}) QTest::newRow(light) << light;
  }

  /// The exported scene is the scene: places, meshes, camera, and each kind of light.
  void cyclesShowsTheScene() {
    QFETCH(QString, light);
    Scene scene = unlitScene();
    if (light == "environment") {
      scene.environment = skyEnvironment();
      scene.environmentRotation = 0.8;
      scene.showEnvironment = true;
    } else if (light == "point") {
      scene.pointLights = {{.position = {-1.5, 3, 2}, .intensity = Rgb(10, 8, 6)}};
    } else if (light == "lamp") {
      scene.objects.push_back({.name = "lamp",
                               .shape = Rectangle{.centre = {-2, 2.5, 1}, .halfU = {0.7, 0, 0}, .halfV = {0, 0.3, 0.9}},
                               .radiance = Rgb(6, 7, 9)});
    } else {
      scene.directionalLights = {{.toLight = glm::normalize(Direction(0.5, 0.9, 0.6)), .irradiance = Rgb(3, 2.5, 2)}};
      if (light == "orthographic") scene.camera.fieldOfView = 0;
    }
    const auto material = test::ggx(Rgb(0.3, 0.12, 0.05), Rgb(0.9), 0.4, 0.06);
    const exports::ViewLobes lobes = exports::fitViewLobes(*material, {.lobes = 2, .knots = 12, .blender = m_version});
    const Image found = renderedScene(m_folder, scene, exports::blenderScript(lobes, "test", "A test."), 64, 256);
    const Image expected =
        renderPicture(*exports::viewLobesBrdf(lobes), scene, {.width = 64, .height = 64, .samples = 512});
    QCOMPARE(found.width, expected.width);
    const double snr = metrics::signalToNoiseRatio(expected, found);
    qInfo() << "Cycles against Gonio:" << snr << "dB";
    QVERIFY(snr > 32);
  }

  void theStatedAccuracyIsThatInBlender_data() {
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("material");
    QTest::addColumn<int>("side");
    QTest::newRow("lobes, blue-metallic-paint") << "blender"
                                                << "blue-metallic-paint" << 64;
    QTest::newRow("lobes, chrome") << "blender"
                                   << "chrome" << 128;  // its highlights are as narrow as pixels
    QTest::newRow("principled, blue-metallic-paint") << "principled"
                                                     << "blue-metallic-paint" << 64;
  }

  /// Blender's picture is as far from the material as the export says, free of both noises.
  void theStatedAccuracyIsThatInBlender() {
    QFETCH(QString, target);
    QFETCH(QString, material);
    QFETCH(int, side);
    const materials::Material opened = materials::readMaterial("library:merl-copy/" + material.toStdString());
    const auto made = exports::makeExport(*exports::findExportTarget(target.toStdString()), materials::unedited(opened),
                                          {.blender = int(m_version)});
    const std::string script(reinterpret_cast<const char*>(made.parts[0].bytes.data()), made.parts[0].bytes.size());
    constexpr int pictureSamples = 256;
    metrics::PicturePair found, expected;
    for (std::size_t half = 0; half < 2; ++half) {
      found[half] = renderedScene(m_folder, comparisonScene(), script, side, pictureSamples, int(half));
      expected[half] = renderPicture(*opened.brdf, comparisonScene(),
                                     {.width = side, .height = side, .samples = pictureSamples, .seed = 10 + half});
    }
    const double snr = metrics::signalToNoiseRatio(expected, found);
    qInfo() << "stated" << made.snr << "dB, in Blender" << snr << "dB";
    QVERIFY(std::abs(snr - made.snr) < 0.5);
  }

 private:
  QTemporaryDir m_folder;
  exports::BlenderVersion m_version = exports::BlenderVersion::v4;
};

GONIO_TEST(BlenderTest)
}  // namespace blender_test

#include "blender_test.moc"
