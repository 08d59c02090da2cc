// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_edit.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/math/colour.h"
#include "core/rgl/rgl_encoder.h"
#include "core/rgl/rgl_file.h"
#include "tests/support/function_brdf.h"
#include "tests/support/spectral_file.h"
#include "tests/support/test_program.h"

namespace spectral_edit_test {
using namespace gonio;
using namespace gonio::rendering;

using namespace gonio::test::spectral;

std::shared_ptr<const RglBrdf> read(std::span<const std::byte> bytes) {
  return rgl::readRgl(io::MemorySource(bytes)).brdf;
}

/// The colours of spectra.
std::vector<glm::vec3> coloursOf(const RglData& data, std::vector<float> spectra) {
  auto changed = std::make_shared<RglSpectra>(*data.spectra);
  changed->values = std::move(spectra);
  const std::vector<Rgb> weights =
      spectrumWeights(std::vector<double>(changed->nanometres.begin(), changed->nanometres.end()));
  std::vector<glm::vec3> result;
  for (std::size_t slice = 0; slice < slices; ++slice)
    for (std::size_t node = 0; node < plane; ++node) {
      Rgb colour(0);
      for (std::size_t w = 0; w < wavelengths; ++w)
        colour += weights[w] * double(changed->values[(slice * wavelengths + w) * plane + node]);
      result.emplace_back(colour);
    }
  return result;
}

class SpectralEditTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    bytes_ = spectralFile();
    file_ = read(bytes_);
  }

  /// The numbers of the file at its wavelengths, linear between them, constant beyond.
  void uneditedWavelengths() {
    const rgl::SpectralEdit same(data(), data().rgb);
    QVERIFY(same.spectra() == data().spectra->values);
    for (const std::size_t w : {0, 7, 40}) {
      const SliceStack<float> at = same.plane(data().spectra->nanometres[w]);
      for (std::size_t i = 0; i < at.values.size(); ++i) QCOMPARE(at.values[i], stored(w, i));
    }
    const SliceStack<float> between = same.plane(452.5), below = same.plane(300), above = same.plane(900);
    for (std::size_t i = 0; i < between.values.size(); ++i) {
      QVERIFY(std::abs(between.values[i] - (0.75 * stored(7, i) + 0.25 * stored(8, i))) < 1e-6);
      QCOMPARE(below.values[i], stored(0, i));
      QCOMPARE(above.values[i], stored(40, i));
    }
  }

  /// One factor for all channels is one for all wavelengths: the line stays a line, and what is black stays so.
  void brightnessKeepsTheShape() {
    for (const float factor : {0.25f, 3.0f}) {
      SliceStack<glm::vec3> rgb = data().rgb;
      for (glm::vec3& value : rgb.values) value *= factor;
      const std::vector<float> after = rgl::SpectralEdit(data(), rgb).spectra();
      for (std::size_t i = 0; i < after.size(); ++i)
        QVERIFY2(std::abs(after[i] - factor * data().spectra->values[i]) < 1e-5 * factor,
                 qPrintable(QString("%1: %2").arg(i).arg(after[i])));
    }
  }

  /// The observer sees the edited colours, inside the sRGB gamut, and no value is negative.
  void tintsAreSeen() {
    SliceStack<glm::vec3> rgb = data().rgb;
    for (glm::vec3& value : rgb.values) value *= glm::vec3(0.7f, 1.1f, 1.4f);
    const std::vector<float> after = rgl::SpectralEdit(data(), rgb).spectra();
    const std::vector<glm::vec3> seen = coloursOf(data(), after);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const glm::vec3 wanted = rgb.values[i];
      if (!(std::min({wanted.x, wanted.y, wanted.z}) > 0)) continue;
      ++inside;
      for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(seen[i][c] - wanted[c]) < 2e-3 * luminance(Rgb(wanted)),
                 qPrintable(QString("%1: %2 %3").arg(i).arg(seen[i][c]).arg(wanted[c])));
    }
    QVERIFY2(inside > seen.size() / 3, qPrintable(QString::number(inside)));
    QVERIFY(std::ranges::min(after) >= 0);
  }

  /// A black node becomes the spectrum of its new colour; the others, whose colours stay, keep every bit.
  void blackBecomesAColour() {
    SliceStack<glm::vec3> rgb = data().rgb;
    rgb.values[3] = {0.2f, 0.3f, 0.1f};
    const std::vector<float> after = rgl::SpectralEdit(data(), rgb).spectra();
    const glm::vec3 seen = coloursOf(data(), after)[3];
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(seen[c] - rgb.values[3][c]) < 1e-3);
    for (std::size_t i = 0; i < after.size(); ++i)
      if (i % plane != 3 || i >= plane * wavelengths) QCOMPARE(after[i], data().spectra->values[i]);
  }

  /// The file that is written has the wavelengths and the parameterisation of the one that was read, and one wavelength
  /// of it is what the editor shows of it.
  void writtenAsShown() {
    const rgl::RglFileSource source{.brdf = file_, .bytes = bytes_};
    const auto encoded = [&](const Brdf& material) {
      RenderOptions pictures;
      pictures.width = pictures.height = pictures.samples = 16;
      const auto reference = [&](const TaskControl&) { return RenderedComparison(material, pictures); };
      return rgl::encodeRgl(material, &source, "test", {.snr = 0}, reference).spectral;
    };
    QVERIFY(encoded(*file_) == bytes_);
    const auto edited = std::make_shared<test::FunctionBrdf>(
        [base = file_](const Direction& wi, const Direction& wo) {
          return glm::max(Rgb(0), base->evaluate(wi, wo)) * Rgb(0.5, 0.8, 0.9) + 0.01;
        },
        true, false);
    const std::vector<std::byte> spectral = encoded(*edited);
    const io::TensorFile before{io::MemorySource(bytes_)}, after{io::MemorySource(spectral)};
    for (const char* name : {"theta_i", "phi_i", "wavelengths"})
      QVERIFY(before.floats(name, 1) == after.floats(name, 1));
    for (const char* name : {"ndf", "sigma"}) QVERIFY(before.floats(name, 2) == after.floats(name, 2));
    QVERIFY(before.floats("vndf", 4) == after.floats("vndf", 4));
    const auto written = read(spectral);
    for (const double nanometres : {450.0, 545.0, 610.0}) {
      const auto shown = rgl::atWavelength(*file_, edited.get(), nanometres);
      const auto found = rgl::atWavelength(*written, nullptr, nanometres);
      QVERIFY(shown->tables()->data.rgb.values == found->tables()->data.rgb.values);
      QVERIFY(!(shown->tables()->data.rgb.values ==
                rgl::atWavelength(*file_, nullptr, nanometres)->tables()->data.rgb.values));
    }
  }

  /// One wavelength is grey, in the order of the directions that was chosen, and its samples follow it.
  void oneWavelengthIsGrey() {
    const auto light = file_->withIncident(IncidentDirection::light);
    const auto shown = rgl::atWavelength(*light, nullptr, 610);
    QVERIFY(shown->incidentDirection() == IncidentDirection::light);
    const DirectionPair pair{fromSpherical(0.4, 0.3), fromSpherical(0.7, 1.2)};
    const Rgb value = shown->evaluate(pair.wi, pair.wo);
    QVERIFY(value.x > 0 && value.x == value.y && value.y == value.z);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    double weights = 0;
    for (int i = 0; i < 2000; ++i) {
      const DirectionSample s = shown->sample(pair.wo, {uniform(random), uniform(random), uniform(random)});
      QVERIFY(std::isfinite(s.pdf) && s.pdf >= 0);
      if (s.pdf > 0) weights += 1 / s.pdf / 2000;
    }
    QVERIFY2(std::abs(weights / (2 * pi) - 1) < 0.2, qPrintable(QString::number(weights)));
  }

 private:
  const RglData& data() const { return file_->tables()->data; }
  /// Of node i of all slices.
  float stored(std::size_t wavelength, std::size_t i) const {
    return data().spectra->values[(i / plane * wavelengths + wavelength) * plane + i % plane];
  }

  std::vector<std::byte> bytes_;
  std::shared_ptr<const RglBrdf> file_;
};

GONIO_TEST(SpectralEditTest)

}  // namespace spectral_edit_test

#include "spectral_edit_test.moc"
