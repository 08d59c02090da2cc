// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_picture.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/brdf/tabulated_brdf.h"
#include "core/rendering/scene_file.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace rendered_comparison_test {
using namespace gonio;
using namespace gonio::rendering;

std::shared_ptr<const TabulatedBrdf> plastic() {
  static const auto table = bakeTable(*test::ggx(Rgb(0.05, 0.2, 0.3), Rgb(0.9, 0.5, 0.2), 0.2, 0.04),
                                      {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 30});
  return table;
}

/// A measurement's noise: every cell times 1 + deviation x normal noise, at least 0.
std::shared_ptr<const TabulatedBrdf> withNoise(const TabulatedBrdf& table, double deviation) {
  std::vector<TabulatedBrdf::Value> values(table.values().begin(), table.values().end());
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(1, deviation);
  for (auto& value : values) value *= float(std::max(0.0, noise(random)));
  return std::make_shared<const TabulatedBrdf>(table.grid(), std::move(values),
                                               std::vector<std::uint8_t>(table.valid().begin(), table.valid().end()));
}

RenderOptions pictures(int samples) { return {.width = 32, .height = 32, .samples = samples, .density = {}}; }

class RenderedComparisonTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aMaterialIsItself() {
    const RenderedComparison comparison(*plastic(), pictures(4));
    const ComparisonPicture picture = comparison.render(*plastic());
    QCOMPARE(comparison.signalToNoiseRatio(picture), std::numeric_limits<double>::infinity());
    QCOMPARE(comparison.peakSignalToNoiseRatio(picture), std::numeric_limits<double>::infinity());
    QVERIFY(picture.image.pixels == comparison.reference().pixels);
  }

  /// The halves do not share their noise, and the picture is their mean.
  void thePictureIsTheMeanOfItsHalves() {
    const RenderedComparison comparison(*plastic(), pictures(5));
    const ComparisonPicture picture = comparison.render(*plastic());
    QVERIFY(picture.halves[0].pixels != picture.halves[1].pixels);
    RenderOptions half = pictures(3);
    half.density = estimateSamplingDensity(*plastic());
    QVERIFY(picture.halves[0].pixels == renderPicture(*plastic(), comparisonScene(), half).pixels);
    for (std::size_t i = 0; i < picture.image.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c)
        QCOMPARE(picture.image.pixels[i][c], 0.5f * (picture.halves[0].pixels[i][c] + picture.halves[1].pixels[i][c]));
  }

  /// Recorded paths give the picture of a renderer, of any material, in front of a visible environment too.
  void recordedPathsAreThoseOfTheRenderer() {
    Scene scene = sphereScene(studioEnvironment());
    scene.showEnvironment = true;
    const RenderedComparison comparison(scene, *plastic(), pictures(4));
    const auto metal = test::ggx(Rgb(0), Rgb(0.9, 0.7, 0.3), 0.05, 0.9);
    const ComparisonPicture recorded = comparison.render(*metal), traced = comparison.trace(*metal);
    QVERIFY(recorded.image.alpha == traced.image.alpha);
    double brightest = 0;
    for (std::size_t i = 0; i < traced.image.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double value = traced.image.pixels[i][c];
        QVERIFY(std::abs(recorded.image.pixels[i][c] - value) <= 1e-6 * value);
        brightest = std::max(brightest, value);
      }
    QVERIFY(brightest > 1);
  }

  /// Where light is reflected twice, or an object has a material of its own, pictures do not share their paths.
  void onlySharedPathsAreRecorded() {
    RenderOptions options = pictures(1);
    options.density = estimateSamplingDensity(*plastic());
    const auto isRecorded = [&](const char* name) { return recordPaths(openScene(name, 2), options).has_value(); };
    QVERIFY(isRecorded("sphere") && isRecorded("sphere-distant-light"));
    QVERIFY(!isRecorded("sphere-on-plane") && !isRecorded("two-spheres"));
  }

  /// The SNR of a noisy table does not depend on the samples; that of the mean pictures rises with them.
  void theRatioIsThatOfManySamples() {
    const auto test = withNoise(*plastic(), 0.5);
    const RenderedComparison many(*plastic(), pictures(2048));
    const double truth = many.signalToNoiseRatio(many.render(*test));
    double found = 0, plain = 0;
    constexpr std::uint64_t seeds = 8;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      RenderOptions options = pictures(32);
      options.seed = seed;
      const RenderedComparison few(*plastic(), options);
      const ComparisonPicture picture = few.render(*test);
      found += few.signalToNoiseRatio(picture) / seeds;
      plain += metrics::signalToNoiseRatio(few.reference(), picture.image) / seeds;
    }
    qInfo("%.2f dB of few samples, %.2f of many, %.2f without halves", found, truth, plain);
    QVERIFY(std::abs(found - truth) < 0.5);
    QVERIFY(plain < truth - 2);
  }
};

GONIO_TEST(RenderedComparisonTest)
}  // namespace rendered_comparison_test

#include "rendered_comparison_test.moc"
