// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/math/colour.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace scattered_files_test {
using namespace gonio;
using namespace gonio::test;
using formats::ScatteredSamples;

/// Not symmetric in the directions or channels.
Rgb lobe(const Direction& wi, const Direction& wo) {
  return {0.1 + wi.z * wo.x * wo.x, 0.2 + std::exp(wo.y) * wi.z, 0.3 + wi.x * wi.x};
}

ScatteredSamples astm(std::string_view text) {
  return formats::readAstm(io::MemorySource(std::as_bytes(std::span(text))));
}
ScatteredSamples pgii(std::string_view text) {
  return formats::readGoniophotometer(io::MemorySource(std::as_bytes(std::span(text))));
}
ScatteredSamples curet(std::string_view text) {
  return formats::readCuret(io::MemorySource(std::as_bytes(std::span(text))));
}

constexpr const char* astmStart = "NUM_POINTS 2\nVARS theta_i,phi_i,theta_s,phi_s,";
constexpr const char* pgiiStart = "#format: theta phi BSDF\n#incident_angle 30 180\n";

bool isClose(const Direction& a, const Direction& b) { return glm::length(a - b) < 1e-9; }

class ScatteredFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void astmRoundTripInRadiansAndDegrees() {
    const std::vector<DirectionPair> pairs = scatteredPairs(50);
    for (const double unit : {1.0, radians(1)}) {
      const Bytes bytes = astmFile(lobe, pairs, unit);
      formats::astmFormat.sniff(io::MemorySource(bytes));
      const ScatteredSamples samples = formats::readAstm(io::MemorySource(bytes));
      QCOMPARE(samples.values.size(), pairs.size());
      QCOMPARE(samples.description, std::string("closed form"));
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        QVERIFY(isClose(samples.directions[i].wi, pairs[i].wi) && isClose(samples.directions[i].wo, pairs[i].wo));
        QVERIFY(glm::length(samples.values[i] - lobe(pairs[i].wi, pairs[i].wo)) < 1e-12);
      }
    }
  }

  /// A white of reflectance 1 has the same value in every notation of colours.
  void astmColours() {
    const std::string rows = "0.1,0,0.2,3.1416,";
    for (const auto& [names, values] : {std::pair<std::string, std::string>{"R,G,B", "0.5,0.5,0.5"},
                                        {"400nm,450nm,550nm,600nm,700nm", ".5,.5,.5,.5,.5"},
                                        {"Integrated 400-700", "0.5"}}) {
      const ScatteredSamples samples =
          astm(astmStart + names + "\r\n" + rows + values + "\r\n\r\n" + rows + values + "\r\n");
      QCOMPARE(samples.values.size(), std::size_t(2));
      QVERIFY(glm::length(samples.values[1] - Rgb(0.5)) < 1e-12);
    }
    const ScatteredSamples xyz = astm(std::string(astmStart) + "X,Y,Z\n0,0,0,0,0.475235,0.5,0.544415\n0,0,0,0,0,0,0\n");
    QVERIFY(glm::length(xyz.values[0] - Rgb(0.5)) < 1e-3);
    // Without phi_i the light stands at azimuth 0.
    const ScatteredSamples plane = astm("NUM_POINTS 1\nVARS theta_i,theta_s,phi_s,BRDF\n0.5,0.25,1.5708,2\n");
    QVERIFY(isClose(plane.directions[0].wi, fromSpherical(0.5, 0)) &&
            isClose(plane.directions[0].wo, fromSpherical(0.25, 1.5708)));
  }

  /// The columns of values are known by their names; what may be values twice is refused with the choices.
  void astmColumnsOfValues() {
    const auto read = [](const std::string& names, const std::string& values) {
      return astm("NUM_POINTS 1\nVARS theta_i,theta_s,phi_s," + names + "\n0.1,0.2,3.1416," + values + "\n");
    };
    QCOMPARE(read("wavelength,BRDF", "650,0.5").values[0], Rgb(0.5));
    QCOMPARE(read("BRDF [1/sr],sigma", "0.5,0.1").values[0], Rgb(0.5));
    QCOMPARE(read("650nm", "0.5").values[0], Rgb(0.5));
    const Rgb spectrum = read("450nm,550nm,650nm", "0.1,0.2,0.4").values[0];
    QCOMPARE(read("0.45um,0.55 um,0.65 \u00b5m", "0.1,0.2,0.4").values[0], spectrum);
    QCOMPARE(
        astm("NUM_POINTS 1\nVARS theta_i;theta_s;phi_s;0,45um;0,55um;0,65um\n0,1;0,2;3,1416;0,1;0,2;0,4\n").values[0],
        spectrum);
    QVERIFY(spectrum.x > 0.3 && spectrum.z < 0.2);
    QVERIFY(contains(read("wavelength,BRDF", "650,0.5").notes.at(1), "not used: 'wavelength'"));
    for (const auto& [names, values] : {std::pair<std::string, std::string>{"650nm,532nm", "0.5,0.6"},
                                        {"p,q", "1,2"},
                                        {"wavelength", "650"},
                                        {"BRDF*cos", "0.5"},
                                        {"X,Y", "1,2"}}) {
      const std::string error = errorOf([&, names = names, values = values] { read(names, values); });
      QVERIFY2(contains(error, "line 2: found the columns") && contains(error, "or one column named BRDF"),
               error.c_str());
    }
    QVERIFY(contains(errorOf([&] { read("BRDF,BSDF", "1,2"); }), "expected only one of them"));
    QVERIFY(contains(errorOf([&] { read("theta_r,BRDF", "0.1,2"); }), "'theta_s', 'theta_r', expected only one"));
    QVERIFY(contains(errorOf([&] { read("905nm,1064nm,1550nm", "1,1,1"); }), "expected some that are visible"));
    VERIFY_REFUSED(astm, "NUM_POINTS 2\nVARS theta_i,theta_s,phi_s,wavelength,BRDF\n0,0,0,450,1\n0,0,0,650,2\n",
                   "line 4: found 650 for wavelength after 450");
  }

  /// Radians only where they can be and look like it; the file may state the unit. Small angles can be either.
  void unitsOfAngles() {
    const auto thetaOf = [](const std::string& names, const std::string& row) {
      return astm("NUM_POINTS 1\nVARS " + names + ",BRDF\n" + row + ",1\n");
    };
    const std::string names = "theta_i,phi_i,theta_s,phi_s";
    QVERIFY(isClose(thetaOf(names, "0.5,0,0.4,3.1416").directions.at(0).wi, fromSpherical(0.5, 0)));
    QVERIFY(isClose(thetaOf(names, "0,0,0,0").directions.at(0).wi, fromSpherical(0, 0)));
    for (const char* row : {"0.5,0,0.4,3", "0.1,0,0.309,0", "0.5,0,1.309,0"})
      VERIFY_REFUSED(astm, "NUM_POINTS 1\nVARS " + names + ",BRDF\n" + row + ",1\n", "may be degrees or radians");
    QVERIFY(isClose(thetaOf(names, "5,0,4,180").directions.at(0).wi, fromSpherical(radians(5), 0)));
    QVERIFY(isClose(thetaOf(names, "5,0,4,0").directions.at(0).wi, fromSpherical(radians(5), 0)));
    QVERIFY(isClose(thetaOf(names, "2,0,1,0").directions.at(0).wi, fromSpherical(radians(2), 0)));
    QVERIFY(isClose(thetaOf("theta_i [deg],phi_i,theta_s,phi_s", "1,0,1,0").directions.at(0).wi,
                    fromSpherical(radians(1), 0)));
    QVERIFY(isClose(thetaOf("theta_i (rad),phi_i (rad),theta_s,phi_s", "1,0,1,7").directions.at(0).wi,
                    fromSpherical(1, 0)));
    QVERIFY(contains(thetaOf(names, "2,0,1,0").notes.at(0), "angles in degrees (the file states no unit)"));
    VERIFY_REFUSED(astm, "NUM_POINTS 2\nVARS theta_i,theta_s,phi_s,R,G,B\n0,2,3.14159,1,1,1\n0,0,0,1,1,1\n",
                   "expected angles in a known unit: name a column 'theta_i [deg]'");
    VERIFY_REFUSED(astm, "NUM_POINTS 1\nVARS theta_i [deg],theta_s [rad],phi_s,R,G,B\n0,2,3,1,1,1\n", "in two units");
    VERIFY_REFUSED(astm, "NUM_POINTS 1\nVARS theta_i [gon],theta_s,phi_s,R,G,B\n0,2,3,1,1,1\n", "[deg] or [rad]");
  }

  /// The same table from every program and locale.
  void notationsOfTables() {
    const ScatteredSamples expected =
        astm("NUM_POINTS 2\nVARS theta_i,theta_s,phi_s,BRDF\n10.5,0,0,0.25\n20,30.5,180,1\n");
    for (const char* text :
         {"\xEF\xBB\xBFNUM_POINTS;2;;;\r\nVARS;theta_i;theta_s;phi_s;BRDF\r\n10,5;0;0;0,25\r\n20;30,5;180;1\r\n",
          "NUM_POINTS 2\nVARS theta_i,theta_s,phi_s,BRDF\n10,5 0 0 0,25\n20 30,5 180 1\n",
          "NUM_POINTS\t2\nVARS\ttheta_i\ttheta_s\tphi_s\tBRDF\n# a comment\n10.5\t0\t0\t0.25\n20\t30.5\t180\t1\n",
          "NUM_POINTS 2\rVARS theta_i theta_s phi_s BRDF\r10.5 0 0  0.25\r20 30.5 180 1\r"}) {
      const ScatteredSamples samples = astm(text);
      QCOMPARE(samples.values, expected.values);
      for (std::size_t i = 0; i < 2; ++i) QVERIFY(isClose(samples.directions[i].wo, expected.directions[i].wo));
    }
    VERIFY_REFUSED(astm, "NUM_POINTS 1\nVARS theta_i,theta_s,phi_s,BRDF\n10,5,0,0,0,25\n",
                   "if commas are decimal signs");
    VERIFY_REFUSED(astm, "NUM_POINTS 2\nVARS theta_i;theta_s;phi_s;BRDF\n10.5;0;0;1,234\n1;2;3;4\n",
                   "expected one decimal sign");
    const ScatteredSamples pgiiExpected =
        pgii("#format: theta phi BSDF\n#incident_angle 30.5 180\n20 60.5 0.25\n0 0 1\n");
    for (const char* rows : {"20 60,5 0,25\n0 0 1\n", "20;60,5;0,25\n0;0;1\n", "20\t60.5\t0.25\n0\t0\t1 # last\n",
                             "20,60.5,0.25\n0,0,1\n", "20, 60.5, 0.25\n0, 0, 1\n"})
      for (const char* angle : {"30,5 180", "30.5 180", "30.5, 180", "30,5\t180"}) {
        const ScatteredSamples samples =
            pgii(std::string("#format: theta phi BSDF\n#incident_angle ") + angle + "\n" + rows);
        QCOMPARE(samples.values, pgiiExpected.values);
        QVERIFY(isClose(samples.directions[0].wi, pgiiExpected.directions[0].wi));
        QVERIFY(isClose(samples.directions[0].wo, pgiiExpected.directions[0].wo));
      }
    // Three numbers or five.
    for (const char* rows : {"20,60,0,0,063662\n", "20,0 60,0 0.06\n", "0, 0, 0,5\n"})
      VERIFY_REFUSED(pgii, pgiiStart + std::string(rows), "expected one");
    VERIFY_REFUSED(pgii, "#colorimetry: CIE-Lab\n" + std::string(pgiiStart) + "0 0 50 1 2\n",
                   "expected CIE-XYZ or RGB");
    QVERIFY(contains(pgii(pgiiStart + std::string("20 60,5 0,25\n")).notes.at(0), "bsdf as grey; decimal commas"));
    VERIFY_REFUSED(pgii, std::string("\xFF\xFE#\0f\0", 6), "does not begin with #");
    const std::string utf16 =
        errorOf([] { formats::goniophotometerFormat.sniff(io::MemorySource(bytesOf(std::string("\xFF\xFE#\0", 4)))); });
    QVERIFY2(contains(utf16, "text in UTF-16"), utf16.c_str());
  }

  void negativeValuesAndRowsBelowTheHorizonAreCounted() {
    const ScatteredSamples samples = astm(
        "NUM_POINTS 4\nVARS theta_i [rad],phi_i,theta_s,phi_s,R,G,B\n0.1,0,0.2,0,-1,2,-0.001\n0.1,0,1.6,0,1,1,1\n"
        "1.5708,0,0.1,0,1,1,1\n0.1,0,0.1,0,0,0,0\n");
    QCOMPARE(samples.values.size(), std::size_t(2));
    QVERIFY(samples.values[0] == Rgb(0, 2, 0));
    QCOMPARE(samples.clampedCount, std::size_t(2));
    QCOMPARE(samples.belowHorizonCount, std::size_t(2));
  }

  void astmErrorsNameTheLine() {
    const std::string start = astmStart, good = "0,0,0,0,1,1,1\n";
    VERIFY_REFUSED(astm, "hello\nNUM_POINTS 2\n", "expected lines NUM_POINTS and VARS");
    VERIFY_REFUSED(astm, start + "R,G,B\n" + good, "line 1: found 'NUM_POINTS 2', expected NUM_POINTS 1");
    VERIFY_REFUSED(astm, start + "R,G,B\n" + good + "0,0,0,0,1,inf,1\n", "line 4: found 'inf' for g");
    VERIFY_REFUSED(astm, start + "R,G,B\n" + good + "0,0,0,0,1,1\n", "line 4: found 6 columns, expected 7");
    VERIFY_REFUSED(astm, start + "R,G\n0,0,0,0,1,1\n0,0,0,0,1,1\n", "expected one named b");
    VERIFY_REFUSED(astm, "NUM_POINTS 1\nVARS theta_i,phi_i,phi_s,R,G,B\n0,0,0,1,1,1\n", "expected one named theta_s");
    VERIFY_REFUSED(astm, "NUM_POINTS 1\nVARS theta_i,phi_i,theta_s,phi_s\n0,0,0,0\n", "found no column of values");
    VERIFY_REFUSED(astm, "NUM_POINTS 1e300\nVARS theta_i,theta_s,phi_s,R\n", "NUM_POINTS and a whole number");
  }

  void goniophotometerRoundTrip() {
    const Direction light = fromSpherical(radians(30), radians(170));
    std::vector<Direction> viewers;
    for (const DirectionPair& pair : scatteredPairs(40)) viewers.push_back(pair.wo);
    const Bytes bytes = goniophotometerFile(lobe, light, viewers);
    formats::goniophotometerFormat.sniff(io::MemorySource(bytes));
    const ScatteredSamples samples = formats::readGoniophotometer(io::MemorySource(bytes));
    QCOMPARE(samples.values.size(), viewers.size());
    QCOMPARE(samples.description, std::string("closed form"));
    for (std::size_t i = 0; i < viewers.size(); ++i) {
      QVERIFY(isClose(samples.directions[i].wi, light) && isClose(samples.directions[i].wo, viewers[i]));
      QVERIFY(glm::length(samples.values[i] - Rgb(lobe(light, viewers[i]).y)) < 1e-12);
    }
  }

  /// DSF holds the cosine; a light from below turns the sample over; rows on the other side are transmission.
  void goniophotometerQuantitiesAndSides() {
    const ScatteredSamples dsf =
        pgii("# format: theta phi DSF\n#intheta: 30\n# inphi 180\n60 0 0.5\n0 0 0.5\n120 0 9\n");
    QCOMPARE(dsf.values.size(), std::size_t(2));
    QCOMPARE(dsf.belowHorizonCount, std::size_t(1));
    QVERIFY(glm::length(dsf.values[0] - Rgb(1)) < 1e-12 && glm::length(dsf.values[1] - Rgb(0.5)) < 1e-12);
    const ScatteredSamples below = pgii("#format: theta phi BRDF\n#incident_angle 150 20\n170 40 0.5\n10 40 7\n");
    QCOMPARE(below.values.size(), std::size_t(1));
    QVERIFY(isClose(below.directions[0].wi, fromSpherical(radians(30), radians(20))) &&
            isClose(below.directions[0].wo, fromSpherical(radians(10), radians(40))));
    const ScatteredSamples xyz = pgii("#colorimetry: CIE-XYZ\n" + std::string(pgiiStart) + "0 0 0.9505 1 1.089\n");
    QVERIFY(glm::length(xyz.values[0] - Rgb(1)) < 1e-3);
    QVERIFY(pgii(std::string(pgiiStart) + "0 0 1 2 3\n").values[0] == Rgb(1, 2, 3));
  }

  void goniophotometerErrorsNameTheLine() {
    const std::string start = pgiiStart;
    VERIFY_REFUSED(pgii, "10 0 1\n", "does not begin with #");
    VERIFY_REFUSED(pgii, "# a comment\n10 0 1\n", "without the quantity or the incident direction");
    VERIFY_REFUSED(pgii, "#format: theta phi BSDF\n#intheta x\n", "'intheta' without an angle in line 2");
    VERIFY_REFUSED(pgii, "#format: theta phi BTDF\n#incident_angle 0 0\n10 0 1\n", "expected reflection");
    VERIFY_REFUSED(pgii, start, "found no row of reflected light");
    VERIFY_REFUSED(pgii, start + "110 0 1\n", "found no row of reflected light");
    VERIFY_REFUSED(pgii, start + "10 0 1\n10 0 nan\n", "line 4: found 'nan', expected a finite number");
    VERIFY_REFUSED(pgii, start + "10 0 1\n10 0 1 1 1\n", "line 4");
    VERIFY_REFUSED(pgii, start + "10 0\n", "line 3");
    VERIFY_REFUSED(pgii, "#format: theta phi DSF\n#incident_angle 0 0\n89.9999 0 1e308\n", "a finite BRDF");
    VERIFY_REFUSED(pgii, "#format: theta phi BSDF\n#incident_angle 90 0\n10 0 1\n",
                   "not at 90 degrees from the normal");
  }

  void curetRoundTrip() {
    const std::vector<DirectionPair> pairs = scatteredPairs(205);
    const Bytes bytes = curetFile(lobe, pairs);
    formats::curetFormat.sniff(io::MemorySource(bytes));
    const ScatteredSamples samples = formats::readCuret(io::MemorySource(bytes));
    QCOMPARE(samples.values.size(), std::size_t(205));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      QVERIFY(isClose(samples.directions[i].wi, pairs[i].wo) && isClose(samples.directions[i].wo, pairs[i].wi));
      QVERIFY(glm::length(samples.values[i] - lobe(pairs[i].wi, pairs[i].wo)) < 1e-12);
    }
  }

  void curetFilesOfAnotherKindAreRefused() {
    std::string rows, channel = "1";
    for (int i = 0; i < 205; ++i) {
      rows += "10 90 20 180 0.5\n";
      channel += " 0.5";
    }
    const ScatteredSamples grey = curet(rows);
    QVERIFY(grey.values[3] == Rgb(0.5) && isClose(grey.directions[3].wi, fromSpherical(radians(10), radians(90))));
    std::string commas = rows;
    std::ranges::replace(commas, '.', ',');
    QVERIFY(curet(commas).values == grey.values && contains(curet(commas).notes.at(0), "decimal commas"));
    VERIFY_REFUSED(curet, channel + "\n", "a CUReT file with one channel");
    VERIFY_REFUSED(curet, rows + "10 90 20 180 0.5\n", "found 206 rows");
    VERIFY_REFUSED(curet, "10 90 20 180 0.5 1\n" + rows, "line 1");
    VERIFY_REFUSED(curet, rows + "10 90 20 180 nan\n", "line 206");
    VERIFY_REFUSED(curet, "", "an empty file");
    VERIFY_REFUSED(curet, std::string("\x01\x02", 2), "bytes that are not text");
  }
};

GONIO_TEST(ScatteredFilesTest)
}  // namespace scattered_files_test

#include "scattered_files_test.moc"
