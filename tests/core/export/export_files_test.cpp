// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_files.h"

#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "core/io/byte_source.h"
#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace export_files_test {
using namespace gonio;
namespace fs = std::filesystem;

std::string messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// While it lives, no file of this process grows beyond so many bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class ExportFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void filesInUseAreRefused() {
    const fs::path file = path("used");
    exports::writeExport(std::vector<exports::ExportFile>{{file, {std::byte{1}}}});
    const std::vector<fs::path> targets{file}, sources{path("other"), file};
    QVERIFY(messageOf([&] { exports::checkTargets(targets, {}, false); }).find(file.string()) == 0);
    QCOMPARE(messageOf([&] { exports::checkTargets(targets, {}, true); }), std::string());
    QVERIFY(messageOf([&] { exports::checkTargets(targets, sources, true); }).find("material uses") !=
            std::string::npos);
    const std::vector<fs::path> nowhere{path("no folder") / "a.bsdf"};
    QVERIFY(messageOf([&] { exports::checkTargets(nowhere, {}, false); }).find("a.bsdf") != std::string::npos);
  }

  /// Where a later file cannot be written nothing of the others stays.
  void allFilesOrNone() {
    const fs::path first = path("first"), second = path("no folder") / "second";
    const std::vector<exports::ExportFile> files{{first, {std::byte{1}}}, {second, {std::byte{2}}}};
    QVERIFY(messageOf([&] { exports::writeExport(files); }).find("second") != std::string::npos);
    QVERIFY(!fs::exists(first));
  }

  /// A limit on the size of files stands for a full disk: the large second file fails when it is written, and the
  /// first, which is replaced, stays as it was.
  void aFullDiskChangesNothing() {
    const QTemporaryDir folder;
    const fs::path one = fs::path(folder.path().toStdString()) / "one", two = one.parent_path() / "two";
    const std::vector<std::byte> old{std::byte{1}};
    exports::writeExport(std::vector<exports::ExportFile>{{one, old}});
    const std::vector<exports::ExportFile> files{{one, {std::byte{2}}}, {two, std::vector<std::byte>(100'000)}};
    const std::string message = [&] {
      const FileSizeLimit limit(50'000);
      return messageOf([&] { exports::writeExport(files); });
    }();
    QVERIFY2(message.starts_with(two.string() + ": cannot be written: "), message.c_str());
    QVERIFY(io::FileSource(one).readAll(10) == old);
    QCOMPARE(std::distance(fs::directory_iterator(one.parent_path()), fs::directory_iterator()), std::ptrdiff_t(1));
  }

 private:
  fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }
  QTemporaryDir folder_;
};

GONIO_TEST(ExportFilesTest)

}  // namespace export_files_test

#include "export_files_test.moc"
