// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_errors.h"

#include <QTest>
#include <cmath>
#include <set>

#include "core/math/colour.h"
#include "core/metrics/image_metrics.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace image_errors_test {
using namespace gonio;
using namespace gonio::metrics;

Image uniform(const Rgb& colour, int width = 16, int height = 12) {
  Image image(width, height);
  for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(colour);
  return image;
}

/// Waves, a ramp and stripes, all in [0, 1].
Image pattern(int width, int height, double shift) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) =
          glm::vec3(Rgb(0.5 + 0.5 * std::sin(0.7 * x + 0.2 * y + shift), (x + shift * y) / (width + shift * height),
                        std::fmod(x + y + 2 * shift, 7) < 3 ? 0.9 : 0.1));
  return image;
}

double encodedLuminance(const Image& image, int x, int y) { return toSrgb(luminance(displayed(Rgb(image.at(x, y))))); }

/// SSIM by its definition: each window alone, in two dimensions, the moments about the means.
double similarityByDefinition(const Image& a, const Image& b) {
  double sum = 0, windows = 0;
  for (int cy = 5; cy < a.height - 5; ++cy)
    for (int cx = 5; cx < a.width - 5; ++cx, ++windows) {
      double total = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
      const auto visit = [&](auto add) {
        for (int y = -5; y <= 5; ++y)
          for (int x = -5; x <= 5; ++x)
            add(std::exp(-(x * x + y * y) / 4.5), encodedLuminance(a, cx + x, cy + y),
                encodedLuminance(b, cx + x, cy + y));
      };
      visit([&](double w, double p, double q) {
        total += w;
        ma += w * p;
        mb += w * q;
      });
      ma /= total;
      mb /= total;
      visit([&](double w, double p, double q) {
        va += w / total * (p - ma) * (p - ma);
        vb += w / total * (q - mb) * (q - mb);
        cov += w / total * (p - ma) * (q - mb);
      });
      sum += (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
    }
  return sum / windows;
}

struct ColourPair {
  glm::dvec3 a, b;
  double difference;
};
/// Sharma, Wu and Dalal 2005, table 1.
constexpr ColourPair sharmaPairs[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

class ImageErrorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void squaredErrorsOfUniformPictures() {
    const Image r = uniform({2, 1, 0.5}), t = uniform({1.5, 1, 1});
    QVERIFY(std::abs(meanSquaredError(r, t) - (0.25 + 0.25) / 3) < 1e-9);
    const double red = std::log(3 / 2.5), blue = std::log(1.5 / 2);
    QVERIFY(std::abs(meanSquaredLogError(r, t) - (red * red + blue * blue) / 3) < 1e-9);
    QVERIFY(std::abs(relativeMeanSquaredError(r, t) - (0.25 / 4.01 + 0.25 / 0.26) / 3) < 1e-9);
    QCOMPARE(meanSquaredLogError(uniform(Rgb(-1)), uniform(Rgb(0))), 0.0);
  }

  /// PSNR is the peak over the MSE.
  void mseAgreesWithPsnr() {
    const Image r = pattern(20, 14, 0), t = pattern(20, 14, 0.4);
    float peak = 0;
    for (const glm::vec3& pixel : r.pixels) peak = std::max({peak, pixel.x, pixel.y, pixel.z});
    const double psnr = 10 * std::log10(double(peak) * double(peak) / meanSquaredError(r, t));
    QVERIFY(std::abs(psnr - peakSignalToNoiseRatio(r, t)) < 1e-9);
  }

  /// Uniform pictures have no variance: the luminance term alone.
  void ssimOfUniformPictures() {
    const double a = toSrgb(0.5), b = toSrgb(0.2), c1 = 1e-4;
    const double expected = (2 * a * b + c1) / (a * a + b * b + c1);
    QVERIFY(std::abs(structuralSimilarity(uniform(Rgb(0.5)), uniform(Rgb(0.2))) - expected) < 1e-6);
    // Radiance above 1 is displayed as 1.
    QVERIFY(std::abs(structuralSimilarity(uniform(Rgb(3)), uniform(Rgb(7))) - 1) < 1e-9);
  }

  void ssimIsItsDefinition() {
    const Image a = pattern(17, 13, 0), b = pattern(17, 13, 0.8);
    const double expected = similarityByDefinition(a, b), found = structuralSimilarity(a, b);
    QVERIFY(expected < 0.9);
    QVERIFY2(std::abs(found - expected) < 1e-9, qPrintable(QString("%1 %2").arg(found).arg(expected)));
    QVERIFY(std::isnan(structuralSimilarity(pattern(10, 20, 0), pattern(10, 20, 1))));
  }

  void publishedColourDifferences() {
    for (const ColourPair& pair : sharmaPairs) {
      QVERIFY2(std::abs(ciede2000(pair.a, pair.b) - pair.difference) < 6e-5,
               qPrintable(QString("%1 %2").arg(ciede2000(pair.a, pair.b)).arg(pair.difference)));
      QVERIFY(std::abs(ciede2000(pair.a, pair.b) - ciede2000(pair.b, pair.a)) < 1e-9);
    }
  }

  /// Greys differ in L* alone. Between black and white, mean L* = 50, S_L is 1: the difference is 100.
  void colourDifferencesOfPictures() {
    QVERIFY(std::abs(meanColourDifference(uniform(Rgb(0)), uniform(Rgb(1))) - 100) < 1e-3);
    // L* of a luminance of 0.18 is 49.496; to white the mean is 74.748.
    const double fromGrey = std::pow(74.748 - 50, 2), scale = 1 + 0.015 * fromGrey / std::sqrt(20 + fromGrey);
    QVERIFY(std::abs(meanColourDifference(uniform(Rgb(0.18)), uniform(Rgb(1))) - 50.504 / scale) < 1e-3);
    Image half = uniform(Rgb(0));
    for (std::size_t i = 0; i < half.pixels.size() / 2; ++i) half.pixels[i] = glm::vec3(5);
    QVERIFY(std::abs(meanColourDifference(uniform(Rgb(0)), half) - 50) < 1e-3);
  }

  /// Filters and features leave uniform pictures as they are: the colour error alone. Green and blue have the largest
  /// distance, 1 by definition. The distance of black and white is 100, beyond the bend.
  void flipOfUniformPictures() {
    QVERIFY(std::abs(flip(uniform({0, 1, 0}), uniform({0, 0, 1})) - 1) < 1e-6);
    // Hunt-adjusted L*a*b*: green (87.735, -75.617, 72.980), blue (32.297, 25.578, -34.836).
    const double largest = std::pow(87.735 - 32.297 + std::hypot(25.578 + 75.617, 72.980 + 34.836), 0.7);
    const double edge = 0.4 * largest;
    const double white = 0.95 + 0.05 * (std::pow(100, 0.7) - edge) / (largest - edge);
    QVERIFY(std::abs(flip(uniform(Rgb(0)), uniform(Rgb(1))) - white) < 1e-4);
    const double grey = 0.95 / edge * std::pow(49.496, 0.7);  // L* of 0.18, before the bend
    QVERIFY(std::abs(flip(uniform(Rgb(0)), uniform(Rgb(0.18))) - grey) < 1e-4);
  }

  /// By an independent program with filters in two dimensions (NumPy), after the formulas of the paper.
  void flipOfPatterns() {
    const Image reference = pattern(24, 20, 0);
    QVERIFY(std::abs(flip(reference, pattern(24, 20, 0.3)) - 0.335338898500744) < 1e-5);
    QVERIFY(std::abs(flip(reference, pattern(24, 20, 1)) - 0.6037431940879381) < 1e-5);
    Image spike = uniform(Rgb(0.2), 32, 32);
    spike.at(16, 16) = glm::vec3(1);
    QVERIFY(std::abs(flip(uniform(Rgb(0.2), 32, 32), spike) - 0.004380222685678944) < 1e-6);
  }

  void equalPicturesHaveNoError() {
    const Image image = pattern(20, 14, 0);
    const std::vector<double> errors = imageErrors(image, image);
    QCOMPARE(errors.size(), imageMetricRecords().size());
    std::set<std::string_view> ids;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const ImageMetricRecord& record = imageMetricRecords()[i];
      QVERIFY2(std::abs(errors[i] - (record.id == "ssim" ? 1 : 0)) < 1e-12, record.id.data());
      QVERIFY(!record.name.empty() && !record.domain.empty() && !record.formula.empty() && !record.reference.empty());
      ids.insert(record.id);
      QVERIFY_THROWS_EXCEPTION(Error, record.compute(uniform(Rgb(1), 2, 2), uniform(Rgb(1), 4, 1)));
    }
    QCOMPARE(ids.size(), errors.size());
  }
};

GONIO_TEST(ImageErrorsTest)
}  // namespace image_errors_test

#include "image_errors_test.moc"
