// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/rgl/rgl_file.h"
#include "tests/core/io/synthetic_tensors.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace rgl_sampling_test {
using namespace gonio;
namespace fs = std::filesystem;

constexpr int million = 1 << 20, fewer = 1 << 17;
constexpr double tolerance = 1e-5;

/// Any densities, anisotropic where there are more than two azimuths.
std::shared_ptr<const RglBrdf> synthetic(const std::vector<float>& phis) {
  test::SyntheticRgl rgl;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.2f, 2);
  const std::uint64_t slices = phis.size() * 2;
  rgl.phis = phis;
  rgl.rgb.assign(slices * 12, 1);
  rgl.vndf.resize(slices * 9);
  for (float& value : rgl.vndf) value = uniform(random);
  // Nothing at the pole: the square stretches without bound there.
  for (std::size_t i = 0; i < rgl.vndf.size(); i += 3) rgl.vndf[i] = 0;
  std::vector<float> luminance(slices * 4);
  for (float& value : luminance) value = uniform(random);
  std::vector<test::TensorField> fields = rgl.fields();
  fields.push_back(test::floatField("luminance", {phis.size(), 2, 2, 2}, luminance));
  return rgl::readRgl(io::MemorySource(test::tensorFile(fields))).brdf;
}

QByteArray described(const test::SamplingCheck& check) {
  return "integral " + QByteArray::number(check.integral, 'g', 8) + ", lost " + QByteArray::number(check.lost) +
         ", p " + QByteArray::number(check.pValue) + ", 2 % wider " + QByteArray::number(check.widerPValue);
}

void verify(const RglBrdf& brdf, double theta, double phi, double maxLost, int draws) {
  const auto check = test::checkSampling(brdf, fromSpherical(theta, phi), draws, tolerance);
  QVERIFY2(check.valid, described(check));
  QVERIFY2(check.lost < maxLost, described(check));
  QVERIFY2(std::abs(check.integral + check.lost - 1) < 3e-3, described(check));
  QVERIFY2(check.pValue > 1e-4, described(check));
  if (draws == million) QVERIFY2(check.widerPValue < 1e-9, described(check));
}

/// Draws from the luminance and the visible normals of an RGL file.
class RglSamplingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void syntheticFiles_data() {
    QTest::addColumn<std::vector<float>>("phis");
    QTest::addRow("isotropic") << std::vector<float>{0};
    for (const int reduction : {1, 2, 4})
      QTest::addRow("azimuth reduction %d", reduction)
          << std::vector<float>{float(-pi), float(-pi + pi / reduction), float(-pi + 2 * pi / reduction)};
  }
  void syntheticFiles() {
    QFETCH(std::vector<float>, phis);
    const auto brdf = synthetic(phis);
    verify(*brdf, 0.5, 2.1, 0.5, million);
    verify(*brdf, 1.2, -0.4, 0.7, fewer);
  }

  void measuredFiles_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"vch_golden_yellow", "acrylic_felt_green", "satin_purple", "cm_toxic_green"})
      QTest::newRow(name) << QString(name);
  }
  void measuredFiles() {
    QFETCH(QString, name);
    const fs::path path = fs::path(GONIO_SHARED_DIR) / "data/rgl" / (name.toStdString() + "_rgb.bsdf");
    if (!fs::exists(path)) QSKIP("the development data is absent");
    const auto brdf = rgl::readRgl(io::FileSource(path)).brdf;
    verify(*brdf, 0.3, 0.7, 0.05, million);
    verify(*brdf, 1.2, 0.7, 0.2, fewer);
  }
};

GONIO_TEST(RglSamplingTest)
}  // namespace rgl_sampling_test

#include "rgl_sampling_test.moc"
