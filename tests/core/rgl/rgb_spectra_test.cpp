// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgb_spectra.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/math/colour.h"
#include "tests/support/test_program.h"

namespace rgb_spectra_test {
using namespace gonio;

class RgbSpectraTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void seenAsThePrimaries() {
    const rgl::SpectralBasis& basis = rgl::spectralBasis();
    const auto observer = spectrumWeights(std::vector<double>(basis.nanometres.begin(), basis.nanometres.end()));
    QCOMPARE(basis.nanometres.size(), 18u);
    for (int channel = 0; channel < 3; ++channel) {
      Rgb seen(0);
      for (std::size_t k = 0; k < observer.size(); ++k) seen += basis.values[k][channel] * observer[k];
      for (int c = 0; c < 3; ++c)
        QVERIFY2(std::abs(seen[c] - (c == channel)) < 1e-6, qPrintable(QString::number(seen[c])));
    }
  }

  void energyIsKept() {
    for (const Rgb& values : rgl::spectralBasis().values) {
      QVERIFY(values.x >= 0 && values.y >= 0 && values.z >= 0);
      const double sum = values.x + values.y + values.z;
      QVERIFY2(std::abs(sum - 1) < 1e-6, qPrintable(QString::number(sum)));
    }
  }

  /// Colours inside sRGB are sums of the basis; measured colours outside it keep their exact colour too, without
  /// negative values; and a small step in the colour is a small step in the spectrum, across the borders of sRGB.
  void coloursOutsideTheGamut() {
    const std::vector<float>& nanometres = rgl::spectralBasis().nanometres;
    const auto observer = spectrumWeights(std::vector<double>(nanometres.begin(), nanometres.end()));
    const auto spectrumOf = [&](const Rgb& colour) {
      std::vector<float> values(nanometres.size());
      rgl::colourSpectrum(colour, values);
      return values;
    };
    const auto seen = [&](const std::vector<float>& values) {
      Rgb sum(0);
      for (std::size_t k = 0; k < values.size(); ++k) sum += double(values[k]) * observer[k];
      return sum;
    };
    const auto inside = spectrumOf({0.2, 0.5, 0.7});
    for (std::size_t k = 0; k < inside.size(); ++k)
      QVERIFY(std::abs(inside[k] - glm::dot(rgl::spectralBasis().values[k], Rgb(0.2, 0.5, 0.7))) < 1e-6);
    std::mt19937_64 random(1);
    std::exponential_distribution<double> few(1);
    int outside = 0;
    for (int i = 0; i < 1000; ++i) {
      Rgb colour(0);  // of a spectrum from 440 to 640 nm, a few of its knots far above the others
      for (std::size_t k = 3; k <= 13; ++k) colour += std::pow(few(random), 8) * observer[k];
      colour /= maxChannel(colour);
      outside += std::min({colour.x, colour.y, colour.z}) < 0;
      const std::vector<float> values = spectrumOf(colour);
      for (const float value : values) QVERIFY(value >= 0);
      const Rgb found = seen(values), stated = rgl::spectralColour(colour);
      for (int c = 0; c < 3; ++c) {
        QVERIFY2(std::abs(found[c] - colour[c]) < 1e-6, qPrintable(QString("%1 %2 %3: %4 %5 %6")
                                                                       .arg(colour.x)
                                                                       .arg(colour.y)
                                                                       .arg(colour.z)
                                                                       .arg(found.x)
                                                                       .arg(found.y)
                                                                       .arg(found.z)));
        QVERIFY(std::abs(stated[c] - found[c]) < 1e-6);
      }
    }
    QVERIFY(outside > 300);
    for (const Rgb& border : {Rgb(0, 0.5, 0.4), Rgb(0.6, 0.4, 0), Rgb(0.5, 0, 0.5), Rgb(0, 1, 0)}) {
      const auto low = spectrumOf(border - 1e-6), high = spectrumOf(border + 1e-6);
      for (std::size_t k = 0; k < low.size(); ++k) QVERIFY(std::abs(low[k] - high[k]) < 1e-4);
    }
    // No spectrum is more saturated than a single wavelength: the nearest colour of the fan.
    const Rgb impossible = seen(spectrumOf({-5, 1, 1}));
    QVERIFY(impossible.x < 0 && impossible.x > -5 && impossible.y > 0 && impossible.z > 0);
  }
};

GONIO_TEST(RgbSpectraTest)

}  // namespace rgb_spectra_test

#include "rgb_spectra_test.moc"
