// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_encoder.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/materials/material.h"
#include "core/rgl/rgl_file.h"
#include "core/sampling/directional_albedo.h"
#include "tests/core/export/loader_rules.h"
#include "tests/core/export/published_reader.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace rgl_encoder_test {
using namespace gonio;
using namespace gonio::rendering;
using rgl::EncodedRgl;
using rgl::RglFileSource;

rgl::RglOptions small(std::size_t thetaCount, std::size_t size) { return {.size = {{thetaCount, size}}}; }

EncodedRgl encoded(const std::shared_ptr<const Brdf>& brdf, const rgl::RglOptions& options = {},
                   const RglFileSource* source = nullptr) {
  RenderOptions pictures;
  pictures.width = pictures.height = pictures.samples = 32;
  const auto reference = [&](const TaskControl&) { return RenderedComparison(*brdf, pictures); };
  return rgl::encodeRgl(*brdf, source, "glossy, of nothing", options, reference);
}

std::shared_ptr<const RglBrdf> read(std::span<const std::byte> bytes) {
  return rgl::readRgl(io::MemorySource(bytes)).brdf;
}

std::shared_ptr<const Brdf> glossy() { return test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(0.9), 0.25, 0.05); }

/// A bundled measured file with its bytes.
RglFileSource bundled(const std::string& name) {
  const materials::Material material = materials::readMaterial("library:rgl/" + name);
  return {.brdf = {material.brdf, formOf<RglBrdf>(*material.brdf)}, .bytes = materials::materialFile(material.source)};
}

/// Pairs of which neither direction is at the horizon.
std::vector<DirectionPair> randomPairs(int count) {
  std::mt19937_64 random(7);
  std::vector<DirectionPair> pairs;
  while (int(pairs.size()) < count) {
    const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
    if (pair.wi.z > 0.1 && pair.wo.z > 0.1) pairs.push_back(pair);
  }
  return pairs;
}

/// 10 log10 of the energy of the reflected light, f cos theta_i, over that of its errors, where each direction of the
/// viewer counts as the part of a sphere's picture that is seen from there.
double ratio(const Brdf& truth, const std::function<Rgb(const DirectionPair&)>& found) {
  double energy = 0, error = 0;
  for (const DirectionPair& pair : randomPairs(2000)) {
    const Rgb value = truth.evaluate(pair.wi, pair.wo) * pair.wi.z, difference = found(pair) * pair.wi.z - value;
    energy += pair.wo.z * glm::dot(value, value);
    error += pair.wo.z * glm::dot(difference, difference);
  }
  return 10 * std::log10(energy / error);
}

class RglEncoderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void loadersTakeTheFiles_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("glossy") << 0;
    QTest::newRow("anisotropic") << 1;
    QTest::newRow("black") << 2;
    QTest::newRow("negative") << 3;
    QTest::newRow("RGL") << 4;
  }
  void loadersTakeTheFiles() {
    QFETCH(int, kind);
    std::shared_ptr<const Brdf> material = glossy();
    const RglFileSource source = bundled("paper_blue");
    if (kind == 1)
      material = std::make_shared<test::FunctionBrdf>(
          [](const Direction& wi, const Direction&) { return Rgb(0.2 + 0.1 * wi.x * wi.x); }, false);
    if (kind == 2) material = std::make_shared<test::FunctionBrdf>(test::lambert(Rgb(0)));
    if (kind == 3)
      material = std::make_shared<test::FunctionBrdf>(
          [](const Direction& wi, const Direction&) { return Rgb(wi.z - 0.5, 0.1, 0.1); });
    const EncodedRgl made = kind == 4 ? encoded(source.brdf, {}, &source) : encoded(material, small(5, 16));
    QCOMPARE(test::brokenRule(made.rgb, false), QString());
    QCOMPARE(test::brokenRule(made.spectral, true), QString());
    QCOMPARE(made.negativeValues > 0, kind == 3);
  }

  /// A material that differs left and right of the plane of incidence keeps both sides.
  void sidesOfThePlaneOfIncidence() {
    const auto tinted = std::make_shared<test::FunctionBrdf>(
        [](const Direction& wi, const Direction& wo) { return Rgb(0.2 + 0.1 * (wo.x * wi.y - wo.y * wi.x)); });
    const test::PublishedReader file(encoded(tinted, small(12, 32)).rgb);
    const double found = ratio(*tinted, [&](const DirectionPair& p) { return file.value(p.wo, p.wi); });
    QVERIFY2(found > 35, qPrintable(QString::number(found)));
  }

  /// Colours outside sRGB stay negative in the RGB file, and are spectra that are nowhere negative in the other: pbrt
  /// sets negative values to 0.
  void coloursOutsideTheGamut() {
    const auto cyan = std::make_shared<test::FunctionBrdf>(
        [](const Direction& wi, const Direction& wo) { return Rgb(-0.02, 0.2, 0.15) * (1 + wi.z * wo.z); });
    const EncodedRgl made = encoded(cyan, small(12, 32));
    QVERIFY(made.negativeValues > 0);
    const io::TensorFile spectral{io::MemorySource(made.spectral)};
    for (const float value : spectral.floats("spectra", 5)) QVERIFY(value >= 0);
    for (const auto& file : {read(made.rgb), read(made.spectral)}) {
      const double found = ratio(*cyan, [&](const DirectionPair& p) { return file->evaluate(p.wi, p.wo); });
      QVERIFY2(found > 35, qPrintable(QString::number(found)));
    }
    QVERIFY(made.rgbSnr > 35 && made.spectralSnr > 35);
  }

  /// A coat that is seen at a slant alone, of which retro-reflection shows nothing, has nodes in a small file.
  void highlightsAtASlant() {
    const auto coat = test::ggx(Rgb(0), Rgb(1), 0.1, 1);
    const auto material = std::make_shared<test::FunctionBrdf>([&coat](const Direction& wi, const Direction& wo) {
      const double fresnel = std::pow(1 - glm::dot(wi, glm::normalize(wi + wo)), 5);
      return Rgb(0.3, 0.25, 0.2) + fresnel * coat->evaluate(wi, wo);
    });
    const double snr = encoded(material, small(16, 32)).rgbSnr;
    QVERIFY2(snr > 38, qPrintable(QString::number(snr)));
  }

  /// The published formula and our reader agree to the rounding of floats.
  void readersAgree() {
    const EncodedRgl made = encoded(glossy(), small(24, 32));
    const auto ours = read(made.rgb);
    const test::PublishedReader published(made.rgb);
    for (const DirectionPair& pair : randomPairs(500)) {
      const Rgb a = ours->evaluate(pair.wi, pair.wo), b = published.value(pair.wo, pair.wi);
      for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(a[c] - b[c]) <= 1e-4 * b[c], qPrintable(QString::number(a[c] / b[c])));
    }
  }

  /// By the published formula a file comes to the material with its size, to less than a quarter of the error with four
  /// times the nodes each way; then the parameterisation's square root at the pole and its kinks at the horizon remain.
  void filesConverge() {
    const auto material = glossy();
    const auto found = [&](std::size_t thetaCount, std::size_t size) {
      const EncodedRgl made = encoded(material, small(thetaCount, size));
      const test::PublishedReader file(made.rgb);
      return ratio(*material, [&](const DirectionPair& pair) { return file.value(pair.wo, pair.wi); });
    };
    const double coarse = found(6, 8), fine = found(24, 32), finest = found(48, 64);
    QVERIFY2(fine > coarse + 12 && finest > fine, qPrintable(QString("%1 to %2 dB").arg(coarse).arg(fine)));
    const double snr = encoded(material, small(24, 32)).rgbSnr;
    QVERIFY2(snr > 40, qPrintable(QString::number(snr)));
  }

  /// A material that is not reciprocal keeps the viewer as the incident direction.
  void viewerIsIncident() {
    const test::FunctionBrdf material(
        [](const Direction& wi, const Direction& wo) { return Rgb(0.1 + 0.2 * wi.z + 0.05 * wo.z); }, true, false);
    const auto made = encoded(std::make_shared<test::FunctionBrdf>(material), small(12, 32));
    const auto file = read(made.rgb);
    const double found = ratio(material, [&](const DirectionPair& p) { return file->evaluate(p.wi, p.wo); });
    QVERIFY2(found > 35, qPrintable(QString::number(found)));
  }

  void anisotropicMaterials() {
    const test::FunctionBrdf material(
        [](const Direction& wi, const Direction& wo) {
          const Direction h = glm::normalize(wi + wo);
          return Rgb(0.05) + 0.5 * std::exp(-(h.x * h.x / 0.16 + h.y * h.y / 0.49) / (h.z * h.z));
        },
        false);
    rgl::RglOptions options = small(12, 24);
    options.azimuths = 16;
    const auto made = encoded(std::make_shared<test::FunctionBrdf>(material), options);
    const auto file = read(made.rgb);
    QVERIFY(!file->isIsotropic());
    const double found = ratio(material, [&](const DirectionPair& p) { return file->evaluate(p.wi, p.wo); });
    QVERIFY2(found > 30, qPrintable(QString::number(found)));
  }

  /// Both files hold the same material: spectra seen under D65 are the colours.
  void spectraAreTheColours() {
    const EncodedRgl made = encoded(glossy(), small(5, 16));
    const auto rgb = read(made.rgb), spectral = read(made.spectral);
    for (const DirectionPair& pair : randomPairs(100)) {
      const Rgb a = rgb->evaluate(pair.wi, pair.wo), b = spectral->evaluate(pair.wi, pair.wo);
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(a[c] - b[c]) <= 1e-5 * luminance(a));
    }
  }

  /// Light that is sampled by the file's own densities has the material's albedo.
  void sampledAlbedo() {
    const auto material = glossy();
    const auto file = read(encoded(material, small(24, 32)).rgb);
    for (const double theta : {0.2, 0.9}) {
      const Direction viewer = fromSpherical(theta, 0.3);
      std::mt19937_64 random(3);
      std::uniform_real_distribution<double> uniform(0, 1);
      Rgb sum(0);
      constexpr int samples = 200000;
      for (int i = 0; i < samples; ++i) {
        const DirectionSample s = file->sample(viewer, {uniform(random), uniform(random), uniform(random)});
        if (s.pdf > 0) sum += file->evaluate(s.wi, viewer) * s.wi.z / s.pdf;
      }
      const Rgb albedo = directionalAlbedo(*material, theta);
      for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(sum[c] / samples / albedo[c] - 1) < 5e-3, qPrintable(QString::number(sum[c] / samples)));
    }
  }

  /// A chosen size reaches what was asked for, and a more exact file is not smaller.
  void sizeFollowsTheAccuracy() {
    rgl::RglOptions options = small(0, 0);
    options.size.reset();
    options.snr = 25;
    const EncodedRgl rough = encoded(glossy(), options);
    QVERIFY(rough.rgbSnr >= 25);
    options.snr = 40;
    const EncodedRgl fine = encoded(glossy(), options);
    QVERIFY(fine.rgbSnr >= 40 && fine.rgb.size() >= rough.rgb.size());
    options.maxBytes = 100'000;
    options.snr = 90;
    QVERIFY(encoded(glossy(), options).rgb.size() < 110'000);
  }

  /// All fields of an unedited file come back: those of the bundled one with their values, of a whole one with its
  /// bytes.
  void uneditedFilesStay() {
    const RglFileSource source = bundled("vch_golden_yellow");
    const EncodedRgl first = encoded(source.brdf, {}, &source);
    QVERIFY(first.unchanged && std::isinf(first.rgbSnr));
    const auto again = read(first.rgb);
    for (const DirectionPair& pair : randomPairs(300)) {
      const Rgb a = source.brdf->evaluate(pair.wi, pair.wo), b = again->evaluate(pair.wi, pair.wo);
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(a[c] - b[c]) <= 1e-5 * std::abs(a[c]) + 1e-9);
    }
    const RglFileSource whole{again, first.rgb}, spectral{read(first.spectral), first.spectral};
    QVERIFY(encoded(again, {}, &whole).rgb == first.rgb);
    QVERIFY(encoded(spectral.brdf, {}, &spectral).spectral == first.spectral);
  }

  /// Edits of the colours alone keep the nodes, and the file shows the edited material.
  void editedColoursKeepTheParameterisation() {
    RglFileSource source = bundled("satin_purple");
    source.onlyColoursChanged = true;
    const auto base = source.brdf;
    const auto tinted = std::make_shared<test::FunctionBrdf>(
        [base](const Direction& wi, const Direction& wo) {
          return glm::max(Rgb(0), base->evaluate(wi, wo)) * Rgb(0.5, 1.5, 1);
        },
        true, false);
    const EncodedRgl made = encoded(tinted, {}, &source);
    QVERIFY(made.ownParameterisation && !made.unchanged);
    QVERIFY2(made.rgbSnr > 50 && made.spectralSnr > 50, qPrintable(QString::number(made.rgbSnr)));
    const io::TensorFile before{io::MemorySource(source.bytes)}, after{io::MemorySource(made.rgb)};
    for (const char* name : {"theta_i", "phi_i"}) QVERIFY(before.floats(name, 1) == after.floats(name, 1));
    for (const char* name : {"ndf", "sigma"}) QVERIFY(before.floats(name, 2) == after.floats(name, 2));
    const auto spectral = read(made.spectral);
    const double found = ratio(*tinted, [&](const DirectionPair& p) { return spectral->evaluate(p.wi, p.wo); });
    QVERIFY2(found > 30, qPrintable(QString::number(found)));
  }

  /// A highlight that becomes narrower than the nodes of its file gets nodes of its own, with densities that belong to
  /// it: light sampled by them has the edited albedo.
  void narrowedHighlightsGetNewNodes() {
    const RglFileSource source = bundled("satin_purple");
    const std::shared_ptr<const Brdf> narrow = test::ggx(Rgb(0.1, 0.02, 0.1), Rgb(0.8), 0.05, 0.04);
    const EncodedRgl made = encoded(narrow, {}, &source);
    QVERIFY(!made.ownParameterisation);
    QVERIFY2(made.rgbSnr >= 40, qPrintable(QString::number(made.rgbSnr)));
    const auto file = read(made.rgb);
    const Direction viewer = fromSpherical(0.5, 0.2);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0, squares = 0;
    constexpr int samples = 20000;
    for (int i = 0; i < samples; ++i) {
      const DirectionSample s = file->sample(viewer, {uniform(random), uniform(random), uniform(random)});
      const double weight = s.pdf > 0 ? file->evaluate(s.wi, viewer).y * s.wi.z / s.pdf : 0;
      sum += weight;
      squares += weight * weight;
    }
    const double mean = sum / samples, deviation = std::sqrt(squares / samples - mean * mean);
    QVERIFY2(std::abs(mean / directionalAlbedo(*narrow, 0.5).y - 1) < 0.02, qPrintable(QString::number(mean)));
    QVERIFY2(deviation < mean, qPrintable(QString::number(deviation / mean)));
  }

  void descriptionTellsTheOrigin() {
    const EncodedRgl made = encoded(glossy(), small(4, 16));
    const std::string text = rgl::readRgl(io::MemorySource(made.rgb)).description;
    for (const char* part : {"glossy, of nothing", "viewer", "dB"})
      QVERIFY2(text.find(part) != std::string::npos, text.c_str());
  }
};

GONIO_TEST(RglEncoderTest)

}  // namespace rgl_encoder_test

#include "rgl_encoder_test.moc"
