// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <sys/resource.h>

#include <QTest>
#include <csignal>
#include <functional>

#include "core/documents/edit_document.h"
#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/io/sha256.h"
#include "core/materials/code_file.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/materials/npf_file.h"
#include "core/materials/pdv_file.h"
#include "core/materials/training_checkpoint.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

namespace file_basics_test {
using namespace gonio;
using namespace gonio::test;
namespace fs = std::filesystem;

using Read = std::function<void(const fs::path&)>;

class FileBasicsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The examples of FIPS 180-4 and one of a million characters.
  void sha256OfKnownTexts() {
    QCOMPARE(io::sha256Hex(std::string_view("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    QCOMPARE(io::sha256Hex(std::string_view("abc")),
             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    const std::string million(1000000, 'a');
    const std::string expected = "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";
    QCOMPARE(io::sha256Hex(std::string_view(million)), expected);
    QCOMPARE(io::sha256Hex(io::MemorySource(std::as_bytes(std::span(million)))), expected);
  }

  void sourcesReadAtAnyPositionAndNotBeyond() {
    const Bytes bytes = {std::byte{1}, std::byte{2}, std::byte{3}};
    const io::FileSource file(writeFile("io/three_bytes", bytes));
    const io::MemorySource memory(bytes);
    for (const io::ByteSource* source :
         {static_cast<const io::ByteSource*>(&file), static_cast<const io::ByteSource*>(&memory)}) {
      QCOMPARE(source->size(), std::uint64_t(3));
      QCOMPARE(source->readAll(), bytes);
      Bytes two(2);
      source->readAt(1, two);
      QCOMPARE(two[1], std::byte{3});
      QVERIFY(!errorOf([&] { source->readAt(2, two); }).empty());
    }
    QVERIFY(contains(errorOf([] { io::FileSource missing(outputPath("io/no_such_file")); }), "cannot be opened"));
    QVERIFY(contains(errorOf([] { io::FileSource folder(fs::path(GONIO_TEST_OUTPUT_DIR)); }), "folder"));
  }

  /// A path stands in front of what is wrong, and nowhere else.
  void readersNameTheFileOnce_data() {
    QTest::addColumn<Read>("read");
    QTest::newRow("material") << Read([](const fs::path& path) { materials::readMaterial(path); });
    QTest::newRow("dictionary") << Read([](const fs::path& path) { materials::readDictionary(path); });
    QTest::newRow("code") << Read([](const fs::path& path) { materials::readCode(path); });
    QTest::newRow("factors") << Read([](const fs::path& path) { materials::readPdv(path); });
    QTest::newRow("checkpoint") << Read([](const fs::path& path) { materials::readCheckpoint("training", path); });
    QTest::newRow("picture") << Read([](const fs::path& path) { io::readImage(path); });
    QTest::newRow("document") << Read([](const fs::path& path) { editing::readDocument(path); });
    QTest::newRow("nonparametric") << Read([](const fs::path& path) {
      writeFile("io/npf_row_order.csv", {});
      materials::readNpf(path);
    });
  }
  void readersNameTheFileOnce() {
    QFETCH(Read, read);
    const fs::path missing = outputPath("io/no_such_file"), garbage = writeFile("io/garbage", Bytes(100, std::byte{7}));
    const fs::path folder = emptyFolder("io/some_folder");
    for (const fs::path& path : {missing, garbage, folder}) {
      const std::string error = errorOf([&] { read(path); }), start = path.string() + ": ";
      QVERIFY2(error.starts_with(start) && error.find(path.string(), start.size()) == std::string::npos, error.c_str());
    }
  }

  void replacesContentAndKeepsMode() {
    emptyFolder("io/atomic");
    const fs::path path = writeFile("io/atomic/file.txt", {});
    fs::permissions(path, fs::perms(0640));
    io::writeFileAtomically(path, "new content");
    QCOMPARE(readFile(path).size(), std::size_t(11));
    QCOMPARE(fs::status(path).permissions(), fs::perms(0640));
    QCOMPARE(std::distance(fs::directory_iterator(path.parent_path()), {}), std::ptrdiff_t(1));
  }

  void writesThroughALink() {
    const fs::path link = emptyFolder("io/link") / "link", target = writeFile("io/link/target", {});
    fs::create_symlink("target", link);
    io::writeFileAtomically(link, "x");
    QVERIFY(fs::is_symlink(link));
    QCOMPARE(fs::file_size(target), std::uintmax_t(1));
  }

  /// The disk fills up while the new content is written: a limit on the size of files plays the disk.
  void failureHalfwayKeepsTheOldFile() {
    const Bytes old(3, std::byte{7});
    emptyFolder("io/full");
    const fs::path path = writeFile("io/full/file", old);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = errorOf([&] { io::writeFileAtomically(path, std::string(5000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY(contains(error, path.string()));
    QCOMPARE(readFile(path), old);
    QCOMPARE(std::distance(fs::directory_iterator(path.parent_path()), {}), std::ptrdiff_t(1));
  }

  void failureNamesTheFileAndLeavesNothing() {
    const fs::path folder = emptyFolder("io/failure");
    QVERIFY(contains(errorOf([&] { io::writeFileAtomically(folder / "absent" / "f", "x"); }), "absent"));
    QVERIFY(contains(errorOf([&] { io::checkWritable(folder / "absent" / "f"); }), "absent"));
    fs::create_directories(folder / "is_folder");
    QVERIFY(contains(errorOf([&] { io::writeFileAtomically(folder / "is_folder", "x"); }), "is_folder"));
    QVERIFY(contains(errorOf([&] { io::checkWritable(folder / "is_folder"); }), "is_folder"));
    io::checkWritable(folder / "free");
    QCOMPARE(std::distance(fs::directory_iterator(folder), {}), std::ptrdiff_t(1));
  }
};

GONIO_TEST(FileBasicsTest)
}  // namespace file_basics_test

#include "file_basics_test.moc"
