// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/colour.h"

#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"

namespace spectrum_test {
using namespace gonio;

Rgb rgbOf(const std::vector<double>& nanometres, const std::vector<double>& values) {
  const std::vector<Rgb> weights = spectrumWeights(nanometres);
  Rgb sum(0);
  for (std::size_t i = 0; i < values.size(); ++i) sum += weights[i] * values[i];
  return sum;
}

class SpectrumTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Rows of the CIE 1931 table (2 degrees).
  void observer() {
    const std::pair<double, glm::dvec3> rows[] = {{450, {0.3362, 0.0380, 1.7721}},
                                                  {500, {0.0049, 0.3230, 0.2720}},
                                                  {550, {0.4334, 0.9950, 0.0087}},
                                                  {600, {1.0622, 0.6310, 0.0008}},
                                                  {650, {0.2835, 0.1070, 0.0000}}};
    for (const auto& [at, expected] : rows) QVERIFY(glm::length(colourMatching(at) - expected) < 0.06);
  }

  /// Rows of the table of D65, one of its linear interpolation, and its ends.
  void daylightIsD65() {
    for (const auto& [at, expected] : {std::pair(380.0, 49.9755), {450, 117.008}, {560, 100}, {780, 63.3828}})
      QCOMPARE(illuminantD65(at), expected);
    QCOMPARE(illuminantD65(385), 0.5 * (49.9755 + 54.6482));
    QCOMPARE(illuminantD65(100), illuminantD65(380));
    QCOMPARE(illuminantD65(1e300), illuminantD65(780));
  }

  /// Chromaticity of the white that reflects all light: 0.3127, 0.3290 of D65, and linear sRGB of equal channels.
  void whiteHasTheChromaticityOfDaylight() {
    glm::dvec3 white(0);
    for (double at = minVisibleWavelength; at <= maxVisibleWavelength; at += 1)
      white += illuminantD65(at) * colourMatching(at);
    const double sum = white.x + white.y + white.z;
    QVERIFY(std::abs(white.x / sum - 0.3127) < 2e-4 && std::abs(white.y / sum - 0.3290) < 2e-4);
    const Rgb rgb = linearSrgb(white / white.y);
    QVERIFY(glm::length(rgb - Rgb(1)) < 2e-3);
    QVERIFY(glm::length(linearSrgb({0.9505, 1, 1.089}) - Rgb(1)) < 1e-3);
  }

  void linearInTheValues() {
    const std::vector<double> at{400, 500, 600, 700}, a{0.1, 0.7, 0.2, 0.4}, b{0.9, 0.3, 0, 0.5};
    std::vector<double> sum;
    for (std::size_t i = 0; i < a.size(); ++i) sum.push_back(2 * a[i] + 3 * b[i]);
    QVERIFY(glm::length(rgbOf(at, sum) - 2.0 * rgbOf(at, a) - 3.0 * rgbOf(at, b)) < 1e-12);
  }

  void evenSpectraAreGrey() {
    for (const std::vector<double>& at : {std::vector<double>{550}, {400, 500, 600, 700}, {300, 1000}, {100, 200}})
      QVERIFY(glm::length(rgbOf(at, std::vector<double>(at.size(), 0.3)) - Rgb(0.3)) < 1e-12);
  }

  /// Straight between the wavelengths: more of them on the same lines change nothing.
  void straightBetween() {
    const std::vector<double> few{400, 550, 700}, values{0.1, 0.9, 0.3};
    std::vector<double> many, between;
    for (double at = 400; at <= 700; at += 7.5) {
      many.push_back(at);
      between.push_back(at < 550 ? 0.1 + 0.8 * (at - 400) / 150 : 0.9 - 0.6 * (at - 550) / 150);
    }
    QVERIFY(glm::length(rgbOf(few, values) - rgbOf(many, between)) < 1e-12);
  }

  void colours() {
    const std::vector<double> at{430, 480, 530, 580, 630, 680};
    const Rgb red = rgbOf(at, {0, 0, 0, 0, 1, 1}), green = rgbOf(at, {0, 0, 1, 0, 0, 0}),
              blue = rgbOf(at, {1, 0.5, 0, 0, 0, 0});
    QVERIFY(red.x > 0.5 && red.x > 5 * std::abs(red.y) && red.x > 5 * std::abs(red.z));
    QVERIFY(green.y > 0.3 && green.y > green.z && green.x < 0);
    QVERIFY(blue.z > 0.5 && blue.z > 4 * std::abs(blue.x) && blue.z > 4 * std::abs(blue.y));
  }
};

GONIO_TEST(SpectrumTest)
}  // namespace spectrum_test

#include "spectrum_test.moc"
