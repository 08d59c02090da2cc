// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace reflet_file_test {
using namespace gonio;
using namespace gonio::test;

/// Isotropic, other toward the light than away from it, the same on both sides of the plane of incidence.
double lobe(double thetaI, double thetaO, double fromMirrorAzimuth) {
  return 0.05 + 0.1 * std::cos(thetaI) * std::sin(thetaO) * (1 + std::cos(fromMirrorAzimuth)) + 0.02 * std::cos(thetaO);
}

/// A scan of the whole hemisphere: polar angles on both sides, azimuths over half a turn.
std::string refletFile(const std::string& type, bool isIntensity) {
  std::string text;
  for (const double light : {0.0, 20.0, 40.0, 60.0}) {
    text += "Name / Comment :\tclosed form\t \nDate:\t1/1/2026 1:00:00 AM\t\nData file type :\t" + type +
            "\t\nTheta sample :\t0\t\nPhi measure beginning :\t-90\t\nPhi measure end :\t90\t\nPhi measure step "
            ":\t10\t\nTheta Lighting\t" +
            numberText(light) + "\n";
    for (int theta = -80; theta <= 80; theta += 10) {
      text += numberText(double(theta));
      for (int phi = -90; phi <= 90; phi += 10) {
        const double thetaO = radians(std::abs(theta));
        const double value = lobe(radians(light), thetaO, radians(phi + 90 + (theta < 0 ? 180 : 0)));
        text += "\t" + numberText(isIntensity ? value * std::cos(thetaO) : value);
      }
      text += "\n";
    }
    text += "\t\t\n";
  }
  return text;
}

class RefletFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At each direction of the scan; the mirror direction is azimuth -90 of the instrument.
  void valuesAtTheNodes() {
    for (const bool isIntensity : {true, false}) {
      const materials::Material file = materialOfText(refletFile(isIntensity ? "Intensity BRDF" : "BRDF", isIntensity));
      QCOMPARE(file.source.format, std::string("REFLET"));
      QCOMPARE(file.source.description, std::string("closed form"));
      QCOMPARE(file.source.grid, (std::vector<int>{4, 36, 9}));
      QVERIFY(contains(file.source.notes.at(0), "4 measurements of BRDF as grey"));
      QCOMPARE(contains(file.source.notes.at(0), "divided by cos theta"), isIntensity);
      for (const double light : {0.0, 20.0, 40.0, 60.0})
        for (int theta = 10; theta <= 80; theta += 10)
          for (int phi = 0; phi < 360; phi += 10) {
            const Direction wi = fromSpherical(radians(light), 0.3),
                            wo = fromSpherical(radians(theta), 0.3 + pi + radians(phi));
            const double expected = lobe(radians(light), radians(theta), radians(phi));
            QVERIFY(light == 0 || std::abs(file.brdf->evaluate(wi, wo).x - expected) < 1e-6);
          }
      const Direction above(0, 0, 1);
      QVERIFY(std::abs(file.brdf->evaluate(fromSpherical(radians(20), 0), above).x - lobe(radians(20), 0, 0)) < 1e-6);
    }
  }

  /// An instrument that is not calibrated measures less than nothing.
  void negativeValuesAreCounted() {
    std::string text = replaced(refletFile("BRDF", false), "\n-80\t", "\n-80\t-");
    QVERIFY(contains(materialOfText(text).source.notes.at(2), "3 negative values were set to 0"));
    const auto black = materialOfText(
        "Data file type :\tBRDF\nPhi measure beginning :\t-90\nPhi measure end :\t-80\nPhi measure step :\t10\nTheta "
        "Lighting\t60\n-30\t-2\t-3\n30\t-4\t-5\n");
    QVERIFY(contains(black.source.notes.at(1), "warning: no value of the file is above 0"));
  }

  void errorsNameTheLine() {
    const std::string text = refletFile("BRDF", false);
    VERIFY_REFUSED(materialOfText, replaced(text, "type :\tBRDF", "type :\tBTDF"), "expected reflection: BRDF");
    VERIFY_REFUSED(materialOfText, replaced(text, "Theta sample :\t0", "Theta sample :\t5"),
                   "line 8: found 'Theta Lighting");
    VERIFY_REFUSED(materialOfText, replaced(text, "step :\t10", "step :\t11"), "in whole steps");
    VERIFY_REFUSED(materialOfText, replaced(text, "step :\t10", "step :\tten"), "line 7: found 'Phi measure step :");
    VERIFY_REFUSED(materialOfText, replaced(text, "end :\t90", "end :\t80"),
                   "a polar angle and 18 values, one for each azimuth");
    VERIFY_REFUSED(materialOfText, replaced(text, "Theta Lighting\t20", "Theta Lighting\t120"),
                   "an angle of incidence below 90");
    VERIFY_REFUSED(materialOfText, replaced(text, "\n-80\t", "\n-80\tnan\t"),
                   "line 9: found 'nan', expected a finite number");
    VERIFY_REFUSED(materialOfText, text.substr(0, text.find("\n-80")), "found no row of reflected light");
  }
};

GONIO_TEST(RefletFileTest)
}  // namespace reflet_file_test

#include "reflet_file_test.moc"
