// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_metrics.h"

#include <QTest>
#include <cmath>

#include "core/support/error.h"

using namespace gonio;
using namespace gonio::metrics;

namespace {
Image constant(float value, int width = 4, int height = 3) {
  Image image(width, height);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(value);
  return image;
}
}  // namespace

class ImageMetricsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A tenth of the amplitude is 20 dB.
  void closedForms() {
    QVERIFY(std::abs(signalToNoiseRatio(constant(2), constant(1.8f)) - 20) < 1e-5);
    QVERIFY(std::abs(peakSignalToNoiseRatio(constant(2), constant(1.8f)) - 20) < 1e-5);
    Image reference = constant(1), test = constant(1);
    reference.at(2, 1) = test.at(2, 1) = glm::vec3(8, 2, 1);
    test.at(0, 0) = glm::vec3(0);
    QVERIFY(std::abs(signalToNoiseRatio(reference, test) - 10 * std::log10((33.0 + 69) / 3)) < 1e-9);
    QVERIFY(std::abs(peakSignalToNoiseRatio(reference, test) - 10 * std::log10(64.0 * 36 / 3)) < 1e-9);
  }

  void scaleDoesNotMatter() {
    const double snr = signalToNoiseRatio(constant(0.25f), constant(0.3125f));
    QVERIFY(std::abs(signalToNoiseRatio(constant(1024), constant(1280)) - snr) < 1e-12);
  }

  void hardCase44ZeroReferenceOrZeroNoise() {
    for (const auto metric : {signalToNoiseRatio, peakSignalToNoiseRatio}) {
      QCOMPARE(metric(constant(1), constant(1)), std::numeric_limits<double>::infinity());
      QVERIFY(std::isnan(metric(constant(0), constant(0))));
      QVERIFY(std::isnan(metric(constant(0), constant(1))));
      QVERIFY(std::isfinite(metric(constant(1), constant(0))));
    }
  }

  void differentSizesAreRefused() {
    QVERIFY_THROWS_EXCEPTION(Error, signalToNoiseRatio(constant(1, 2, 2), constant(1, 4, 1)));
  }
};

QTEST_APPLESS_MAIN(ImageMetricsTest)
#include "image_metrics_test.moc"
