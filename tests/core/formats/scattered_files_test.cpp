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
template <typename Reader>
std::string refusal(Reader reader, const std::string& text) {
  return errorOf([&] { reader(text); });
}

#define VERIFY_REFUSED(reader, text, part) \
  QVERIFY2(contains(refusal(reader, text), part), refusal(reader, text).c_str())

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
    const std::string rows = "0.1,0,0.2,3,";
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
    const ScatteredSamples plane = astm("NUM_POINTS 1\nVARS theta_i,theta_s,phi_s,BRDF\n0.5,0.25,1,2\n");
    QVERIFY(isClose(plane.directions[0].wi, fromSpherical(0.5, 0)) &&
            isClose(plane.directions[0].wo, fromSpherical(0.25, 1)));
  }

  void negativeValuesAndRowsBelowTheHorizonAreCounted() {
    const ScatteredSamples samples = astm(
        "NUM_POINTS 4\nVARS theta_i,phi_i,theta_s,phi_s,R,G,B\n0.1,0,0.2,0,-1,2,-0.001\n0.1,0,1.6,0,1,1,1\n"
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
