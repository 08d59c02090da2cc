// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/models/registry.h"
#include "core/rgl/rgl_file.h"
#include "tests/core/io/synthetic_tensors.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"

namespace rgl_preview_test {
using namespace gonio;
using namespace gonio::rendering;
namespace fs = std::filesystem;

/// Smooth random tensors over a few azimuths and polar angles of incidence.
std::shared_ptr<const RglBrdf> synthetic(const std::vector<float>& phis) {
  test::SyntheticRgl rgl;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0.3f, 1);
  rgl.phis = phis;
  rgl.thetas = {0, 0.5f, 1.1f, float(halfPi)};
  const std::uint64_t slices = phis.size() * 4;
  rgl.rgb.resize(slices * 12);
  rgl.vndf.resize(slices * 9);
  for (float& value : rgl.rgb) value = 0.1f * uniform(random);
  for (float& value : rgl.vndf) value = uniform(random);
  return rgl::readRgl(io::MemorySource(rgl.file())).brdf;
}

/// The shader's RGL files are those of core/brdf/rgl_brdf.h.
class RglPreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  void syntheticFiles_data() {
    QTest::addColumn<std::vector<float>>("phis");
    QTest::addRow("isotropic") << std::vector<float>{0};
    QTest::addRow("isotropic, two azimuths") << std::vector<float>{float(-pi), float(pi)};
    for (const int reduction : {1, 2, 4})
      QTest::addRow("azimuth reduction %d", reduction)
          << std::vector<float>{float(-pi), float(-pi + pi / reduction), float(-pi + 2 * pi / reduction)};
  }
  void syntheticFiles() {
    QFETCH(std::vector<float>, phis);
    const auto brdf = synthetic(phis);
    const auto density = std::make_shared<const TabulatedDensity>(*brdf);
    verify({widgets::EditedMaterial{brdf}, density}, sphereScene(), 50);
    // Divided by the viewer's cosine, so that the silhouette outshines everything: its pixels are sampled by chance.
    for (const IncidentDirection incident : {IncidentDirection::light, IncidentDirection::mean})
      verify({widgets::EditedMaterial{brdf->withIncident(incident)}, density}, sphereScene(), 24);
    verify({widgets::EditedMaterial{brdf, {test::rougherEdit("ggx", "roughness", 0.5)}}, density}, sphereScene(), 50);
  }

  /// Under one light, where nothing is drawn, and under the studio, where directions are.
  void measuredFiles_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"vch_golden_yellow", "acrylic_felt_green", "satin_purple"})
      QTest::newRow(name) << QString(name);
  }
  void measuredFiles() {
    QFETCH(QString, name);
    const fs::path path = fs::path(GONIO_SHARED_DIR) / "data/rgl" / (name.toStdString() + "_rgb.bsdf");
    if (!fs::exists(path)) QSKIP("the development data is absent");
    const auto brdf = rgl::readRgl(io::FileSource(path)).brdf;
    const auto density = std::make_shared<const TabulatedDensity>(*brdf);
    verify({widgets::EditedMaterial{brdf}, density}, sphereScene(), 40);
    verify({widgets::EditedMaterial{brdf}, density}, sphereScene(studioEnvironment(), {.yaw = 0.4, .pitch = 0.2}), 30);
    verify({widgets::EditedMaterial{brdf, {test::rougherEdit("ggx", "roughness", 0.5)}}, density}, sphereScene(), 40);
  }
};

GONIO_TEST(RglPreviewTest)
}  // namespace rgl_preview_test

#include "rgl_preview_test.moc"
