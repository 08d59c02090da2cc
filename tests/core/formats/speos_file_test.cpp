// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/math/colour.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace speos_file_test {
using namespace gonio;
using namespace gonio::test;

constexpr double percent = 20, unit = 7;  ///< of the reflected light; of the values of the file

/// With azimuth 0 on the side of the mirror direction; polar angles in rad.
double lobe(double thetaI, double thetaO, double phi) {
  return 0.05 + 0.02 * std::cos(thetaI) * std::cos(thetaO) + 0.01 * (1 + std::cos(phi)) * std::sin(thetaO);
}

/// Of all polar angles and azimuths, at one incidence.
std::string tableText(bool isIntensity, double incident, double factor) {
  std::string text;
  for (int phi = 0; phi <= 360; phi += 10) text += "\t" + numberText(double(phi));
  text += "\n";
  for (int theta = 0; theta <= 90; theta += 5) {
    text += numberText(double(theta));
    const double thetaO = radians(theta);
    for (int phi = 0; phi <= 360; phi += 10)
      text += "\t" + numberText(factor * lobe(radians(incident), thetaO, radians(phi)) *
                                (isIntensity ? std::max(std::cos(thetaO), 0.0) : 1));
    text += "\n";
  }
  return text;
}

/// As converters write it: without a description or a last line, each wavelength in another unit.
std::string spectralFile(bool isIntensity) {
  std::string text = "OPTIS - brdf surface file v9.0\n0\nScattering surface 7\n0\n\n1\t0\n" +
                     std::string(isIntensity ? "0" : "1") +
                     "\n4\t3\n0.000\t20.000\t40.000\t60.000\n450.0\t550.0\t650.0\n";
  for (const double incident : {0.0, 20.0, 40.0, 60.0})
    for (const auto& [reflectance, factor] : {std::pair("10.000000", 7.0), {"20.000000", 1.0}, {"40.000000", 0.3}})
      text += std::string(reflectance) + "\n19\t37\n" + tableText(isIntensity, incident, factor);
  return text;
}

std::string speosFile(bool isIntensity, const std::string& spectrum) {
  std::string text = "OPTIS - Anisotropic BSDF surface file v8.0\n0\n\n23\nMeasurement description\n0\t1\t0\n1\t0\n" +
                     std::string(isIntensity ? "0" : "1") + "\n1\n0.0\t\n4\n0.0\t20.0\t40.0\t60.0\t\n20.0\t0\n\n" +
                     spectrum;
  for (const double incident : {0.0, 20.0, 40.0, 60.0}) text += "19 37\n" + tableText(isIntensity, incident, unit);
  return text + "End of file\n";
}
const std::string grey = "2\n350\t20\n850\t20\n";

/// What the block at an incidence reflects, by trapezoids: the azimuths of the closed form by hand, the polar angles in
/// steps of 5 degrees.
double reflected(double incident = 20) {
  double sum = 0;
  for (int theta = 0; theta < 90; theta += 5)
    for (const double t : {radians(theta), radians(theta + 5)})
      sum += radians(5) / 2 * std::sin(t) * std::cos(t) * 2 * pi *
             (0.05 + 0.02 * std::cos(radians(incident)) * std::cos(t) + 0.01 * std::sin(t));
  return sum;
}

class SpeosFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At each node below the horizon's: scaled so that the incidence of the spectrum reflects 20 %.
  void valuesAtTheNodes() {
    for (const bool isIntensity : {false, true}) {
      const materials::Material file = materialOfText(speosFile(isIntensity, grey));
      QCOMPARE(file.source.format, std::string("Speos"));
      QCOMPARE(file.source.grid, (std::vector<int>{4, 36, 18}));
      QCOMPARE(contains(file.source.notes.at(0), "intensity, divided by cos theta"), isIntensity);
      const double scale = percent / 100 / reflected();
      for (const double incident : {20.0, 40.0, 60.0})
        for (int theta = 5; theta <= 85; theta += 5)
          for (int phi = 0; phi < 360; phi += 10) {
            const Direction wi = fromSpherical(radians(incident), 1),
                            wo = fromSpherical(radians(theta), 1 + pi + radians(phi));
            const double expected = scale * lobe(radians(incident), radians(theta), radians(phi));
            const Rgb value = file.brdf->evaluate(wi, wo);
            QVERIFY2(glm::length(value - Rgb(expected)) < 1e-6,
                     (numberText(value.x) + " " + numberText(expected)).c_str());
          }
    }
  }

  /// The spectrum colours all directions alike.
  void spectrum() {
    const std::vector<double> wavelengths{450, 550, 650}, percents{10, 20, 40};
    const std::vector<Rgb> weights = spectrumWeights(wavelengths);
    Rgb expected(0);
    for (std::size_t i = 0; i < 3; ++i) expected += weights[i] * percents[i];
    const materials::Material file = materialOfText(speosFile(false, "3\n450\t10\n550\t20\n650\t40\n"));
    const Rgb value = file.brdf->evaluate(fromSpherical(radians(40), 0), fromSpherical(radians(10), 2));
    QVERIFY(glm::length(value / value.y - expected / expected.y) < 1e-5);
  }

  /// Spectral files: each table reflects its own percentage, whatever the unit of its values.
  void spectralFiles() {
    const std::vector<double> wavelengths{450, 550, 650}, percents{10, 20, 40};
    const std::vector<Rgb> weights = spectrumWeights(wavelengths);
    Rgb white(0);
    for (std::size_t i = 0; i < 3; ++i) white += weights[i] * (percents[i] / 100);
    for (const bool isIntensity : {false, true}) {
      const materials::Material file = materialOfText(spectralFile(isIntensity) + (isIntensity ? "End of file\n" : ""));
      QCOMPARE(file.source.format, std::string("Speos"));
      QVERIFY(contains(file.source.notes.at(0), "each of the 3 wavelengths reflects its percentage"));
      for (const double incident : {20.0, 40.0, 60.0})
        for (int theta = 5; theta <= 85; theta += 5)
          for (int phi = 0; phi < 360; phi += 30) {
            const Direction wi = fromSpherical(radians(incident), 1),
                            wo = fromSpherical(radians(theta), 1 + pi + radians(phi));
            const Rgb expected = white / reflected(incident) * lobe(radians(incident), radians(theta), radians(phi));
            QVERIFY(glm::length(file.brdf->evaluate(wi, wo) - expected) < 1e-6);
          }
    }
    const std::string text = spectralFile(false);
    VERIFY_REFUSED(materialOfText, text + "7\n", "found '7', expected the end of the file");
    VERIFY_REFUSED(materialOfText, replaced(text, "\n1\t0\n1\n", "\n0\t1\n1\n"), "found transmission");
    VERIFY_REFUSED(materialOfText, replaced(text, "650.0", "550.0"), "expected ascending wavelengths");
    VERIFY_REFUSED(materialOfText, text.substr(0, text.size() / 2), "expected");
    VERIFY_REFUSED(materialOfText, "OPTIS - brdf surface file v9.0\n1\nbinary\n", "binary Speos files are not read");
    VERIFY_REFUSED(materialOfText, std::string("OPTIS - brdf surface file v9.0\n\x01\0\0\0\x9c\x80", 37),
                   "binary Speos files are not read");
    // One wavelength with another azimuth.
    const std::size_t second = text.find("20.000000\n");
    VERIFY_REFUSED(materialOfText, text.substr(0, second) + replaced(text.substr(second), "\t350\t360", "\t350\t359"),
                   "expected the same for all wavelengths");
  }

  /// The description may have several lines; line 4 states its number of characters.
  void longDescriptions() {
    const materials::Material expected = materialOfText(speosFile(false, grey));
    const Direction wi = fromSpherical(0.5, 1), wo = fromSpherical(0.7, 3);
    for (const char* count : {"19", "20"}) {  // without and with the last line break
      const materials::Material file = materialOfText(replaced(speosFile(false, grey), "23\nMeasurement description\n",
                                                               std::string(count) + "\nseveral\n3 lines\n1 2\n"));
      QVERIFY(file.brdf->evaluate(wi, wo) == expected.brdf->evaluate(wi, wo));
    }
  }

  /// Between two angles of incidence, the factor is weighted by the distances; before the first one it is the first's.
  void spectraAtOtherIncidences() {
    const Direction wi = fromSpherical(radians(40), 0), wo = fromSpherical(radians(10), 2);
    const auto valueAt = [&](const char* theta) {
      return materialOfText(replaced(speosFile(false, grey), "\n20.0\t0\n", "\n" + std::string(theta) + "\t0\n"))
          .brdf->evaluate(wi, wo)
          .x;
    };
    const double at20 = valueAt("20"), at40 = valueAt("40");
    QVERIFY(std::abs(at20 - at40) > 1e-4 * at20);
    QVERIFY(std::abs(valueAt("25") - (0.75 * at20 + 0.25 * at40)) < 1e-6 * at20);
    QVERIFY(valueAt("-5") == valueAt("0") && valueAt("70") == valueAt("60"));
  }

  void errorsSayWhatWasFound() {
    const std::string text = speosFile(false, grey);
    VERIFY_REFUSED(materialOfText, replaced(text, "v8.0\n0\n", "v8.0\n1\n"), "binary Speos files are not read");
    VERIFY_REFUSED(materialOfText, replaced(text, "\n1\t0\n1\n", "\n0\t1\n1\n"),
                   "found transmission; expected reflection");
    VERIFY_REFUSED(materialOfText, replaced(text, "\n1\t0\n1\n", "\n1\t0\n2\n"), "line 8: found '2");
    VERIFY_REFUSED(materialOfText, replaced(text, "850\t20", "250\t20"), "expected ascending wavelengths");
    VERIFY_REFUSED(materialOfText, replaced(text, "19 37", "19 36"), "found angles of the incidence 0 that");
    VERIFY_REFUSED(materialOfText, replaced(text, "End of file", "7"), "expected End of file");
    VERIFY_REFUSED(materialOfText, text.substr(0, text.size() / 2), "expected");
    VERIFY_REFUSED(materialOfText, replaced(text, "\t10\t20\t30\t", "\t20\t10\t30\t"), "expected ascending angles");
  }
};

GONIO_TEST(SpeosFileTest)
}  // namespace speos_file_test

#include "speos_file_test.moc"
