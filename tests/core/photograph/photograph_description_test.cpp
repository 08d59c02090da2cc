// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>

#include "core/io/image_io.h"
#include "core/photograph/photograph.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace photograph_description_test {
using namespace gonio;
using namespace gonio::photograph;

/// With ' in place of ".
std::string quoted(std::string text) {
  std::ranges::replace(text, '\'', '"');
  return text;
}

const std::filesystem::path folder = GONIO_TEST_OUTPUT_DIR;

std::string description(const std::string& image) {
  return quoted("{'format': 'gonio photographs', 'version': 1, 'images': [") + image + "]}";
}

std::string imageWith(const std::string& members, const std::string& file = "photograph.exr") {
  return quoted("{'file': '") + file + quoted("', 'camera': {'position': [0, 0, 4], 'fieldOfView': 31.5}") + members +
         "}";
}

const std::string studio = quoted(", 'lights': [{'environment': 'studio', 'rotation': 90}]");

class PhotographDescriptionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    Image image(40, 40);
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) image.at(x, y) = glm::vec3(std::min(1.0f, float(x) / 30));
    io::writeExr(image, folder / "photograph.exr");
  }

  void isRead() {
    const auto found = parseDescription(
        description(imageWith(studio + quoted(", 'sphere': {'x': 19.5, 'y': 20.5, 'radius': 15}, 'clip': 0.9"))),
        folder, true);
    QCOMPARE(found.set.photographs.size(), std::size_t(1));
    QVERIFY(found.set.exposureKnown);
    const Photograph& photograph = found.set.photographs[0];
    QCOMPARE(photograph.disc, (matching::Disc{19.5, 20.5, 15}));
    QCOMPARE(photograph.clip, 0.9);
    QCOMPARE(photograph.camera.distance, 4.0);
    QCOMPARE(photograph.light.rotation, halfPi);
    QCOMPARE(photograph.image.width, 40);
  }

  /// Without an outline, it is that of the camera; the scene shows it there.
  void outlineFollowsFromTheCamera() {
    const auto found =
        parseDescription(description(imageWith(studio + quoted(", 'width': 100, 'height': 80"))), folder, false);
    const Photograph& photograph = found.set.photographs[0];
    QCOMPARE(photograph.disc.x, 50.0);
    QVERIFY(std::abs(photograph.disc.radius - 40 / std::sqrt(15.0) / std::tan(radians(31.5 / 2))) < 1e-9);
    QVERIFY(std::abs(sceneOf(photograph, 100, 80).camera.fieldOfView - radians(31.5)) < 1e-9);
    QCOMPARE(photograph.size, glm::ivec2(100, 80));
  }

  void otherShapesAreRead() {
    const auto read = [](const std::string& shape) {
      return parseDescription(description(imageWith(studio + quoted(", 'shape': " + shape))), folder, true)
          .set.photographs[0]
          .surface;
    };
    const auto cylinder = std::get<Cylinder>(read("{'cylinder': {'axis': [0, 0.5, 0], 'length': 1.5}}"));
    QVERIFY(cylinder.axis == Direction(0, 1, 0) && cylinder.length == 1.5);
    const auto rectangle = std::get<FlatSample>(read("{'flat': {'normal': [0, 0, 3], 'width': 2, 'height': 1.5}}"));
    QVERIFY(rectangle.normal == Direction(0, 0, 1) && rectangle.width == 2 && rectangle.height == 1.5);
    QVERIFY(!rectangle.isRound);
    const auto disc = std::get<FlatSample>(read("{'flat': {'normal': [0, 1, 1], 'radius': 0.7}}"));
    QVERIFY(disc.isRound && disc.width == 1.4 && disc.height == 1.4);
    QVERIFY(isSphere(parseDescription(description(imageWith(studio)), folder, true).set.photographs[0].surface));
  }

  /// The camera of other shapes may look beside their middle, and the scene shows them so.
  void cameraLooksElsewhere() {
    const std::string image =
        quoted(
            "{'file': 'photograph.exr', 'camera': {'position': [0.5, 0, 4], 'lookAt': [0.5, 0, 1]}, "
            "'shape': {'flat': {'normal': [0, 0, 1], 'radius': 1}}") +
        studio + "}";
    const Photograph photograph = parseDescription(description(image), folder, true).set.photographs[0];
    QCOMPARE(photograph.camera.target, Direction(0.5, 0, 1));
    QCOMPARE(photograph.camera.distance, 3.0);
    const SeenPoint middle = SurfaceView(photograph).at({20, 20});
    QVERIFY(glm::length(middle.position - Direction(0.5, 0, 0)) < 1e-12);
    QVERIFY(glm::length(rendering::cameraFrame(sceneOf(photograph, 40, 40).camera).eye - Direction(0.5, 0, 4)) < 1e-12);
  }

  void clippedPixelsAreFound() {
    const auto found = parseDescription(description(imageWith(studio)), folder, true);
    QCOMPARE(found.set.photographs[0].clip, 1.0);
    QCOMPARE(found.set.warnings.size(), std::size_t(1));
    QVERIFY(found.set.warnings[0].find("clipped") != std::string::npos);
  }

  /// The images are divided by the exposure that the card shows, for each channel.
  void greyCardFixesTheExposure() {
    const std::string light = quoted(", 'lights': [{'toLight': [0, 0, 1], 'irradiance': [1, 2, 4]}]");
    const std::string card = quoted(
        ", 'clip': 0.9, 'greyPatch': {'x': 15, 'y': 0, 'width': 1, 'height': 40, 'reflectance': 0.5, 'normal': "
        "[0, 0, 1]}");
    const auto found = parseDescription(description(imageWith(light + card)), folder, true);
    const Rgb expected = 0.5 * pi / 0.5 / Rgb(1, 2, 4);  // pixels of 15 / 30, radiance 0.5 / pi times the irradiance
    QVERIFY(glm::length(found.set.exposure - expected) < 1e-5);
    QVERIFY(glm::length(Rgb(found.set.photographs[0].image.at(15, 3)) - 0.5 / expected) < 1e-5);
    QVERIFY(std::abs(found.set.photographs[0].clip - 0.9 / expected.x) < 1e-5);
    QVERIFY(found.set.exposureKnown);
  }

  void encodedImagesAreDecoded() {
    std::vector<unsigned char> rgba(40 * 40 * 4, 188);
    std::fill_n(rgba.begin(), 4, static_cast<unsigned char>(255));
    io::writePng(rgba, 40, 40, folder / "encoded.png");
    const auto valueOf = [&](const std::string& gamma) {
      const auto found = parseDescription(description(imageWith(studio + gamma, "encoded.png")), folder, true);
      QTest::qVerify(found.set.warnings.size() == 1, "one warning", found.set.warnings[0].c_str(), __FILE__, __LINE__);
      return double(found.set.photographs[0].image.at(20, 20).x);
    };
    QVERIFY(std::abs(valueOf(quoted(", 'gamma': 2.2")) - std::pow(188 / 255.0, 2.2)) < 1e-6);
    QVERIFY(std::abs(valueOf(quoted(", 'gamma': 'sRGB'")) - 0.5029) < 1e-3);
  }

  void refusesBadInput_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& text, const char* message) {
      QTest::newRow(name) << QString::fromStdString(text) << message;
    };
    row("no format", quoted("{'version': 1, 'images': []}"), "format");
    row("no images", quoted("{'format': 'gonio photographs', 'version': 1, 'images': []}"), "images");
    row("PNG", description(imageWith(studio, "photograph.png")), "not linear");
    row("JPEG", description(imageWith(studio, "photograph.JPG")), "not linear");
    row("gamma out of range", description(imageWith(studio + quoted(", 'gamma': 0.4"), "photograph.png")), "gamma");
    row("gamma of a linear image", description(imageWith(studio + quoted(", 'gamma': 2.2"))), "gamma");
    const std::string card =
        quoted(", 'greyPatch': {'x': 1, 'y': 1, 'width': 2, 'height': 2, 'reflectance': 0.5, 'normal': [0, 0, 1]}");
    row("grey patch of a known exposure",
        quoted("{'format': 'gonio photographs', 'version': 1, 'exposure': 'known', 'images': [") +
            imageWith(studio + card) + "]}",
        "grey patch");
    row("black grey patch",
        description(imageWith(studio + quoted(", 'greyPatch': {'x': 0, 'y': 1, 'width': 1, "
                                              "'height': 2, 'reflectance': 0.5, 'normal': "
                                              "[0, 0, 1]}"))),
        "black");
    row("grey patch without reflectance",
        description(imageWith(studio + quoted(", 'greyPatch': {'sphere': {'x': 9, 'y': 9, 'radius': 9}}"))),
        "greyPatch.reflectance");
    row("candidate without light",
        description(imageWith(studio)).substr(0, description(imageWith(studio)).size() - 1) +
            quoted(", 'candidates': [{'file': 'x.exr', 'camera': {'position': [0, 0, 4]}, 'lights': []}]}"),
        "candidates[0].lights");
    row("no such file", description(imageWith(studio, "missing.exr")), "missing.exr");
    row("no light", description(imageWith(quoted(", 'lights': []"))), "at least one light");
    row("unknown member", description(imageWith(studio + quoted(", 'shpere': 1"))), "shpere");
    row("unknown environment", description(imageWith(quoted(", 'lights': [{'environment': 'moon'}]"))), "moon");
    row("light inside",
        description(imageWith(quoted(", 'lights': [{'position': [0, 0.5, 0], 'intensity': [1, 1, 1]}]"))),
        "outside of the sphere");
    row("no direction", description(imageWith(quoted(", 'lights': [{'toLight': [0, 0, 0], 'irradiance': [1, 1, 1]}]"))),
        "toLight");
    row("outline outside", description(imageWith(studio + quoted(", 'sphere': {'x': 60, 'y': 5, 'radius': 15}"))),
        "sphere.x");
    row("camera inside",
        description(quoted("{'file': 'photograph.exr', 'camera': {'position': [0, 0, 0.5]}") + studio + "}"),
        "above 1");
    const auto shape = [&](const std::string& of, const std::string& members = {}) {
      return description(imageWith(studio + quoted(", 'shape': " + of + members)));
    };
    const std::string sample = "{'flat': {'normal': [0, 0, 1], 'width': 2, 'height': 2}}";
    row("unknown shape", shape("{'cube': {}}"), "images[0].shape: found an object, expected {\"cylinder\"");
    row("shape of two", shape("{'cylinder': {'axis': [0, 1, 0], 'length': 2}, 'flat': {}}"), "images[0].shape");
    row("shape as text", shape("'cylinder'"), "images[0].shape");
    row("cylinder without axis", shape("{'cylinder': {'length': 2}}"), "images[0].shape.cylinder.axis");
    row("cylinder without direction", shape("{'cylinder': {'axis': [0, 0, 0], 'length': 2}}"), "a direction");
    row("cylinder without length", shape("{'cylinder': {'axis': [0, 1, 0]}}"), "images[0].shape.cylinder.length");
    row("cylinder with a radius", shape("{'cylinder': {'axis': [0, 1, 0], 'length': 2, 'radius': 2}}"), "radius");
    row("flat sample without height", shape("{'flat': {'normal': [0, 0, 1], 'width': 2}}"),
        "images[0].shape.flat.height");
    row("flat sample of two sizes", shape("{'flat': {'normal': [0, 0, 1], 'radius': 2, 'width': 2}}"), "width");
    row("flat sample seen from behind", shape("{'flat': {'normal': [0, 0, -1], 'radius': 2}}"),
        "images[0].camera.position");
    row("camera in line with a cylinder", shape("{'cylinder': {'axis': [0, 0, 1], 'length': 2}}"), "from the axis");
    row("shape and outline", shape(sample, ", 'sphere': {'x': 20, 'y': 20, 'radius': 15}"), "images[0].sphere");
    row("shape and outline to find", shape(sample, ", 'sphere': 'find'"), "images[0].sphere");
    row("light in a cylinder",
        description(imageWith(quoted(", 'shape': {'cylinder': {'axis': [0, 1, 0], 'length': 2}}, 'lights': "
                                     "[{'position': [0, 0.5, 0], 'intensity': [1, 1, 1]}]"))),
        "outside of the cylinder");
    const auto lookingAt = [](const std::string& members) {
      return description(quoted("{'file': 'photograph.exr', 'camera': {'position': [0, 0, 4], 'lookAt': " + members) +
                         studio + "}");
    };
    row("camera beside the sample", lookingAt("[30, 0, 4]}, 'shape': " + sample), "in its image");
    row("camera looks nowhere", lookingAt("[0, 0, 4]}, 'shape': " + sample), "images[0].camera.lookAt");
    row("camera beside the sphere", lookingAt("[0, 0, 1]}"), "images[0].camera.lookAt");
    row("exposure", quoted("{'format': 'gonio photographs', 'version': 1, 'exposure': 'auto', 'images': []}"),
        "exposure");
  }
  void refusesBadInput() {
    QFETCH(QString, text);
    QFETCH(QString, message);
    try {
      parseDescription(text.toStdString(), folder, true);
    } catch (const Error& error) {
      QVERIFY2(QString::fromUtf8(error.what()).contains(message), error.what());
      return;
    }
    QFAIL("it was accepted");
  }
};

GONIO_TEST(PhotographDescriptionTest)

}  // namespace photograph_description_test

#include "photograph_description_test.moc"
