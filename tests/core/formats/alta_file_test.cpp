// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/math/colour.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace alta_file_test {
using namespace gonio;
using namespace gonio::test;
using formats::ScatteredSamples;

Rgb lobe(const Direction& wi, const Direction& wo) {
  return Rgb(0.1, 0.05, 0.02) + Rgb(0.05 * wi.z, 0.1 * wo.z * wo.z, 0.02 * (wi.x * wo.x + wi.y * wo.y + 1));
}

std::string altaFile(const std::string& input, int dimension, const std::string& output, int values,
                     const std::string& rows) {
  return "#ALTA_BEGIN_HEADER\n#DIM " + std::to_string(dimension) + "  " + std::to_string(values) + "\n#PARAM_IN " +
         input + "\n#PARAM_OUT " + output + "\n#VS 0\n#ALTA_END_HEADER\n" + rows;
}
std::string rgbFile(const std::string& input, int dimension, const std::string& rows) {
  return altaFile(input, dimension, "RGB_COLOR", 3, rows);
}

ScatteredSamples read(const std::string& text) { return formats::readAlta(io::MemorySource(bytesOf(text))); }

bool isClose(const Direction& a, const Direction& b) { return glm::length(a - b) < 1e-9; }

class AltaFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The same pairs in every kind of coordinates; the oracles are written out by hand.
  void coordinates() {
    for (const auto& [wi, wo] : scatteredPairs(50)) {
      const Rgb value = lobe(wi, wo);
      const double thetaI = std::acos(wi.z), phiI = std::atan2(wi.y, wi.x), thetaO = std::acos(wo.z),
                   phiO = std::atan2(wo.y, wo.x);
      const auto check = [&](const std::string& text, bool isTurned) {
        const ScatteredSamples samples = read(text);
        QCOMPARE(samples.values.size(), std::size_t(1));
        QVERIFY(glm::length(samples.values[0] - value) < 1e-12);
        const auto& [readI, readO] = samples.directions[0];
        // Without an azimuth of its own a pair may be turned about the normal.
        if (isTurned)
          QVERIFY(std::abs(readI.z - wi.z) < 1e-9 && std::abs(readO.z - wo.z) < 1e-9 &&
                  std::abs(glm::dot(readI, readO) - glm::dot(wi, wo)) < 1e-9);
        else
          QVERIFY(isClose(readI, wi) && isClose(readO, wo));
      };
      const auto row = [&](std::initializer_list<double> at) {
        std::string text = rowText(at, " ");
        text.pop_back();
        return text + " " + rowText({value.x, value.y, value.z}, "\t");
      };
      check(rgbFile("ISOTROPIC_TV_TL_DPHI", 3, row({thetaO, thetaI, phiI - phiO})), true);
      check(rgbFile("SPHERICAL_TL_PL_TV_PV", 4, row({thetaI, phiI, thetaO, phiO})), false);
      check(rgbFile("CARTESIAN", 6, row({wo.x, wo.y, wo.z, wi.x, wi.y, wi.z})), false);
      // The viewer, turned so that the half vector is the normal.
      const Direction half = glm::normalize(wi + wo);
      const double thetaH = std::acos(half.z), phiH = std::atan2(half.y, half.x);
      const Direction flat(std::cos(phiH) * wo.x + std::sin(phiH) * wo.y, std::cos(phiH) * wo.y - std::sin(phiH) * wo.x,
                           wo.z);
      const Direction difference(std::cos(thetaH) * flat.x - std::sin(thetaH) * flat.z, flat.y,
                                 std::sin(thetaH) * flat.x + std::cos(thetaH) * flat.z);
      const double thetaD = std::acos(difference.z), phiD = std::atan2(difference.y, difference.x);
      check(rgbFile("RUSIN_TH_PH_TD_PD", 4, row({thetaH, phiH, thetaD, phiD})), false);
      check(rgbFile("RUSIN_TH_TD_PD", 3, row({thetaH, thetaD, phiD})), true);
    }
  }

  void values() {
    const std::string at = "0.5 0.25 1 ";
    const auto value = [&](const std::string& output, int count, const std::string& numbers) {
      return read(altaFile("ISOTROPIC_TV_TL_DPHI", 3, output, count, at + numbers + "\n")).values.at(0);
    };
    QVERIFY(value("INV_STERADIAN", 1, "0.5") == Rgb(0.5));
    QVERIFY(value("INV_STERADIAN", 3, "0.5 1 2") == Rgb(0.5, 1, 2));
    QVERIFY(glm::length(value("INV_STERADIAN_COSINE_FACTOR", 1, "0.5") - Rgb(0.5 / std::cos(0.5))) < 1e-12);
    QVERIFY(glm::length(value("XYZ_COLOR", 3, "0.9505 1 1.089") - Rgb(1)) < 1e-3);
    // A confidence interval at the end of the row.
    const std::string interval = altaFile("ISOTROPIC_TV_TL_DPHI", 3, "INV_STERADIAN", 1, at + "0.5 0.4 0.6\n");
    VERIFY_REFUSED(materialOfText, interval, "expected 3 coordinates and 1 values");
    const ScatteredSamples samples = read(std::string(interval).replace(interval.find("#VS 0"), 5, "#VS 2"));
    QVERIFY(samples.values[0] == Rgb(0.5) && contains(samples.notes.at(1), "confidence intervals"));
  }

  /// A grid of ALTA is a table: at its nodes the closed form itself.
  void aGridKeepsItsValues() {
    std::string rows;
    std::vector<DirectionPair> pairs;
    for (int v = 0; v <= 80; v += 10)
      for (int l = 0; l <= 80; l += 20)
        for (int phi = 0; phi <= 180; phi += 30) {
          const DirectionPair pair{fromSpherical(radians(l), radians(phi)), fromSpherical(radians(v), 0)};
          pairs.push_back(pair);
          const Rgb value = lobe(pair.wi, pair.wo);
          rows += rowText({radians(v), radians(l), radians(phi), value.x, value.y, value.z}, " ");
        }
    const materials::Material file = materialOfText(rgbFile("ISOTROPIC_TV_TL_DPHI", 3, rows));
    QCOMPARE(file.source.format, std::string("ALTA"));
    QCOMPARE(file.source.grid, (std::vector<int>{5, 7, 9}));
    for (const auto& [wi, wo] : pairs) QVERIFY(glm::length(file.brdf->evaluate(wi, wo) - lobe(wi, wo)) < 1e-6);
  }

  void errorsNameTheLine() {
    const std::string row = "0.5 0.25 1 1 2 3\n";
    VERIFY_REFUSED(materialOfText, rgbFile("ISOTROPIC_TV_TL_DPHI", 3, "0.5 0.25 1 1 2\n"),
                   "line 7: found '0.5 0.25 1 1 2', expected 3 coordinates and 3 values");
    VERIFY_REFUSED(materialOfText, rgbFile("ISOTROPIC_TV_TL_DPHI", 3, "0.5 0.25 x 1 2 3\n"), "line 7: found 'x'");
    VERIFY_REFUSED(materialOfText, rgbFile("STARK_3D", 3, row),
                   "found the PARAM_IN 'STARK_3D', expected one of ISOTROPIC");
    VERIFY_REFUSED(materialOfText, altaFile("CARTESIAN", 6, "ENERGY", 1, row),
                   "found the PARAM_OUT 'ENERGY', expected one of");
    VERIFY_REFUSED(materialOfText, rgbFile("CARTESIAN", 3, row), "found 3 numbers for CARTESIAN, expected 6");
    VERIFY_REFUSED(materialOfText, altaFile("CARTESIAN", 6, "INV_STERADIAN", 2, row), "expected 1 or 3");
    VERIFY_REFUSED(materialOfText, rgbFile("CARTESIAN", 6, "0 0 2 0 0 1 1 2 3\n"), "expected unit vectors");
    VERIFY_REFUSED(materialOfText, "#ALTA HEADER BEGIN\n#DIM 3 x\n#ALTA HEADER END\n" + row,
                   "line 2: found '#DIM 3 x'");
    VERIFY_REFUSED(materialOfText, "#ALTA HEADER BEGIN\n#DIM 3 3\n#ALTA HEADER END\n" + row,
                   "without DIM, PARAM_IN or PARAM_OUT");
    VERIFY_REFUSED(materialOfText, rgbFile("ISOTROPIC_TV_TL_DPHI", 3, ""), "found no point above the horizon");
    VERIFY_REFUSED(materialOfText,
                   std::string("#ALTA HEADER BEGIN\n#DIM 3 3\n#FORMAT binary\n#ALTA HEADER END\n\1\2\0", 63),
                   "binary ALTA files are not read");
  }
};

GONIO_TEST(AltaFileTest)
}  // namespace alta_file_test

#include "alta_file_test.moc"
