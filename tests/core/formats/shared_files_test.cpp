// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/documents/open_material.h"
#include "core/io/csv_text.h"
#include "core/io/mesh_file.h"
#include "core/rendering/environment.h"
#include "core/rendering/scene_file.h"
#include "core/sampling/directional_albedo.h"
#include "core/support/text.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace shared_files_test {
using namespace gonio;
using namespace gonio::test;
namespace fs = std::filesystem;

const fs::path data = fs::path(GONIO_SHARED_DIR) / "data", cases = data / "cases";

#define SKIP_WITHOUT(folder) \
  if (!fs::exists(folder)) QSKIP("the folder of the development data is absent: its files were not read")

/// Opens a file as what its suffix says. @throws Error.
void open(const fs::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  if (suffix == ".exr" || suffix == ".hdr")
    rendering::openEnvironment(path.string());
  else if (io::isMeshFile(path))
    rendering::openScene(path.string());
  else if (suffix == ".csv")
    io::readCsvText(io::readText(path));
  else
    documents::openMaterial(path.string());
}

glm::vec3 firstPixel(const std::string& name) {
  return rendering::openEnvironment((cases / name).string())->image().at(0, 0);
}

geometry::TriangleMesh meshOf(const std::string& name) {
  const rendering::Scene scene = rendering::openScene((cases / name).string());
  return std::get<rendering::MeshShape>(scene.objects[0].shape)->mesh();
}

/// How far the albedo at 30 degrees is from an expected one, in the worst channel.
double albedoError(const std::string& name, const Rgb& expected) {
  const Rgb albedo = directionalAlbedo(*documents::openMaterial((cases / name).string()).brdf, radians(30));
  return maxChannel(glm::abs(albedo - expected));
}

/// Files of the development data: small ones that once failed, with the right answers of their README files, and files
/// that other programs wrote. None of them is part of the project.
class SharedFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Each is read, or refused in a message that names it.
  void everyFileIsReadOrRefused() {
    SKIP_WITHOUT(cases);
    int read = 0, refused = 0;
    for (const fs::path& folder : {cases, data / "formats"})
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        if (!entry.is_regular_file() || path.filename() == "README") continue;
        const std::string error = errorOf([&] { open(path); });
        QVERIFY2(error.empty() || contains(error, path.filename().string()), error.c_str());
        ++(error.empty() ? read : refused);
        qInfo("%s: %s", path.filename().c_str(), error.empty() ? "read" : error.substr(0, 160).c_str());
      }
    qInfo("%d read, %d refused", read, refused);
    QVERIFY(read >= 24);
  }

  void textOfMeasurements() {
    SKIP_WITHOUT(cases);
    QVERIFY(albedoError("astm-extra-column/wavelength_first.astm", Rgb(0.2)) < 0.02);
    QVERIFY(albedoError("astm-extra-column/micrometres.astm", Rgb(0.6, 0.4, 0.2)) < 0.04);
    const std::string two =
        errorOf([] { documents::openMaterial((cases / "astm-extra-column/two_wavelengths.astm").string()); });
    QVERIFY2(contains(two, "'650nm', '532nm' beside the angles"), two.c_str());
    QVERIFY(albedoError("pgii-decimal-comma/comma.txt", Rgb(0.2)) < 0.02);
    const std::string json = errorOf([] { documents::openMaterial((cases / "json-as-material/table.json").string()); });
    QVERIFY2(contains(json, "matches no format that Gonio supports"), json.c_str());
  }

  void beyondTheLastAngle() {
    SKIP_WITHOUT(cases);
    const auto brdf = documents::openMaterial((cases / "zemax-beyond-last-angle/lambert.bsdf").string()).brdf;
    const io::CsvText csv = io::readCsvText(io::readText(cases / "zemax-beyond-last-angle/directions.csv"));
    for (const io::CsvText::Row& row : csv.rows) {
      const auto angle = [&](const char* name) { return radians(csv.number(row, csv.requiredColumn(name))); };
      const Rgb value = brdf->evaluate(fromSpherical(angle("theta_i"), angle("phi_i")),
                                       fromSpherical(angle("theta_o"), angle("phi_o")));
      QVERIFY2(std::abs(value.x - 0.0637) < 1e-6, io::lineText(row).c_str());
    }
    QVERIFY(albedoError("zemax-beyond-last-angle/lambert.bsdf", Rgb(pi * 0.0637)) < 1e-4);
  }

  /// What they are, and one value of each that was taken from the file by hand.
  void filesOfOtherPrograms() {
    SKIP_WITHOUT(data / "formats");
    const auto open = [](const char* name) { return documents::openMaterial((data / "formats" / name).string()); };
    const materials::Material reflet = open("rt300s_lighttools.txt");
    QCOMPARE(reflet.source.format, std::string("REFLET"));
    QVERIFY(contains(reflet.source.notes.at(1), "no value of the file is above 0"));
    const materials::Material sensor = open("IMX455.bsdf");
    QVERIFY(!sensor.brdf->isIsotropic());
    QCOMPARE(sensor.source.grid, (std::vector<int>{36, 4, 37, 21}));
    const materials::Material alta = open("brdf_small_simu_two_layers_txt.alta");
    QVERIFY(alta.source.format == "ALTA" && contains(alta.source.notes.at(1), "samples at"));
    const materials::Material asphalt = open("example_material_camera_brdf.xompt");
    QCOMPARE(asphalt.source.description, std::string("asphalt_brdf_for_camera"));
    QVERIFY(contains(asphalt.source.notes.at(0), "32 wavelengths, 390 to 700 nm"));
    // One material. The converter scaled each block to the total scatter that the Zemax file states, which is above its
    // integral by 3 % at 15 degrees and by 20 % at 60.
    const materials::Material zemax = open("test_13_planesymmetric_brdf_zemax.bsdf"),
                              speos = open("test_13_planesymmetric_brdf_speos_reference.anisotropicbsdf");
    for (const double incident : {15.0, 30.0, 60.0})
      for (const double viewer : {0.0, 20.0, 40.0, 60.0}) {
        const Direction wi = fromSpherical(radians(incident), 1), wo = fromSpherical(radians(viewer), 1 + pi);
        const double ratio = speos.brdf->evaluate(wi, wo).x / zemax.brdf->evaluate(wi, wo).x;
        QVERIFY2(std::abs(ratio / (incident == 15   ? 1.033
                                   : incident == 30 ? 1.081
                                                    : 1.198) -
                          1) < 0.01,
                 numberText(ratio).c_str());
      }
    // At rotation 0, the first row: 5 degrees from the mirror direction of light at 10 degrees, toward the normal.
    QVERIFY(std::abs(sensor.brdf->evaluate(fromSpherical(radians(10), pi), fromSpherical(radians(5), 0)).x - 2.957e-3) <
            1e-8);
  }

  void environments() {
    SKIP_WITHOUT(cases);
    QVERIFY(glm::length(firstPixel("exr-chromaticities/white_xyz.exr") - glm::vec3(1)) < 2e-3f);
    QVERIFY(glm::length(firstPixel("exr-chromaticities/red_acescg.exr") - glm::vec3(1, 0, 0)) < 2e-3f);
    QVERIFY(glm::length(firstPixel("exr-luminance-chroma/red_yc.exr") - glm::vec3(1, 0, 0)) < 1e-2f);
    const auto open = [](const char* name) { return rendering::openEnvironment((cases / name).string()); };
    QVERIFY(open("exr-data-window/lower_half.exr")->image().pixels ==
            open("exr-data-window/lower_half_full.exr")->image().pixels);
    QVERIFY(contains(open("exr-tiny-negative/neg.exr")->notes().at(0), "1 pixels with negative values"));
    const Image& old = open("hdr-old-rle/old_rle.hdr")->image();
    QVERIFY(old.width == 32 && old.height == 16);
  }

  void meshes() {
    SKIP_WITHOUT(cases);
    for (const char* name : {"obj-bom/bom.obj", "obj-bom/bom_silent.obj", "obj-normal-index/no_normals.obj",
                             "obj-normal-index/normal_zero.obj", "obj-normal-index/nan_normal.obj",
                             "obj-normal-index/two_corner_face.obj"}) {
      const geometry::TriangleMesh mesh = meshOf(name);
      QVERIFY2(mesh.triangles().size() == 12 && mesh.isClosed() && mesh.isConvex(), name);
    }
    const geometry::TriangleMesh near = meshOf("obj-large-coordinates/near.obj"),
                                 far = meshOf("obj-large-coordinates/far.obj");
    QCOMPARE(near.positions().size(), far.positions().size());
    for (std::size_t i = 0; i < near.positions().size(); ++i)
      QVERIFY(glm::length(near.positions()[i] - far.positions()[i]) < 1e-4f);
    QVERIFY(meshOf("obj-plane-on-ground/plane.obj").bounds().min.y > -1 + 5e-4);
    QCOMPARE(meshOf("ply-tristrips/tristrips.ply").triangles().size(), std::size_t(2));
    // It stands on its base of four corners.
    const geometry::TriangleMesh pyramid = meshOf("gltf-skin/skin.gltf");
    QCOMPARE(std::ranges::count_if(pyramid.positions(),
                                   [&](const glm::vec3& p) { return p.y < pyramid.bounds().min.y + 0.01; }),
             std::ptrdiff_t(4));
    meshOf("gltf-sparse/sparse.gltf");
  }
};

GONIO_TEST(SharedFilesTest)
}  // namespace shared_files_test

#include "shared_files_test.moc"
