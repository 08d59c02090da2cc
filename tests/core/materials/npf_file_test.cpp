// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/npf_file.h"

#include <QTest>
#include <cmath>

#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace npf_file_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::io;
using namespace gonio::materials;

constexpr std::size_t columns = 512;

/// value = row 1000 + column + channel / 4, which single precision holds.
test::Bytes table(int rows) {
  test::Bytes bytes;
  for (int row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      for (int channel = 0; channel < 3; ++channel)
        test::append(bytes, float(1000 * row) + float(column) + 0.25f * float(channel));
  return bytes;
}

NpfTable read(const test::Bytes& bytes, std::string_view names) { return readNpf(MemorySource(bytes), names); }

const std::filesystem::path sharedTable = std::filesystem::path(GONIO_SHARED_DIR) / "data/tables/npf.bin";

class NpfFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void columnsAndNames() {
    const NpfTable found = read(table(2), "row,material\r\n1,second\r\n0,first\n\n");
    QCOMPARE(found.materials.size(), std::size_t(2));
    QVERIFY(!found.find("third"));
    const NonparametricFactors* second = found.find("second");
    QVERIFY(second);
    const NonparametricFactors::Channel& blue = second->channels[2];
    QCOMPARE(blue.diffuse, 1000.5);
    QCOMPARE(blue.specular, 1001.5);
    QCOMPARE(blue.d[0], 1002.5);
    QCOMPARE(blue.d[88], 1090.5);
    QCOMPARE(blue.d[89], 1090.5);  // the mark at the end is no value
    QCOMPARE(blue.g[0], 1093.5);
    QCOMPARE(blue.g[89], 1182.5);
    QCOMPARE(blue.f[0], 1183.5);
    QCOMPARE(blue.f[89], 1271.5);
    QCOMPARE(found.find("first")->channels[0].diffuse, 0.0);
    // The names decide which row belongs to a material.
    QVERIFY(found.sha256 != read(table(2), "row,material\n0,second\n1,first\n").sha256);
    QVERIFY(found.sha256 != read(table(3), "row,material\r\n1,second\r\n0,first\n\n").sha256);
  }

  void errorsTellWhere() {
    const test::Bytes good = table(2);
    QVERIFY(test::contains(test::errorOf([&] { read({}, "row,material\n"); }), "found 0 bytes, expected rows of 6144"));
    QVERIFY(test::contains(test::errorOf([&] {
                             read({good.begin(), good.end() - 1}, "row,material\n");
                           }),
                           "found 12287 bytes"));
    QVERIFY(test::contains(test::errorOf([&] { read(good, "row,material\n2,a\n"); }),
                           "line 2: found row 2, expected 0 to 1"));
    QVERIFY(test::contains(test::errorOf([&] { read(good, "row,material\n0,a\nb\n"); }),
                           "line 3: found 1 columns, expected 2: row, material"));
    QVERIFY(test::contains(test::errorOf([&] { read(good, "row,material\n-1,a\n"); }), "found row -1"));
    QVERIFY(test::contains(test::errorOf([&] { read(test::Bytes(6144), "row,material\n0,a\n"); }), "row 0 is empty"));
    for (const float bad : {-1.0f, std::nanf(""), INFINITY}) {
      test::Bytes bytes = good;
      std::memcpy(bytes.data() + 4 * (3 * (columns + 93) + 1), &bad, 4);
      QVERIFY(test::contains(test::errorOf([&] { read(bytes, "row,material\n1,a\n"); }), "row 1, column 93: found"));
      QCOMPARE(read(bytes, "row,material\n0,a\n").materials.size(), std::size_t(1));
    }
  }

  void errorsNameTheFile() {
    const auto path = test::writeFile("npf/npf.bin", table(1));
    std::filesystem::remove(path.parent_path() / "npf_row_order.csv");
    QVERIFY(test::contains(test::errorOf([&] { readNpf(path); }), "npf_row_order.csv"));
    const auto absent = path.parent_path() / "absent.bin";
    QVERIFY(test::contains(test::errorOf([&] { readNpf(absent); }), absent.string()));
    const std::string names = "row,material\n7,a\n";
    test::writeFile("npf/npf_row_order.csv", std::as_bytes(std::span(names)));
    QVERIFY(test::contains(test::errorOf([&] { readNpf(path); }), path.string() + ": npf_row_order.csv, line 2"));
  }

  /// "FILE#NAME" and "FILE#NUMBER" are materials; a number needs no names.
  void rowsAreMaterials() {
    const auto path = test::writeFile("npf-rows/table.bin", table(3));
    const std::filesystem::path names = path.parent_path() / "npf_row_order.csv";
    std::filesystem::remove(names);
    const auto row = [&](const char* name) { return path.string() + "#" + name; };
    const Material second = readMaterial(row("1"));
    QCOMPARE(second.name, std::string("table-1"));
    const DirectionPair pair{fromSpherical(0.3, 0), fromSpherical(0.5, 2)};
    const NpfTable found = read(table(3), "row,material\n1,second\n");
    QVERIFY(second.brdf->evaluate(pair.wi, pair.wo) ==
            makeNonparametricBrdf(*found.find("second"))->evaluate(pair.wi, pair.wo));
    QVERIFY(test::contains(test::errorOf([&] { readMaterial(row("second")); }), "npf_row_order.csv"));
    const std::string text = "row,material\n1,second\n";
    test::writeFile("npf-rows/npf_row_order.csv", std::as_bytes(std::span(text)));
    const Material named = readMaterial(row("second"));
    QCOMPARE(named.name, std::string("second"));
    QCOMPARE(named.source.sha256, second.source.sha256);
    QVERIFY(named.source.sha256 != readMaterial(row("2")).source.sha256);
    QVERIFY(test::contains(test::errorOf([&] { readMaterial(row("3")); }), "found row 3, expected 0 to 2"));
    QVERIFY(test::contains(test::errorOf([&] { readMaterial(row("third")); }), "one of the 1 names"));
    const auto empty = test::writeFile("npf-rows/empty.bin", test::Bytes(6144));
    QVERIFY(test::contains(test::errorOf([&] { readMaterial(empty.string() + "#0"); }), "row 0 is empty"));
    QVERIFY(!isNpfRow("missing.bin#1") && !isNpfRow(path));
  }

  /// All hundred; chrome's lobe at the mirror direction of 45 degrees by the published formula, from figures read by
  /// hand: D and F at their first nodes are D[0] = 1 and F[45], G halfway between the centres 44.5 and 45.5.
  void publishedTable() {
    if (!std::filesystem::exists(sharedTable)) QSKIP("no shared data");
    const NpfTable found = readNpf(sharedTable);
    QCOMPARE(found.materials.size(), std::size_t(100));
    const NonparametricFactors* chrome = found.find("chrome");
    QVERIFY(chrome);
    QCOMPARE(float(chrome->channels[0].specular), 4441.16016f);
    QCOMPARE(chrome->channels[0].d[0], 1.0);
    QVERIFY(std::abs(chrome->channels[0].g[0] - 0.62704) < 1e-5);
    QVERIFY(std::abs(chrome->channels[0].f[0] - 0.25828) < 1e-5);
    const NonparametricFactors::Channel& c = chrome->channels[0];
    const double g = (c.g[44] + c.g[45]) / 2, cosine = std::sqrt(0.5);
    const double expected = (c.diffuse + c.specular * c.f[45] * g * g / (cosine * cosine)) / pi;
    const double value = makeNonparametricBrdf(*chrome)->evaluate({cosine, 0, cosine}, {-cosine, 0, cosine}).x;
    QVERIFY2(std::abs(value / expected - 1) < 1e-6, qPrintable(QString("%1 %2").arg(value).arg(expected)));
    QVERIFY(value > 100 && value < 2000);
  }
};

GONIO_TEST(NpfFileTest)
}  // namespace npf_file_test

#include "npf_file_test.moc"
