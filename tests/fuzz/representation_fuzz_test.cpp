// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <atomic>
#include <cmath>

#include "core/math/parallel.h"
#include "core/rendering/render_material.h"
#include "tests/fuzz/reader_seeds.h"
#include "tests/fuzz/reader_targets.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace representation_fuzz_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::fuzz;

Bytes wholeCircleSeed() {
  Bytes bytes;
  for (const std::int32_t count : {2, 3, 12}) append(bytes, count);
  for (int i = 0; i < 216; ++i) append(bytes, i % 11 == 3 ? -1.0 : 10.0 * (i % 50));
  return bytes;
}

Bytes anisotropicRglSeed() {
  test::SyntheticRgl rgl;
  rgl.phis = {float(-pi), 0, float(pi)};
  rgl.rgb.resize(72);
  rgl.vndf.resize(54);
  for (std::size_t i = 0; i < rgl.rgb.size(); ++i) rgl.rgb[i] = float(i % 13) * 0.1f;
  for (std::size_t i = 0; i < rgl.vndf.size(); ++i) rgl.vndf[i] = float(i % 5);
  return rgl.file();
}

/// Every form that a material is read in, and the sampler that renders it, at random pairs of directions (20,000; long
/// tests: a million): at the horizon and below, at the pole, in the mirror direction, back to the light.
class RepresentationFuzzTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void finiteAtHardDirections_data() {
    QTest::addColumn<Bytes>("bytes");
    QTest::newRow("folded table") << merlSeed();
    QTest::newRow("whole circle table") << wholeCircleSeed();
    QTest::newRow("RGL") << rglSeed();
    QTest::newRow("anisotropic RGL") << anisotropicRglSeed();
    QTest::newRow("UTIA") << utiaSeed();
    QTest::newRow("Zemax") << zemaxSeed();
    QTest::newRow("LightTools") << lightToolsSeed();
    QTest::newRow("PDV factors") << pdvSeed();
    QTest::newRow("neural BRDF") << neuralSeed();
  }
  void finiteAtHardDirections() {
    QFETCH(Bytes, bytes);
    const auto material = materials::readMaterial(io::MemorySource(bytes));
    const Brdf& brdf = *material.brdf;
    const RenderMaterial rendered(material.brdf);
    const bool mayBeNegative = formOf<RglBrdf>(brdf) != nullptr;
    const std::size_t count = test::longTests() ? 1'000'000 : 20'000;
    std::atomic<std::size_t> bad = 0;
    parallelForBlocks(count, 1000, [&](std::size_t begin, std::size_t end) {
      std::mt19937_64 random(begin);
      std::uniform_real_distribution<double> uniform(0, 1);
      for (std::size_t n = begin; n < end; ++n) {
        const DirectionPair pair = test::hardPair(random);
        const Rgb value = brdf.evaluate(pair.wi, pair.wo);
        bool good = true;
        for (int c = 0; c < 3; ++c) good = good && std::isfinite(value[c]) && (mayBeNegative || value[c] >= 0);
        if (isBelowHorizon(pair.wi) || isBelowHorizon(pair.wo)) good = good && value == Rgb(0);
        const double densities[] = {brdf.pdf(pair.wi, pair.wo), rendered.pdf(pair.wi, pair.wo)};
        for (const double density : densities) good = good && std::isfinite(density) && density >= 0;
        if (pair.wo.z > 0) {
          const glm::dvec3 u(uniform(random), uniform(random), uniform(random));
          for (const DirectionSample& drawn : {brdf.sample(pair.wo, u), rendered.sample(pair.wo, u)})
            good = good && std::isfinite(drawn.pdf) && drawn.pdf >= 0 && (drawn.pdf == 0 || drawn.wi.z > 0);
        }
        bad += !good;
      }
    });
    QCOMPARE(bad.load(), std::size_t(0));
  }
};

GONIO_TEST(RepresentationFuzzTest)
}  // namespace representation_fuzz_test

#include "representation_fuzz_test.moc"
