// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/merl.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/io/byte_source.h"
#include "core/math/parallel.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace merl_file_test {
using namespace gonio;
using namespace gonio::test;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A file of these axis counts with the given raw values, 3 planes.
Bytes merlFile(std::int32_t h, std::int32_t d, std::int32_t f, const std::vector<double>& raw) {
  Bytes bytes;
  for (const std::int32_t count : {h, d, f}) append(bytes, count);
  for (const double value : raw) append(bytes, value);
  return bytes;
}

/// A 2 x 3 x 4 grid with raw values 1, 2, .. 72.
std::vector<double> countingValues() {
  std::vector<double> raw(72);
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = double(i + 1);
  return raw;
}

formats::MerlTable read(const Bytes& bytes) { return formats::readMerl(io::MemorySource(bytes)); }
std::string readError(const Bytes& bytes) {
  return errorOf([&] { read(bytes); });
}

class MerlFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void planesBecomeScaledRgb() {
    const formats::MerlTable merl = read(merlFile(2, 3, 4, countingValues()));
    const HalfDifferenceGrid expected{2, 3, 4, true};
    QVERIFY(merl.table->grid() == expected);
    for (std::size_t cell = 0; cell < 24; ++cell) {
      QCOMPARE(merl.table->values()[cell].x, float(double(cell + 1) / 1500));
      QCOMPARE(merl.table->values()[cell].y, float(double(cell + 25) * 1.15 / 1500));
      QCOMPARE(merl.table->values()[cell].z, float(double(cell + 49) * 1.66 / 1500));
    }
    QCOMPARE(merl.table->validCount(), std::size_t(24));
    QCOMPARE(merl.clampedCount, std::uint64_t(0));
  }

  void fourPhiSamplesADifferenceSampleAreNonReciprocal() {
    QVERIFY(!read(merlFile(1, 2, 8, std::vector<double>(48, 1))).table->grid().reciprocal);
    QVERIFY(read(merlFile(1, 2, 4, std::vector<double>(24, 1))).table->grid().reciprocal);
  }

  /// As the LIRIS data set of perceived quality (2026 BRDFs, 90 x 90 x 360) and DTU's measurements (90 x 90 x 180, with
  /// cells below -1 where nothing was measured) are stored.
  void sizesAndMarksOfOtherDatabases() {
    const HalfDifferenceGrid liris{90, 90, 360, false};
    Bytes bytes = merlFile(90, 90, 360, std::vector<double>(3 * liris.size(), 150));
    QCOMPARE(bytes.size(), std::size_t(69984012));
    const auto table = read(bytes).table;
    QVERIFY(table->grid() == liris && !table->isReciprocal());
    QCOMPARE(table->values()[12345].x, float(0.1));
    std::vector<double> raw = countingValues();
    raw[5] = -1500;
    raw[24 + 6] = -1e9;
    const formats::MerlTable marked = read(merlFile(2, 3, 4, raw));
    QVERIFY(!marked.table->valid()[5] && !marked.table->valid()[6]);
    QCOMPARE(marked.clampedCount, std::uint64_t(0));
  }

  void hardCase11InvalidCellsAndSmallNegatives() {
    std::vector<double> raw = countingValues();
    raw[0] = raw[24] = raw[48] = -1;
    raw[24 + 5] = -1;  // one channel is enough
    raw[7] = -0.25;
    raw[48 + 7] = -1e-9;
    raw[24 + 9] = -0.0;
    const formats::MerlTable merl = read(merlFile(2, 3, 4, raw));
    QCOMPARE(merl.table->validCount(), std::size_t(22));
    QVERIFY(!merl.table->valid()[0] && !merl.table->valid()[5] && merl.table->valid()[7]);
    QCOMPARE(merl.clampedCount, std::uint64_t(2));
    QVERIFY(merl.table->values()[7].x == 0 && merl.table->values()[7].y > 0 && merl.table->values()[7].z == 0);
    QVERIFY(merl.table->values()[9].y == 0 && !std::signbit(merl.table->values()[9].y));
  }

  void hardCase12BlackChannelStaysBlack() {
    std::vector<double> raw = countingValues();
    for (std::size_t i = 24; i < 48; ++i) raw[i] = 0;
    const auto table = read(merlFile(2, 3, 4, raw)).table, again = read(formats::encodeMerl(*table)).table;
    for (const auto& value : table->values()) QVERIFY(value.x > 0 && value.y == 0 && value.z > 0);
    for (const auto& value : again->values()) QVERIFY(value.x > 0 && value.y == 0 && value.z > 0);
  }

  void hardCase13CorruptHeadersAreRefusedBeforeAllocation() {
    const std::vector<double> raw = countingValues();
    const std::int32_t big = 0x7fffffff;
    for (const auto& counts : std::vector<std::array<std::int32_t, 3>>{{0, 0, 0},
                                                                       {0, 90, 180},
                                                                       {-2, -3, 4},
                                                                       {2, -3, -4},
                                                                       {big, big, big},
                                                                       {1000000000, 2, 2},
                                                                       {1 << 20, 1 << 20, 1 << 20},
                                                                       {1 << 16, 1 << 16, 1 << 16},
                                                                       {2, 3, 5},
                                                                       {2, 3, 3},
                                                                       {90, 90, 180}})
      QVERIFY(contains(readError(merlFile(counts[0], counts[1], counts[2], raw)), "expected"));
    // 24 x 2^61 cells are 0 modulo 2^64: a product that wraps would match an empty table.
    QVERIFY(!readError(merlFile(1 << 20, 1 << 20, 1 << 21, {})).empty());

    Bytes bytes = merlFile(2, 3, 4, raw);
    for (std::size_t size : {0, 1, 11, 12, 13, 100, int(bytes.size()) - 1})
      QVERIFY(contains(readError(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(size))), "expected"));
    bytes.push_back(std::byte{0});
    QVERIFY(contains(readError(bytes), "2 x 3 x 4"));
  }

  void hardCase42NotFiniteValuesAreRefusedWithTheirIndex() {
    for (const double bad : {notANumber, infinity, -infinity, 1e300}) {
      std::vector<double> raw = countingValues();
      raw[24 + 17] = bad;
      raw[48 + 17] = bad;
      const std::string error = readError(merlFile(2, 3, 4, raw));
      QVERIFY2(contains(error, "value 41 (green, theta_h 1, theta_d 1, phi_d 1)"), error.c_str());
    }
    std::vector<double> raw = countingValues();
    raw[3] = -1;
    raw[27] = notANumber;  // an invalid cell is no place to hide
    QVERIFY(contains(readError(merlFile(2, 3, 4, raw)), "value 27"));
  }

  void writtenTableReadsBackTheSameBits() {
    std::vector<double> raw = countingValues();
    for (std::size_t i = 0; i < raw.size(); ++i)
      raw[i] = std::pow(10.0, double(i % 24) / 2 - 6) * (1 + 1e-3 * double(i));
    raw[4] = raw[28] = raw[52] = -1;
    const auto table = read(merlFile(2, 3, 4, raw)).table;
    const Bytes bytes = formats::encodeMerl(*table);
    const auto again = read(bytes).table;
    QVERIFY(std::ranges::equal(table->values(), again->values()));
    QVERIFY(std::ranges::equal(table->valid(), again->valid()));
    double invalid = 0;
    std::memcpy(&invalid, bytes.data() + 12 + 28 * 8, 8);
    QCOMPARE(invalid, -1.0);
    QCOMPARE(formats::encodeMerl(*again), bytes);
  }

  void gridsThatTheFormatCannotTellAreNotWritten() {
    for (const HalfDifferenceGrid& grid : {HalfDifferenceGrid{1, 2, 8, true}, HalfDifferenceGrid{1, 2, 4, false}}) {
      const TabulatedBrdf table(grid, std::vector<glm::vec3>(grid.size()), std::vector<std::uint8_t>(grid.size(), 1));
      QVERIFY(contains(errorOf([&] { formats::encodeMerl(table); }), "reciprocal"));
    }
  }

  void sameBitsForAnyNumberOfThreadsAndCancellation() {
    const HalfDifferenceGrid grid{40, 30, 50, true};
    std::vector<double> raw(3 * grid.size());
    for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = std::sin(double(i)) * 0.9;
    const Bytes bytes = merlFile(40, 30, 50, raw);
    const formats::MerlTable many = read(bytes);
    const ThreadLimit one(1);
    const formats::MerlTable single = read(bytes);
    QVERIFY(std::ranges::equal(many.table->values(), single.table->values()));
    QCOMPARE(many.clampedCount, single.clampedCount);
    QVERIFY(many.clampedCount > 10000);
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_EXCEPTION_THROWN(formats::readMerl(io::MemorySource(bytes), {stop.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(MerlFileTest)
}  // namespace merl_file_test

#include "merl_file_test.moc"
