// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/spectrum.h"

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
