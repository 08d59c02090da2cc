// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/formats/formats.h"
#include "tests/core/formats/instrument_files.h"
#include "tests/support/test_program.h"

namespace radiance_file_test {
using namespace gonio;
using namespace gonio::test;

/// The centres of the patches, in their order, as the documentation of WINDOW tabulates them: polar angles of the
/// boundaries and numbers of azimuths.
std::vector<Direction> patchCentres(const std::string& basis) {
  const std::vector<double> ends =
      basis == "LBNL/Klems Full"   ? std::vector<double>{0, 5, 15, 25, 35, 45, 55, 65, 75, 90}
      : basis == "LBNL/Klems Half" ? std::vector<double>{0, 6.5, 19.5, 32.5, 46.5, 61.5, 76.5, 90}
                                   : std::vector<double>{0, 9, 27, 46, 66, 90};
  const std::vector<int> counts = basis == "LBNL/Klems Full"   ? std::vector<int>{1, 8, 16, 20, 24, 24, 24, 16, 12}
                                  : basis == "LBNL/Klems Half" ? std::vector<int>{1, 8, 12, 16, 20, 12, 4}
                                                               : std::vector<int>{1, 8, 12, 12, 8};
  std::vector<Direction> centres;
  for (std::size_t band = 0; band < counts.size(); ++band)
    for (int i = 0; i < counts[band]; ++i) {
      const double theta = band == 0 ? 0 : radians((ends[band] + ends[band + 1]) / 2), phi = 2 * pi * i / counts[band];
      centres.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  return centres;
}

/// Anisotropic, not reciprocal.
double lobe(const Direction& wi, const Direction& wo) {
  return 0.1 + 0.05 * wi.z + 0.03 * wo.z * wo.z + 0.05 * (wi.x + wo.x) * (wi.x + wo.x) + 0.02 * wo.y * wi.x;
}

std::string block(const std::string& direction, const std::string& basis, const std::string& values) {
  return "<WavelengthDataBlock><WavelengthDataDirection>" + direction +
         "</WavelengthDataDirection>\n<ColumnAngleBasis>" + basis + "</ColumnAngleBasis><RowAngleBasis>" + basis +
         "</RowAngleBasis>\n<ScatteringDataType>BRDF</ScatteringDataType><ScatteringData>\n" + values +
         "</ScatteringData></WavelengthDataBlock>";
}
std::string wavelength(const std::string& name, const std::string& blocks) {
  return "<WavelengthData>\n<LayerNumber>System</LayerNumber><Wavelength unit=\"Integral\"> " + name +
         " </Wavelength>\n" + blocks + "</WavelengthData>\n";
}
std::string file(const std::string& structure, const std::string& data) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<WindowElement "
         "xmlns=\"http://windows.lbl.gov\">\n<Optical><Layer>\n"
         "<Material><Name>closed form</Name></Material>\n<DataDefinition><IncidentDataStructure>" +
         structure + "</IncidentDataStructure></DataDefinition>\n" + data + "</Layer></Optical></WindowElement>\n";
}
/// The closed form at the centres; a row per outgoing patch, or per incident one. Light arrives from opposite to the
/// azimuth of its patch.
std::string values(const std::string& basis, bool isIncidentRows, double scale = 1) {
  const std::vector<Direction> centres = patchCentres(basis);
  std::string text;
  for (const Direction& row : centres) {
    for (const Direction& column : centres) {
      const Direction &incident = isIncidentRows ? row : column, &outgoing = isIncidentRows ? column : row;
      text += numberText(scale * lobe({-incident.x, -incident.y, incident.z}, outgoing)) + ",\t";
    }
    text += "\n";
  }
  return text;
}
std::string constant(const std::string& value) {
  std::string text;
  for (int i = 0; i < 41 * 41; ++i) text += value + " ";
  return text;
}

/// Cells of a tree: centre and value.
struct Cell {
  std::vector<double> centre;
  double value;
};

/// A node over the box at `corner` with sides `side`: branches of so many levels below it, or else a grid of so many
/// cells per side. Each value is one more than the last.
std::string nodeText(const std::vector<double>& corner, double side, int levels, std::size_t perSide,
                     std::vector<Cell>& cells) {
  const std::size_t rank = corner.size();
  std::string text = "{ ";
  if (levels > 0) {
    for (std::size_t child = 0; child < std::size_t(1) << rank; ++child) {
      std::vector<double> at = corner;
      for (std::size_t i = 0; i < rank; ++i) at[i] += (child >> i & 1) != 0 ? side / 2 : 0;
      constexpr std::size_t sizes[] = {4, 2, 1};
      text += nodeText(at, side / 2, child == 6 ? levels - 1 : 0, sizes[child % 3], cells);
    }
    return text + "}\n";
  }
  std::size_t total = 1;
  for (std::size_t i = 0; i < rank; ++i) total *= perSide;
  for (std::size_t cell = 0; cell < total; ++cell) {
    std::vector<double> centre = corner;
    std::size_t rest = cell;
    for (std::size_t i = rank; i-- > 0; rest /= perSide)
      centre[i] += side * (double(rest % perSide) + 0.5) / double(perSide);
    cells.push_back({centre, double(cells.size() + 1)});
    text += numberText(cells.back().value) + (cell % 2 == 0 ? " " : ", ");
  }
  return text + "}";
}

/// The point of the unit disk of a point of the unit square, by the map of Shirley and Chiu.
glm::dvec2 onDisk(double u, double v) {
  const double a = 2 * u - 1, b = 2 * v - 1;
  if (a == 0 && b == 0) return {0, 0};
  const double radius = std::abs(a) > std::abs(b) ? a : b;
  const double phi = std::abs(a) > std::abs(b) ? pi / 4 * b / a : pi / 2 - pi / 4 * a / b;
  return radius * glm::dvec2(std::cos(phi), std::sin(phi));
}
Direction upward(const glm::dvec2& at) { return {at.x, at.y, std::sqrt(1 - glm::dot(at, at))}; }

std::string treeFile(std::size_t rank, const std::string& tree, const std::string& basis = "LBNL/Shirley-Chiu") {
  return file(
      "TensorTree" + std::to_string(rank),
      wavelength("Visible",
                 "<WavelengthDataBlock><WavelengthDataDirection>Reflection Front"
                 "</WavelengthDataDirection><AngleBasis>" +
                     basis + "</AngleBasis><ScatteringData>" + tree + "</ScatteringData></WavelengthDataBlock>"));
}

constexpr const char* quarter = "LBNL/Klems Quarter";

class RadianceFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At the centre of each pair of patches and about it.
  void valuesAtThePatches() {
    for (const std::string basis : {"LBNL/Klems Full", "LBNL/Klems Half", "LBNL/Klems Quarter"})
      for (const bool isIncidentRows : {false, true}) {
        const materials::Material read = materialOfText(
            file(isIncidentRows ? "Rows" : "Columns",
                 wavelength("Visible", block("Reflection Front", basis, values(basis, isIncidentRows)))));
        QCOMPARE(read.source.format, std::string("Radiance"));
        QCOMPARE(read.source.description, std::string("closed form"));
        const std::vector<Direction> centres = patchCentres(basis);
        QCOMPARE(read.source.grid, (std::vector<int>{int(centres.size()), int(centres.size())}));
        QVERIFY(!read.brdf->isIsotropic() && !read.brdf->isReciprocal());
        for (const Direction& wi : centres)
          for (const Direction& wo : centres) {
            QVERIFY(std::abs(read.brdf->evaluate(wi, wo).x - lobe(wi, wo)) < 1e-6);
            const Direction beside = glm::normalize(wo + Direction(0.02, -0.02, 0));
            QVERIFY(wo.z < 0.3 || read.brdf->evaluate(wi, beside) == read.brdf->evaluate(wi, wo));
          }
        QVERIFY(read.brdf->evaluate({0, 0, 1}, {0, 0.6, -0.8}) == Rgb(0));
      }
  }

  /// At the centre of each cell.
  void tensorTrees() {
    for (const std::size_t rank : {std::size_t(3), std::size_t(4)}) {
      std::vector<Cell> cells;
      const std::string tree = nodeText(std::vector<double>(rank, 0.0), 1, 3, 1, cells);
      const materials::Material read = materialOfText(treeFile(rank, tree));
      QCOMPARE(read.source.grid, std::vector<int>{int(cells.size())});
      QCOMPARE(read.brdf->isIsotropic(), rank == 3);
      std::size_t checked = 0;
      for (const Cell& cell : cells) {
        Direction wi, wo;
        if (rank == 3) {
          // The light travels along x, so that it stands at azimuth 180 degrees; all is turned by one radian.
          const double sine = 1 - 2 * cell.centre[0];
          if (sine < 0) continue;
          wi = fromSpherical(std::asin(sine), pi + 1);
          const Direction outgoing = upward(onDisk(cell.centre[1], cell.centre[2]));
          wo = {std::cos(1.0) * outgoing.x - std::sin(1.0) * outgoing.y,
                std::sin(1.0) * outgoing.x + std::cos(1.0) * outgoing.y, outgoing.z};
        } else {
          const glm::dvec2 travelling = onDisk(cell.centre[0], cell.centre[1]);
          wi = upward(-travelling);
          wo = upward(onDisk(cell.centre[2], cell.centre[3]));
        }
        ++checked;
        const double value = read.brdf->evaluate(wi, wo).x;
        QVERIFY2(std::abs(value - cell.value) < 1e-6 * cell.value,
                 (numberText(value) + " " + numberText(cell.value)).c_str());
      }
      QVERIFY(checked > 200);
    }
    VERIFY_REFUSED(materialOfText, treeFile(3, "{ 1 2 3 }"), "expected 1, 8, 64, .. values before it, not 3");
    VERIFY_REFUSED(materialOfText, treeFile(3, "{ {1} {1} }"), "found '}', expected '{'");
    VERIFY_REFUSED(materialOfText, treeFile(4, "{ 1"), "found its end, expected a finite number or a brace");
    VERIFY_REFUSED(materialOfText, treeFile(4, "{ nan }"), "byte 2 of the tree: found 'nan'");
    VERIFY_REFUSED(materialOfText, treeFile(4, "{ 1 } 2"), "found '2', expected the end of the data");
    VERIFY_REFUSED(materialOfText, treeFile(4, "{1}", "LBNL/Klems Full"), "expected LBNL/Shirley-Chiu");
    std::string deep;
    for (int i = 0; i < 40; ++i) deep += "{";
    VERIFY_REFUSED(materialOfText, treeFile(4, deep), "expected at most 32 levels");
  }

  void blocksAndColours() {
    const std::string front = block("Reflection Front", quarter, constant("0.25")),
                      back = block("Reflection Back", quarter, constant("0.5")),
                      through = block("Transmission Front", quarter, constant("0.1"));
    const auto at = [](const materials::Material& read) { return read.brdf->evaluate({0, 0, 1}, {0.6, 0, 0.8}); };
    const materials::Material both = materialOfText(file("Columns", wavelength("Visible", through + front + back)));
    QVERIFY(at(both) == Rgb(0.25));
    QCOMPARE(both.source.notes.at(1), std::string("Reflection Back was left out"));
    QCOMPARE(both.source.notes.at(2), std::string("'Transmission Front' was left out"));
    QVERIFY(at(materialOfText(file("Columns", wavelength("Visible", back)))) == Rgb(0.5));
    // The solar block beside the visible one; a single other one.
    const std::string solar =
        wavelength("Solar", back.substr(0, back.find("Back")) + "Front" + back.substr(back.find("Back") + 4));
    QVERIFY(at(materialOfText(file("Columns", solar + wavelength("Visible", front)))) == Rgb(0.25));
    QVERIFY(at(materialOfText(file("Columns", solar))) == Rgb(0.5));
    VERIFY_REFUSED(materialOfText, file("Columns", solar + wavelength("NIR", front)),
                   "'nir', 'solar', expected Visible");
    // Equal X, Y and Z are grey.
    const materials::Material grey = materialOfText(
        file("Columns", wavelength("Visible", front) + wavelength("CIE-X", front) + wavelength("CIE-Z", front)));
    QVERIFY(glm::length(at(grey) - Rgb(0.25)) < 1e-4);
    const materials::Material blue =
        materialOfText(file("Columns", wavelength("Visible", front) + wavelength("CIE-X", front) +
                                           wavelength("CIE-Z", block("Reflection Front", quarter, constant("0.5")))));
    QVERIFY(at(blue).z > 0.4 && at(blue).x < 0.26);
    QVERIFY(contains(
        materialOfText(file("Columns", wavelength("Visible", block("Reflection Front", quarter, constant("-1")))))
            .source.notes.at(1),
        "5043 negative values were set to 0"));
  }

  void errorsSayWhatWasFound() {
    const std::string good = wavelength("Visible", block("Reflection Front", quarter, constant("0.25")));
    VERIFY_REFUSED(materialOfText, file("Diagonals", good),
                   "found the IncidentDataStructure 'Diagonals', expected Columns, Rows, TensorTree3 or TensorTree4");
    VERIFY_REFUSED(materialOfText,
                   file("Columns", wavelength("Visible", block("Transmission Back", quarter, constant("1")))),
                   "found no block of reflection; expected a WavelengthDataBlock with Reflection Front");
    VERIFY_REFUSED(materialOfText,
                   file("Columns", wavelength("Visible", block("Reflection Front", "Mine", constant("1")))),
                   "found the ColumnAngleBasis 'Mine', expected LBNL/Klems Full");
    VERIFY_REFUSED(materialOfText, file("Columns", wavelength("Visible", block("Reflection Front", quarter, "1 2 3"))),
                   "found 3 values of the block 'visible', expected 41 x 41 for LBNL/Klems Quarter");
    VERIFY_REFUSED(materialOfText, file("Columns", wavelength("Visible", block("Reflection Front", quarter, "1 2 x"))),
                   "found 'x' as value 3 of the block 'visible', expected a finite number");
    VERIFY_REFUSED(materialOfText, file("Columns", good + good), "found two blocks 'Reflection Front'");
    const std::string half = file("Columns", good).substr(0, 600);
    VERIFY_REFUSED(materialOfText, half, "found text that is not XML");
  }
};

GONIO_TEST(RadianceFileTest)
}  // namespace radiance_file_test

#include "radiance_file_test.moc"
