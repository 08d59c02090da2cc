// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "tests/support/function_brdf.h"
#include "tests/support/grain.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_spheres.h"

namespace anisotropic_preview_test {
using namespace gonio;
using namespace gonio::rendering;

const Scene& studio() {
  static const Scene scene = sphereScene(studioEnvironment(), {.yaw = 0.4, .pitch = 0.2});
  return scene;
}

widgets::PreviewSubject alone(const test::Grain& grain) {
  return {widgets::StandaloneModel{&models::findModel(grain.model), test::grainParameters(grain)}};
}

Image blockMeans(const Image& image) {
  constexpr int block = 8;
  Image means(image.width / block, image.height / block);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) means.at(x / block, y / block) += image.at(x, y) / float(block * block);
  return means;
}

/// Brushed materials under an environment: sampled along their grain, in the shader as on the CPU.
class AnisotropicPreviewTest : public test::SphereTest {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { openSpheres(); }

  /// Both converge to the same picture: what the shader draws follows the density that it divides by.
  void picturesAreThoseOfTheCpu_data() {
    QTest::addColumn<test::Grain>("grain");
    QTest::addColumn<bool>("isSampledAlongIt");
    QTest::addRow("ggx") << test::Grain{"ggx-anisotropic", 0.05, 0.4, 0.5} << true;
    QTest::addRow("ggx, wide") << test::Grain{"ggx-anisotropic", 0.2, 0.6, -1} << false;
    QTest::addRow("beckmann") << test::Grain{"beckmann-anisotropic", 0.05, 0.4, 1.2} << true;
    QTest::addRow("ward") << test::Grain{"ward-duer", 0.05, 0.4, 0} << true;
    QTest::addRow("ashikhmin-shirley") << test::Grain{"ashikhmin-shirley", 300, 10, 0.5} << true;
  }
  void picturesAreThoseOfTheCpu() {
    QFETCH(test::Grain, grain);
    QFETCH(bool, isSampledAlongIt);
    widgets::PreviewSubject subject = alone(grain);
    const auto brdf = widgets::subjectBrdf(subject);
    subject.density = std::make_shared<const TabulatedDensity>(*brdf);
    QCOMPARE(subject.density->grain().fraction > 0, isSampledAlongIt);
    // Means of 8 x 8 pixels: the noise of single ones averages out, what a density that is not the shader's own adds or
    // loses does not.
    constexpr int samples = 1536, side = test::OffscreenSpheres::side;
    const Image reference =
        renderPicture(*brdf, studio(), {.width = side, .height = side, .samples = 2 * samples, .seed = 7});
    const double snr =
        metrics::signalToNoiseRatio(blockMeans(reference), blockMeans(spheres_->drawn(subject, studio(), samples)));
    qInfo("%.1f dB", snr);
    QVERIFY2(snr > 45, qPrintable(QString("%1 dB").arg(snr)));
  }

  /// At equal samples there is less noise than with the mean over the azimuths, which is all that a lobe of the same
  /// values without a grain knows.
  void theGrainTakesNoiseAway() {
    widgets::PreviewSubject subject = alone({"ggx-anisotropic", 0.05, 0.4, 0.5});
    const auto brdf = widgets::subjectBrdf(subject);
    subject.density = std::make_shared<const TabulatedDensity>(*brdf);
    const Image converged = spheres_->drawn(subject, studio(), 4096);
    const double along = metrics::signalToNoiseRatio(converged, spheres_->drawn(subject, studio(), 64));
    subject.density = std::make_shared<const TabulatedDensity>(*bakeTable(*brdf));
    QCOMPARE(subject.density->grain().fraction, 0.0);
    const double mean = metrics::signalToNoiseRatio(converged, spheres_->drawn(subject, studio(), 64));
    qInfo("64 samples per pixel: %.1f dB along the grain, %.1f dB by the mean over the azimuths", along, mean);
    QVERIFY(along > mean + 2);
  }
};

GONIO_TEST(AnisotropicPreviewTest)
}  // namespace anisotropic_preview_test

#include "anisotropic_preview_test.moc"
