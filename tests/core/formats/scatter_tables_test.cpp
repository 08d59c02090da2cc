// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/formats/formats.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace scatter_tables_test {
using namespace gonio;
using namespace gonio::test;
using materials::Material;

/// Isotropic, not reciprocal, other toward the light than away from it.
Rgb isotropic(const Direction& wi, const Direction& wo) {
  const double forward = glm::dot(wo, Direction(-wi.x, -wi.y, wi.z));
  return Rgb(0.2 + 0.5 * wi.z + std::exp(3 * (forward - 1)) + 0.1 * wo.z);
}

/// Of text in a format.
Material readText(const materials::MaterialFormat& format, std::string_view text) {
  Material material;
  format.read(io::MemorySource(std::as_bytes(std::span(text))), {}, material);
  return material;
}
Material zemax(std::string_view text) { return readText(formats::zemaxFormat, text); }
Material lightTools(std::string_view text) { return readText(formats::lightToolsFormat, text); }
std::string textOf(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

std::vector<double> steps(double first, double step, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(first + step * i);
  return angles;
}

const ScatterAngles fine{steps(0, 5, 16), steps(0, 10, 19), steps(0, 3, 31)};
const ScatterAngles fineAboutNormal{steps(0, 5, 16), steps(0, 5, 72), steps(0, 3, 30)};
const ScatterAngles small{{0, 30}, {0, 90, 180}, {0, 10}};
const ScatterAngles smallAboutNormal{{10}, {0, 90, 180, 270}, {0, 60}};

/// The largest difference at directions between nodes.
double maxDifference(const Brdf& brdf) {
  double largest = 0;
  for (const auto& [wi, wo] : scatteredPairs(3000))
    if (brdf.hasData({wi, wo})) largest = std::max(largest, std::abs(brdf.evaluate(wi, wo).y - isotropic(wi, wo).y));
  return largest;
}

class ScatterTablesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void zemaxHoldsTheBrdf() {
    const Bytes bytes = zemaxFile(isotropic, fine);
    const Material file = materials::readMaterial(io::MemorySource(bytes));
    QCOMPARE(file.source.format, std::string(formats::zemaxFormat.name));
    const double difference = maxDifference(*file.brdf);
    QVERIFY2(difference < 0.01, std::to_string(difference).c_str());
    // At nodes: 20 degrees of incidence, 30 about the mirror direction, toward the normal.
    const Direction wi = fromSpherical(radians(20), 1);
    QVERIFY(std::abs(file.brdf->evaluate(wi, fromSpherical(radians(10), 1)).x -
                     isotropic(wi, fromSpherical(radians(10), 1)).x) < 1e-6);
    QCOMPARE(file.source.notes.at(0),
             std::string("read as: angles in degrees; BRDF in 1/sr, monochrome as grey; decimal points"));
    // The closed form reflects more than it receives.
    QVERIFY(file.source.notes.size() == 2 && contains(file.source.notes[1], "warning: the albedo at 0 degrees is "));
  }

  void lightToolsHoldsTheBrdf() {
    const Bytes bytes = lightToolsFile(isotropic, fineAboutNormal);
    const Material file = materials::readMaterial(io::MemorySource(bytes));
    QCOMPARE(file.source.format, std::string(formats::lightToolsFormat.name));
    const double difference = maxDifference(*file.brdf);
    QVERIFY2(difference < 0.02, std::to_string(difference).c_str());
  }

  /// One side of the plane of incidence is the other, whichever the file has.
  void lightToolsSymmetry() {
    for (const double first : {90.0, 270.0}) {
      ScatterAngles half = fineAboutNormal;
      half.azimuths = steps(first, 5, 37);
      const std::string text = textOf(lightToolsFile(isotropic, half));
      const double difference =
          maxDifference(*lightTools(replaced(text, "Symmetry Asymmetric", "Symmetry PlaneSymmetrical")).brdf);
      QVERIFY2(difference < 0.02, std::to_string(difference).c_str());
    }
  }

  /// The white of D65 is grey; Y alone is not.
  void tristimulusValues() {
    std::string text =
        replaced(textOf(zemaxFile(isotropic, small)), "SpectralContent  Monochrome", "SpectralContent XYZ");
    const auto data = text.find("Monochrome\nDataBegin");
    const std::string block = "TIS 1\n%1 %1\n%1 %1\n%1 %1\n";
    const auto channel = [&](const char* name, const char* value) {
      std::string blocks = block + block;
      for (auto at = blocks.find("%1"); at != std::string::npos; at = blocks.find("%1")) blocks.replace(at, 2, value);
      return std::string(name) + "\nDataBegin\n" + blocks + "DataEnd\n";
    };
    text = text.substr(0, data) + channel("TristimulusX", "0.9505") + channel("TristimulusY", "1");
    VERIFY_REFUSED(zemax, text, "found no values of channel 3");
    const Rgb white = zemax(text + channel("TristimulusZ", "1.089")).brdf->evaluate({0, 0, 1}, {0, 0, 1});
    QVERIFY(glm::length(white - Rgb(1)) < 1e-3);
    VERIFY_REFUSED(zemax, text + channel("Monochrome", "1"), "expected TristimulusX");

    std::string blocks = replaced(textOf(lightToolsFile(isotropic, smallAboutNormal)), "Monochrome", "XYZ");
    const auto at = blocks.find("TIS"), end = blocks.find("DataEnd");
    const std::string values = blocks.substr(at, end - at), start = blocks.substr(0, at);
    const Rgb green =
        lightTools(start + "TristimulusValue TrisX\nTIS 0\n" + "0 0 0 0 0 0 0 0\nTristimulusValue TrisY\n" + values +
                   "TristimulusValue TrisZ\nTIS 0\n0 0 0 0 0 0 0 0\nDataEnd\n")
            .brdf->evaluate(fromSpherical(radians(10), 0), {0, 0, 1});
    QVERIFY(green.y > 0.1 && green.x == 0 && green.z == 0);
  }

  /// Sample rotations are azimuths of the light: at the nodes, the closed form itself. 0 and 360 degrees are one.
  void rotationsAreKept() {
    const Reflectance brushed = [](const Direction& wi, const Direction& wo) {
      return isotropic(wi, wo) * (1 + 0.5 * std::pow(wi.x + wo.x, 2) + 0.2 * wi.y);
    };
    const std::vector<double> rotations = steps(0, 45, 9);
    std::string text, blocks;
    for (const double rotation : rotations) {
      // What the instrument sees of a sample that is turned.
      const AzimuthRotation back(-radians(rotation));
      const std::string one = textOf(
          zemaxFile([&](const Direction& wi, const Direction& wo) { return brushed(back(wi), back(wo)); }, fine));
      const auto at = one.find("TIS"), end = one.find("DataEnd");
      if (text.empty()) text = one.substr(0, at);
      blocks += one.substr(at, end - at);
    }
    text = replaced(text, "SampleRotation  1\n0", "SampleRotation 9\n0 45 90 135 180 225 270 315 360");
    text = replaced(text, "Symmetry  PlaneSymmetrical", "Symmetry  Asymmetrical4D") + blocks + "DataEnd\n";
    // Both sides of the plane of incidence differ, so that the rows of 0 to 180 degrees do not suffice.
    const Material half = zemax(replaced(text, "Asymmetrical4D", "PlaneSymmetrical"));
    QVERIFY(!half.brdf->isIsotropic() && contains(half.source.notes.at(0), "8 sample rotations"));
    QCOMPARE(half.source.grid, (std::vector<int>{8, 16, 19, 31}));
    for (const double rotation : rotations)
      for (const double incident : {0.0, 30.0, 60.0})
        for (const double radial : {0.0, 9.0, 27.0}) {
          const double theta = radians(incident);
          const Direction up = fromSpherical(radians(radial), radians(60));
          const Direction wo(std::sin(theta) * up.z - std::cos(theta) * up.x, up.y,
                             std::cos(theta) * up.z + std::sin(theta) * up.x);
          const AzimuthRotation back(-radians(rotation));
          const Direction wi = back(fromSpherical(theta, pi));
          const double difference = std::abs(half.brdf->evaluate(wi, back(wo)).x / brushed(wi, back(wo)).x - 1);
          // At the normal the light has no azimuth.
          if (incident > 0) QVERIFY2(difference < 1e-6, numberText(difference).c_str());
        }
    VERIFY_REFUSED(zemax, replaced(text, "SampleRotation 9\n0", "SampleRotation 8\n"), "expected DataEnd");
  }

  /// The same values in every locale and with every separator.
  void notationsOfNumbers() {
    const auto withCommas = [](std::string text) {
      std::ranges::replace(text, '.', ',');
      return text;
    };
    const std::string mirror = textOf(zemaxFile(isotropic, small)),
                      normal = textOf(lightToolsFile(isotropic, smallAboutNormal));
    const DirectionPair pair{fromSpherical(0.3, 0), fromSpherical(0.4, 3)};
    const auto isSame = [&](const Material& one, const Material& other) {
      return one.brdf->evaluate(pair.wi, pair.wo) == other.brdf->evaluate(pair.wi, pair.wo);
    };
    QVERIFY(isSame(zemax(mirror), zemax(withCommas(mirror))));
    QVERIFY(isSame(lightTools(normal), lightTools(withCommas(normal))));
    QVERIFY(contains(zemax(withCommas(mirror)).source.notes.at(0), "decimal commas"));
    std::string others = withCommas(normal);
    std::ranges::replace(others, ' ', ';');
    QVERIFY(isSame(lightTools(normal), lightTools("\xEF\xBB\xBF" + others)));
    QVERIFY(isSame(zemax(mirror), zemax(replaced(mirror, "TIS 0.5", "TIS 0.5 # total"))));
    VERIFY_REFUSED(zemax, replaced(withCommas(mirror), "TIS 0,5", "TIS 0.5"), "expected one decimal sign");
  }

  /// Beyond the first and last angle of incidence the value at that angle, wherever the viewer is.
  void constantBeyondTheAnglesOfIncidence() {
    const Reflectance constant = [](const Direction&, const Direction&) { return Rgb(0.0625); };
    for (const Material& file :
         {zemax(textOf(zemaxFile(constant, {{10, 50}, {0, 90, 180}, {0, 20, 80}}))),
          zemax(textOf(zemaxFile(constant, {{10, 50}, {90, 180}, {0, 20, 80}}))),
          lightTools(textOf(lightToolsFile(constant, {{10, 50}, {0, 90, 180, 270}, {0, 30, 60}})))})
      for (const double i : {0.0, 1.0, 5.0, 10.0, 30.0, 50.0, 60.0, 80.0, 89.0})
        for (const double o : {0.0, 30.0, 60.0, 81.0, 88.0, 89.9})
          for (const double phi : {0.0, 45.0, 90.0, 135.0, 180.0, 270.0}) {
            const Rgb value =
                file.brdf->evaluate(fromSpherical(radians(i), 0), fromSpherical(radians(o), radians(phi)));
            QVERIFY2(
                value == Rgb(0.0625),
                (numberText(i) + " " + numberText(o) + " " + numberText(phi) + ": " + numberText(value.x)).c_str());
          }
  }

  void transmissionIsRefused() {
    const std::string table = textOf(zemaxFile(isotropic, small));
    VERIFY_REFUSED(zemax, replaced(table, "ScatterType  BRDF", "ScatterType  BTDF"),
                   "found the scatter type 'BTDF'; expected reflection");
    const std::string blocks = textOf(lightToolsFile(isotropic, smallAboutNormal));
    VERIFY_REFUSED(lightTools, replaced(blocks, "ScatterType BRDF", "ScatterType BTDF"),
                   "found 1 blocks with transmission or back-side data only; expected reflection");
    VERIFY_REFUSED(lightTools, replaced(blocks, "Side Front", "Side Back"), "expected reflection");
    const std::string back = "Side Back\nTIS 0\n1 1 1 1 1 1 1 1\nDataEnd";
    QVERIFY(contains(lightTools(replaced(blocks, "DataEnd", back)).source.notes.at(0), "1 blocks"));
    VERIFY_REFUSED(lightTools, replaced(blocks, "DataEnd", "POI 45\nTIS 0\n1 1 1 1 1 1 1 1\nDataEnd"),
                   "several planes of incidence");
  }

  void errorsNameTheLine() {
    const std::string table = textOf(zemaxFile(isotropic, small));
    VERIFY_REFUSED(zemax, replaced(table, "DataEnd", "7\nDataEnd"), "found '7', expected DataEnd");
    VERIFY_REFUSED(zemax, replaced(table, "TIS", "TIX"), "line 17: found 'TIX', expected TIS");
    VERIFY_REFUSED(zemax, replaced(table, "TIS 0.5", "TIS nan"), "line 17: found 'nan'");
    VERIFY_REFUSED(zemax, table.substr(0, table.size() - 30), "expected");
    VERIFY_REFUSED(zemax, replaced(table, "ScatterRadial 2", "ScatterRadial 1e15"), "found '1e15'");
    VERIFY_REFUSED(zemax, replaced(table, "ScatterRadial 2", "ScatterRadial 2.5"), "found '2.5'");
    VERIFY_REFUSED(zemax, replaced(table, "ScatterAzimuth 3", "ScatterBzimuth 3"), "found no ScatterAzimuth");
    VERIFY_REFUSED(zemax, replaced(table, "Symmetry  Plane", "Symmetry  Point"), "found 'PointSymmetrical'");
    VERIFY_REFUSED(zemax, replaced(table, "0\t30", "30\t0"), "the angle of incidence 0.0");
    const std::string blocks = textOf(lightToolsFile(isotropic, smallAboutNormal));
    VERIFY_REFUSED(lightTools, replaced(blocks, "POI", "PIO"), "found 'PIO', expected a key of a block");
    VERIFY_REFUSED(lightTools, replaced(blocks, "Side Front", "Side Up"), "found 'Up', expected Front or Back");
    VERIFY_REFUSED(lightTools, replaced(blocks, "AOI 10", "AOI 100"), "the angle of incidence 100");
    VERIFY_REFUSED(lightTools, replaced(blocks, "DataEnd", ""), "the file ends, expected a block");
    // Two lists whose product no file has.
    VERIFY_REFUSED(zemax,
                   replaced(table, "\nMonochrome\n",
                            "\nScatterRadial 40\n" + std::string(120, '1') + std::string(200, ' ') + "\nMonochrome\n"),
                   "expected");
  }
};

GONIO_TEST(ScatterTablesTest)
}  // namespace scatter_tables_test

#include "scatter_tables_test.moc"
