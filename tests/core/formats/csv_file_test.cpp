// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/export/export_target.h"
#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace csv_file_test {
using namespace gonio;
using namespace gonio::test;
using formats::ScatteredSamples;

/// Isotropic, not reciprocal, other toward the light than away from it; small enough to conserve energy.
Rgb lobe(const Direction& wi, const Direction& wo) {
  const double forward = glm::dot(wo, Direction(-wi.x, -wi.y, wi.z));
  return Rgb(0.1, 0.05, 0.02) + Rgb(0.05 * wi.z, 0.1 * std::exp(3 * (forward - 1)), 0.02 * wo.z);
}
/// The same, brushed along x.
Rgb brushed(const Direction& wi, const Direction& wo) {
  return lobe(wi, wo) * (1 + 0.5 * (wi.x + wo.x) * (wi.x + wo.x));
}

ScatteredSamples read(const std::string& text) { return formats::readCsvPoints(io::MemorySource(bytesOf(text))); }
bool isClose(const Direction& a, const Direction& b) { return glm::length(a - b) < 1e-9; }

/// What the export target writes, and the text of it.
std::string exported(const FunctionBrdf& brdf) {
  const auto source = materials::unedited("closed form", std::make_shared<const FunctionBrdf>(brdf));
  const auto made = exports::makeExport(*exports::findExportTarget("csv"), source);
  const Bytes& bytes = made.parts.at(0).bytes;
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class CsvFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void columnsByName() {
    const Direction wi = fromSpherical(radians(10), radians(20)), wo = fromSpherical(radians(30), radians(140));
    for (const char* text :
         {"theta_i,phi_i,theta_o,phi_o,r,g,b\n10,20,30,140,1,2,3\n",
          "b;g;r;phi_r;theta_r;phi_i;theta_i\n3;2;1;140;30;20;10\n",
          "Theta_in (deg)\tPhi_in\tTheta_out\tPhi_out\tRed\tGreen\tBlue\n10\t20\t30\t140\t1\t2\t3\n",
          // A degree sign in Windows-1252, as spreadsheets write it.
          "Theta_i [\xb0];Phi_i [\xb0];Theta_o [\xb0];Phi_o [\xb0];R;G;B\r\n10,0;20,0;30,0;140,0;1;2;3\r\n",
          "# made by hand\ntheta_i;phi_i;theta_o;dphi;r;g;b\n10,0;20;30;120;1;2;3\n",
          "theta_i [rad],phi_i,theta_s,delta_phi,r,g,b\n0.17453292519943295,0.3490658503988659,"
          "0.5235987755982988,2.0943951023931953,1,2,3\n"}) {
      const ScatteredSamples samples = read(text);
      QCOMPARE(samples.values.size(), std::size_t(1));
      QVERIFY2(isClose(samples.directions[0].wi, wi) && isClose(samples.directions[0].wo, wo), text);
      QVERIFY2(samples.values[0] == Rgb(1, 2, 3), text);
    }
    QVERIFY(read("theta_i,theta_o,dphi,BRDF\n10,20,3,0.5\n").values[0] == Rgb(0.5));
    const Rgb spectrum = read("theta_i,theta_o,dphi,450nm,550nm,650nm\n10,20,3,0.1,0.2,0.4\n").values[0];
    QVERIFY(spectrum.x > 0.3 && spectrum.z < 0.2);
  }

  /// Degrees, unless all angles are so small that they may be radians.
  void unitsOfAngles() {
    const ScatteredSamples one = read("theta_i,theta_o,dphi,BRDF\n1,0.5,7,0.5\n");
    QVERIFY(isClose(one.directions[0].wi, fromSpherical(radians(1), 0)));
    QVERIFY(contains(one.notes.at(0), "angles in degrees (the file states no unit)"));
    const ScatteredSamples stated = read("theta_i [deg],theta_o,dphi,BRDF\n1,0.5,1.2,0.5\n");
    QVERIFY(isClose(stated.directions[0].wi, fromSpherical(radians(1), 0)));
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,dphi,BRDF\n1,0.5,1.2,0.5\n", "may be degrees or radians");
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,dphi,BRDF\n0.5,0.7,3.14159,0.5\n", "which looks like radians");
  }

  /// A grid is evaluated as a table: at its nodes the closed form itself, and between them near it.
  void aGridKeepsItsValues() {
    std::string text = "theta_i;phi_i;theta_o;phi_o;r;g;b\n";
    std::vector<DirectionPair> pairs;
    for (int i = 0; i <= 80; i += 10)
      for (int o = 0; o <= 85; o += 5)
        for (int phi = 0; phi < 360; phi += 15) {
          const DirectionPair pair{fromSpherical(radians(i), radians(40)),
                                   fromSpherical(radians(o), radians(40 + phi))};
          pairs.push_back(pair);
          const Rgb value = lobe(pair.wi, pair.wo);
          text += rowText({double(i), 40, double(o), double(40 + phi), value.x, value.y, value.z}, ";");
        }
    std::ranges::replace(text, '.', ',');
    const materials::Material file = materialOfText(text);
    QCOMPARE(file.source.format, std::string("CSV"));
    QCOMPARE(file.source.grid, (std::vector<int>{9, 24, 18}));
    QVERIFY(contains(file.source.notes.at(0), "separated by semicolons, decimal commas"));
    QVERIFY(file.brdf->isIsotropic() && !file.brdf->isReciprocal());
    for (const auto& [wi, wo] : pairs) QVERIFY(glm::length(file.brdf->evaluate(wi, wo) - lobe(wi, wo)) < 1e-6);
    for (const auto& [wi, wo] : scatteredPairs(1000))
      QVERIFY(glm::length(file.brdf->evaluate(wi, wo) - lobe(wi, wo)) < 0.01);
  }

  /// The export target's own file, isotropic and anisotropic: six digits at each of its directions.
  void theExportIsReadBack() {
    for (const bool isotropic : {true, false}) {
      const std::string text = exported(FunctionBrdf(isotropic ? lobe : brushed, isotropic, false));
      const ScatteredSamples samples = read(text);
      const materials::Material file = materialOfText(text);
      QCOMPARE(file.brdf->isIsotropic(), isotropic);
      QCOMPARE(file.source.grid, isotropic ? (std::vector<int>{6, 13, 18}) : (std::vector<int>{12, 6, 24, 18}));
      for (std::size_t i = 0; i < samples.values.size(); ++i) {
        const auto& [wi, wo] = samples.directions[i];
        const Rgb expected = isotropic ? lobe(wi, wo) : brushed(wi, wo), value = file.brdf->evaluate(wi, wo);
        QVERIFY2(glm::length(value - expected) < 1e-6 * (1 + glm::length(expected)),
                 (numberText(value.x) + " " + numberText(expected.x)).c_str());
      }
    }
  }

  /// A grid with a gap, with steps too wide, or that lacks a point is reconstructed.
  void otherPointsAreReconstructed() {
    const auto rows = [](int stepI, int stepPhi, int left) {
      std::string text = "theta_i,theta_o,dphi,BRDF\n";
      int count = 0;
      for (int i = 10; i <= 70; i += stepI)
        for (int o = 10; o <= 70; o += 20)
          for (int phi = 0; phi <= 180; phi += stepPhi)
            if (count++ != left) text += rowText({double(i), double(o), double(phi), 0.1}, ",");
      return formats::gridOf(read(text)).has_value();
    };
    QVERIFY(rows(20, 30, -1));
    QVERIFY(!rows(20, 30, 17) && !rows(60, 30, -1) && !rows(20, 90, -1));
    const materials::Material file = materialOfText("theta_i,theta_o,dphi,BRDF\n10,20,30,0.1\n40,20,180,0.1\n");
    QVERIFY(file.table && contains(file.source.notes.at(1), "2 samples at 2 grid nodes"));
  }

  void errorsSayWhatToChange() {
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,dphi,BRDF\n1,2,x,0.5\n",
                   "line 2: found 'x' for dphi, expected a finite number");
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,dphi,BRDF\n1,2,3\n", "line 2: found 3 columns, expected 4");
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,BRDF\n1,2,3\n", "expected one named phi_s (or phi_o, phi_r, dphi)");
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,phi_o,dphi,BRDF\n1,2,3,4,5\n",
                   "'phi_o', 'dphi', expected only one of them");
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,dphi,p,q\n1,2,3,4,5\n", "or one column named BRDF");
    VERIFY_REFUSED(materialOfText, "theta_i,theta_o,dphi,BRDF\n", "found no row after the names");
    // A plan has the same angles, a table of something else other names.
    VERIFY_REFUSED(materialOfText, "index,theta_i,phi_i,theta_o,phi_o,order\n1,2,3,4,5,1\n",
                   "a plan or readings of an acquisition");
    const std::string table = refusal(materialOfText, "Incidence;Azimuth;Value\n10,5;20;0,3\n");
    QVERIFY2(
        table.starts_with("found a table with the columns incidence, azimuth, value, expected a line of names with "
                          "theta_i, phi_i, theta_o, phi_o (or dphi) and values (CSV)"),
        table.c_str());
    VERIFY_REFUSED(materialOfText, "these are words, only words\n", "matches no format that Gonio supports");
  }
};

GONIO_TEST(CsvFileTest)
}  // namespace csv_file_test

#include "csv_file_test.moc"
