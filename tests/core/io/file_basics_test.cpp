// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QTest>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <functional>

#include "core/documents/edit_document.h"
#include "core/documents/open_material.h"
#include "core/formats/code.h"
#include "core/formats/pdv.h"
#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/io/sha256.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/materials/npf_file.h"
#include "tests/core/io/test_files.h"
#include "tests/support/test_program.h"

// In place of the system's: a rename, or every hard link, fails when a test asks for it.
namespace {
int renamesUntilFailure = -1;
bool linksFail = false;
}  // namespace

extern "C" int rename(const char* from, const char* to) noexcept {
  if (renamesUntilFailure >= 0 && renamesUntilFailure-- == 0) {
    errno = EBUSY;
    return -1;
  }
  return reinterpret_cast<int (*)(const char*, const char*)>(::dlsym(RTLD_NEXT, "rename"))(from, to);
}

extern "C" int link(const char* from, const char* to) noexcept {
  if (linksFail) {
    errno = EPERM;
    return -1;
  }
  return reinterpret_cast<int (*)(const char*, const char*)>(::dlsym(RTLD_NEXT, "link"))(from, to);
}

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
    QTest::newRow("code") << Read([](const fs::path& path) { formats::readCode(path); });
    QTest::newRow("factors") << Read([](const fs::path& path) { formats::readPdv(path); });
    QTest::newRow("checkpoint") << Read([](const fs::path& path) { materials::readCheckpoint("training", path); });
    QTest::newRow("picture") << Read([](const fs::path& path) { io::readImage(path); });
    QTest::newRow("document") << Read([](const fs::path& path) { documents::readDocument(path); });
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

  /// Three files, of which the middle one is new; the last one, or the one before, cannot be renamed.
  void aSetIsReplacedAsAWholeOrNotAtAll() {
    for (const int failing : {0, 1, 2}) {
      const fs::path folder = emptyFolder("io/set");
      const Bytes old(3, std::byte{7}), content(5, std::byte{8});
      const fs::path paths[] = {writeFile("io/set/a", old), folder / "b", writeFile("io/set/c", old)};
      const io::FileContent files[] = {{paths[0], content}, {paths[1], content}, {paths[2], content}};
      renamesUntilFailure = failing;
      const std::string error = errorOf([&] { io::writeFilesAtomically(files); });
      renamesUntilFailure = -1;
      QVERIFY2(error.starts_with(paths[failing].string()), error.c_str());
      QVERIFY(!contains(error, "already replaced"));
      QCOMPARE(readFile(paths[0]), old);
      QCOMPARE(readFile(paths[2]), old);
      QCOMPARE(std::distance(fs::directory_iterator(folder), {}), std::ptrdiff_t(2));
      io::writeFilesAtomically(files);
      for (const fs::path& path : paths) QCOMPARE(readFile(path), content);
      QCOMPARE(std::distance(fs::directory_iterator(folder), {}), std::ptrdiff_t(3));
    }
  }

  /// On a file system without hard links the error says what has changed.
  void whatCannotBeRestoredIsNamed() {
    const fs::path folder = emptyFolder("io/set");
    const Bytes old(3, std::byte{7}), content(5, std::byte{8});
    const fs::path paths[] = {writeFile("io/set/a", old), folder / "b", writeFile("io/set/c", old)};
    const io::FileContent files[] = {{paths[0], content}, {paths[1], content}, {paths[2], content}};
    renamesUntilFailure = 2;
    linksFail = true;
    const std::string error = errorOf([&] { io::writeFilesAtomically(files); });
    renamesUntilFailure = -1;
    linksFail = false;
    QVERIFY2(error.ends_with("already replaced: " + paths[0].string()), error.c_str());
    QCOMPARE(readFile(paths[0]), content);
    QCOMPARE(readFile(paths[2]), old);
    QCOMPARE(std::distance(fs::directory_iterator(folder), {}), std::ptrdiff_t(2));
  }

  /// Neither waited for nor replaced: a rename would put a file in the place of /dev/null.
  void onlyRegularFilesAreReadAndReplaced() {
    const fs::path folder = emptyFolder("io/special"), pipe = folder / "pipe", toPipe = folder / "link";
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    fs::create_symlink("pipe", toPipe);
    for (const fs::path& path : {pipe, toPipe, fs::path("/dev/null")}) {
      QVERIFY(contains(errorOf([&] { io::FileSource source(path); }), "a pipe"));
      QVERIFY(contains(errorOf([&] { materials::readMaterial(path); }), path.string()));
      QVERIFY(!documents::isDocument(path.string()));
      QVERIFY(contains(errorOf([&] { io::writeFileAtomically(path, "x"); }), "a pipe"));
      QVERIFY(contains(errorOf([&] { io::checkWritable(path); }), path.string()));
    }
    QVERIFY(fs::is_fifo(pipe) && fs::is_character_file("/dev/null"));
    const fs::path cut = folder / std::string("a\0b", 3);
    QVERIFY(contains(errorOf([&] { io::FileSource source(cut); }), "NUL"));
    QVERIFY(contains(errorOf([&] { io::writeFileAtomically(cut, "x"); }), "NUL"));
  }

  void readingStopsWhenAsked() {
    const io::FileSource file(writeFile("io/three_bytes", Bytes(3)));
    std::stop_source stop;
    const io::FileSource stoppable(outputPath("io/three_bytes"), stop.get_token());
    Bytes byte(1);
    stoppable.readAt(0, byte);
    stop.request_stop();
    QVERIFY_EXCEPTION_THROWN(stoppable.readAt(0, byte), Cancelled);
    QVERIFY_EXCEPTION_THROWN(io::sha256Hex(file, stop.get_token()), Cancelled);
  }

  /// 40 GB whose first bytes say already that it is no material: nobody needs its hash.
  void aHugeFileThatIsNoMaterialIsNotReadToItsEnd() {
    struct Huge final : io::ByteSource {
      mutable std::atomic<std::uint64_t> read = 0;
      std::uint64_t size() const override { return std::uint64_t(40) << 30; }
      void readAt(std::uint64_t, std::span<std::byte> target) const override {
        read += target.size();
        std::ranges::fill(target, std::byte{7});
      }
    };
    const Huge source;
    QVERIFY(!errorOf([&] { materials::readMaterial(source); }).empty());
    QVERIFY(source.read < source.size() / 2);
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
