// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_metrics.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace image_metrics_test {
using namespace gonio;
using namespace gonio::metrics;

Image constant(float value, int width = 4, int height = 3) {
  Image image(width, height);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(value);
  return image;
}

/// Normal noise of a standard deviation in every channel.
Image noisy(Image image, double deviation, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, deviation);
  for (glm::vec3& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) pixel[c] += float(noise(random));
  return image;
}
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
    using Metric = double (*)(const Image&, const Image&);
    for (const Metric metric : {Metric(signalToNoiseRatio), Metric(peakSignalToNoiseRatio)}) {
      QCOMPARE(metric(constant(1), constant(1)), std::numeric_limits<double>::infinity());
      QVERIFY(std::isnan(metric(constant(0), constant(0))));
      QVERIFY(std::isnan(metric(constant(0), constant(1))));
      QVERIFY(std::isfinite(metric(constant(1), constant(0))));
    }
  }

  void pairsOfEqualHalvesAreThePlainPictures() {
    const Image reference = noisy(constant(2), 0.5, 1), test = noisy(constant(2), 0.5, 2);
    const auto twice = [](const Image& image) { return PicturePair{image, image}; };
    const double snr = signalToNoiseRatio(reference, test), psnr = peakSignalToNoiseRatio(reference, test);
    QVERIFY(std::abs(signalToNoiseRatio(twice(reference), twice(test)) - snr) < 1e-12);
    QVERIFY(std::abs(peakSignalToNoiseRatio(twice(reference), twice(test)) - psnr) < 1e-12);
  }

  /// A tenth of the amplitude, under noise of three times that error: 20 dB of a pair, where the mean picture has 13.
  void noiseOfThePicturesDoesNotCountInPairs() {
    const int side = 200;
    const Image reference = constant(2, side, side), test = constant(1.8f, side, side);
    const double deviation = 0.6;
    const PicturePair tests{noisy(test, deviation, 1), noisy(test, deviation, 2)};
    const PicturePair references{reference, reference};
    // Standard error of the energy: per channel sqrt(2 0.2^2 0.6^2 + 0.6^4) = 0.44, over 120,000 of 0.04 each: 3.2 %.
    QVERIFY(std::abs(signalToNoiseRatio(references, tests) - 20) < 4 * 0.14);
    QVERIFY(std::abs(peakSignalToNoiseRatio(references, tests) - 20) < 4 * 0.14);
    QVERIFY(std::abs(signalToNoiseRatio(reference, tests[0]) - 10 * std::log10(4 / 0.4)) < 0.1);
  }

  /// Of halves that err against each other the sum of products is negative: the SNR is the bound that is known.
  void whatDrownsInNoiseIsABound() {
    const int side = 100;
    const Image reference = constant(1, side, side);
    const PicturePair references{reference, reference};
    const PicturePair opposed{constant(1.1f, side, side), constant(0.9f, side, side)};
    // All products are -0.03: their standard error is 0.03 x 100 pixels.
    QVERIFY(std::abs(signalToNoiseRatio(references, opposed) - 10 * std::log10(3e4 / 3)) < 1e-5);
    const double unknown = signalToNoiseRatio(references, {noisy(reference, 0.1, 1), noisy(reference, 0.1, 2)});
    QVERIFY(unknown > signalToNoiseRatio(reference, noisy(reference, 0.1, 1)) + 10);
    QVERIFY(std::isfinite(unknown));
  }

  /// One half differs in one pixel, the other nowhere: all products are 0, the pictures are not equal.
  void onlyEqualPairsAreEqual() {
    const PicturePair reference{constant(1), constant(1)};
    PicturePair test = reference;
    test[0].at(1, 1) = glm::vec3(1.5f, 1, 1);
    QVERIFY(std::abs(signalToNoiseRatio(reference, test) - 10 * std::log10(36 / 0.0625)) < 1e-9);
  }

  void hardCase44HoldsForPairs() {
    const auto pair = [](float value) { return PicturePair{constant(value), constant(value)}; };
    QCOMPARE(signalToNoiseRatio(pair(1), pair(1)), std::numeric_limits<double>::infinity());
    QCOMPARE(peakSignalToNoiseRatio(pair(1), pair(1)), std::numeric_limits<double>::infinity());
    QVERIFY(std::isnan(signalToNoiseRatio(pair(0), pair(0))));
    QVERIFY(std::isnan(signalToNoiseRatio(pair(0), pair(1))));
    QVERIFY(std::isnan(peakSignalToNoiseRatio(pair(0), pair(1))));
    QVERIFY(std::isfinite(signalToNoiseRatio(pair(1), pair(0))));
  }

  void differentSizesAreRefused() {
    QVERIFY_THROWS_EXCEPTION(Error, signalToNoiseRatio(constant(1, 2, 2), constant(1, 4, 1)));
    const PicturePair one{constant(1, 2, 2), constant(1, 2, 2)}, other{constant(1, 2, 2), constant(1, 4, 1)};
    QVERIFY_THROWS_EXCEPTION(Error, signalToNoiseRatio(one, other));
    QVERIFY_THROWS_EXCEPTION(Error, signalToNoiseRatio(other, one));
  }
};

GONIO_TEST(ImageMetricsTest)
}  // namespace image_metrics_test

#include "image_metrics_test.moc"
