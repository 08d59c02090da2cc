// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/math/colour.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace openmaterial_file_test {
using namespace gonio;
using namespace gonio::test;
using formats::ScatteredSamples;

double lobe(double thetaI, double thetaO, double phi, double nanometres) {
  return 0.05 + 0.02 * std::cos(thetaI) * std::cos(thetaO) + 0.01 * (1 - std::cos(phi)) * std::sin(thetaO) +
         1e-4 * (nanometres - 500);
}

/// JSON of rows; wavelengths in nm.
std::string tableFile(const std::vector<int>& nanometres, bool isGrid) {
  std::string rows;
  for (const int wavelength : nanometres)
    for (int i = 0; i <= (isGrid ? 60 : 0); i += 20)
      for (int o = 0; o <= 75; o += 15)
        for (int phi = 0; phi < 360; phi += 45) {
          const double angles[]{radians(i), radians(o), radians(phi)};
          rows += (rows.empty() ? "[" : ",\n[") + numberText(wavelength * 1e-9) + ", " + numberText(angles[0]) + ", " +
                  numberText(angles[1]) + ", " + numberText(angles[2]) + ", " +
                  numberText(lobe(angles[0], angles[1], angles[2], wavelength)) + "]";
        }
  return R"({"metadata": {"name": "closed form"}, "brdf": {"wavelengths": [5e-7], "lookupTable": [)" + rows + "]}}";
}
std::string rowsFile(const std::string& rows) {
  return R"({"metadata": {}, "brdf": {"wavelengths": [], "lookupTable": [)" + rows + "]}}";
}

ScatteredSamples read(const std::string& text) { return formats::readOpenMaterial(io::MemorySource(bytesOf(text))); }

class OpenMaterialFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At the nodes, the spectrum of the closed form as a colour.
  void valuesAtTheNodes() {
    const std::vector<double> nanometres{450, 550, 650};
    const std::vector<Rgb> weights = spectrumWeights(nanometres);
    const materials::Material file = materialOfText(tableFile({450, 550, 650}, true));
    QCOMPARE(file.source.format, std::string("OpenMATERIAL"));
    QCOMPARE(file.source.description, std::string("closed form"));
    QCOMPARE(file.source.grid, (std::vector<int>{4, 8, 6}));
    QVERIFY(contains(file.source.notes.at(0), "3 wavelengths, 450 to 650 nm"));
    for (int i = 20; i <= 60; i += 20)
      for (int o = 15; o <= 75; o += 15)
        for (int phi = 0; phi < 360; phi += 45) {
          Rgb expected(0);
          for (std::size_t w = 0; w < 3; ++w)
            expected += weights[w] * lobe(radians(i), radians(o), radians(phi), nanometres[w]);
          const Direction wi = fromSpherical(radians(i), 2), wo = fromSpherical(radians(o), 2 + radians(phi));
          QVERIFY(glm::length(file.brdf->evaluate(wi, wo) - expected) < 1e-6);
        }
  }

  void greyWithoutThreeVisibleWavelengths() {
    for (const std::vector<int>& wavelengths : {std::vector{905}, {905, 1064, 1550}, {550, 650}}) {
      const ScatteredSamples samples = read(tableFile(wavelengths, false));
      QVERIFY(contains(samples.notes.at(0), "as grey"));
      double expected = 0;
      for (const int wavelength : wavelengths)
        expected += lobe(0, radians(15), 0, wavelength) / double(wavelengths.size());
      // The rows are in the order of the polar angle of the exit.
      QVERIFY(glm::length(samples.values.at(8) - Rgb(expected)) < 1e-12);
    }
  }

  void errorsNameTheRow() {
    const std::string good = "[5e-7, 0.1, 0.2, 0, 0.5]";
    QVERIFY(contains(read(rowsFile(good + ", [5e-7, 0.3, 0.2, 0, null]")).notes.at(1), "1 rows with null"));
    VERIFY_REFUSED(materialOfText, rowsFile(good + ", [5e-7, 0.1]"), "brdf.lookupTable[1]: found ");
    VERIFY_REFUSED(materialOfText, rowsFile(good + ", 7"), "brdf.lookupTable[1]: found the number 7");
    VERIFY_REFUSED(materialOfText, rowsFile(R"([5e-7, 0.1, 0.2, 0, "x"])"),
                   "found the string \"x\", expected a finite number");
    VERIFY_REFUSED(materialOfText, rowsFile("[550, 0.1, 0.2, 0, 0.5]"), "found the wavelength 550");
    VERIFY_REFUSED(materialOfText, rowsFile("[5e-7, 30, 0.2, 0, 0.5]"), "found the polar angle 30");
    VERIFY_REFUSED(materialOfText, rowsFile(good + "," + good), "found a second value");
    VERIFY_REFUSED(materialOfText, rowsFile(good + ", [6e-7, 0.3, 0.2, 0, 0.5], [5e-7, 0.3, 0.2, 0, 0.5]"),
                   "found 2 wavelengths at the polar angles 0.3 and 0.2, expected the 1 of the first directions");
    VERIFY_REFUSED(materialOfText, rowsFile(""), "found no row with a value");
    VERIFY_REFUSED(materialOfText, R"({"brdf": {"lookupTable": [[1, 2)", "found text that is not JSON");
    VERIFY_REFUSED(materialOfText, R"({"brdf": 3, "lookupTable": []})", "brdf: found the number 3");
  }
};

GONIO_TEST(OpenMaterialFileTest)
}  // namespace openmaterial_file_test

#include "openmaterial_file_test.moc"
