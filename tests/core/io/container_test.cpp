// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/container.h"

#include <QTest>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/io/byte_source.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace container_test {
using namespace gonio;
using namespace gonio::test;

constexpr io::ContainerFormat format{.name = "test", .signature = "GONIOTST", .version = 3, .maxBytes = 400};

Bytes bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// One of each kind of field.
Bytes someFile() {
  io::ContainerWriter file(format);
  file.description({{"b", 2}, {"a", "one"}});
  file.number(std::uint16_t(7));
  file.values(std::vector<float>{1.5f, -2});
  file.values(Eigen::MatrixXd{{1, 2}, {3, 4}});
  file.append(bytesOf("rest"));
  return file.bytes();
}

/// All fields of such a file. @throws Error
void readAll(const Bytes& bytes) {
  io::ContainerReader file(format, io::MemorySource(bytes));
  QVERIFY(file.description() == (nlohmann::json{{"a", "one"}, {"b", 2}}));
  QCOMPARE(file.number<std::uint16_t>(), std::uint16_t(7));
  std::array<float, 2> values{};
  file.values(values, "value");
  QCOMPARE(values, (std::array{1.5f, -2.0f}));
  QCOMPARE(file.squareMatrix<double>(2), (Eigen::MatrixXd{{1, 2}, {3, 4}}));
  file.expectRemaining(4);
  const auto rest = file.rest();
  QVERIFY(Bytes(rest.begin(), rest.end()) == bytesOf("rest"));
}

std::string errorOfFile(const Bytes& bytes) {
  return errorOf([&] { readAll(bytes); });
}

class ContainerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Names of files need not be UTF-8.
  void descriptionsAreText() {
    io::ContainerWriter file(format);
    file.description({{"name", "caf\xe9"}});
    io::ContainerReader read(format, io::MemorySource(file.bytes()));
    QCOMPARE(read.description()["name"].get<std::string>(), std::string("caf\xef\xbf\xbd"));
  }

  /// The layout that the files of all versions have, byte by byte.
  void layout() {
    Bytes expected = bytesOf("GONIOTST");
    append(expected, std::uint32_t(3));
    const std::string description = R"({"a":"one","b":2})";
    append(expected, std::uint32_t(description.size()));
    for (const std::byte byte : bytesOf(description)) expected.push_back(byte);
    append(expected, std::uint16_t(7));
    for (const float value : {1.5f, -2.0f}) append(expected, value);
    for (const double entry : {1.0, 3.0, 2.0, 4.0}) append(expected, entry);
    for (const std::byte byte : bytesOf("rest")) expected.push_back(byte);
    QCOMPARE(someFile(), expected);
    io::ContainerFormat narrow = format;
    narrow.versionBytes = 2;
    const Bytes start = io::ContainerWriter(narrow).bytes();
    QCOMPARE(start.size(), std::size_t(10));
    io::ContainerReader(narrow, io::MemorySource(start)).expectRemaining(0);
  }

  void everyFieldComesBack() { readAll(someFile()); }

  void otherFilesAreNotOfTheFormat() {
    const Bytes foreign = bytesOf("GONIOXXX and more"), tooShort = bytesOf("GONIO");
    for (const Bytes& bytes : {foreign, tooShort, Bytes{}}) {
      QVERIFY(!io::hasSignature(io::MemorySource(bytes), format));
      QVERIFY_EXCEPTION_THROWN(io::expectSignature(io::MemorySource(bytes), format), io::FormatMismatch);
      QCOMPARE(errorOfFile(bytes), std::string("not a test file (signature missing)"));
    }
    QVERIFY(io::hasSignature(io::MemorySource(someFile()), format));
  }

  void everyCutIsRefused() {
    const Bytes whole = someFile();
    for (std::size_t size = 8; size < whole.size(); ++size) {
      const std::string error = errorOfFile(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size)));
      QVERIFY2(error.starts_with("test file: "), error.c_str());
    }
  }

  void errorsStateWhatWasFoundAndExpected() {
    const Bytes good = someFile();
    const auto with = [&good](std::size_t at, auto number) {
      Bytes bytes = good;
      std::memcpy(bytes.data() + at, &number, sizeof number);
      return bytes;
    };
    QCOMPARE(errorOfFile(with(8, 9u)), std::string("test file: the version is 9, expected 3"));
    QVERIFY(contains(errorOfFile(with(12, 0xffffffffu)), "the description has 4294967295 bytes, expected at most"));
    QVERIFY(contains(errorOfFile(with(16, '?')), "test file: in the description found text that is not JSON"));
    io::ContainerWriter deep(format);
    deep.description(nlohmann::json::parse(std::string(65, '[') + std::string(65, ']')));
    QVERIFY(contains(errorOfFile(deep.bytes()), "test file: in the description found JSON nested deeper than 64"));
    const float infinite = std::numeric_limits<float>::infinity();
    QVERIFY(contains(errorOfFile(with(16 + 17 + 2 + 4, infinite)), "a value that is not finite (number 1)"));
    const double none = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(contains(errorOfFile(with(good.size() - 4 - 8, none)), "not finite (number 3)"));
    Bytes longer = good;
    longer.push_back({});
    const std::string size = std::to_string(good.size());
    QVERIFY(contains(errorOfFile(longer), "is " + std::to_string(good.size() + 1) + " bytes, expected " + size));
    longer.resize(401);
    QVERIFY(contains(errorOfFile(longer), "found 401 bytes, expected at most 400"));
    Bytes empty = bytesOf("GONIOTST");
    append(empty, format.version);
    QVERIFY(
        contains(errorOf([&] { io::ContainerReader(format, io::MemorySource(empty)).squareMatrix<double>(1 << 20); }),
                 "ends at byte 12, expected"));
  }
};

GONIO_TEST(ContainerTest)
}  // namespace container_test

#include "container_test.moc"
