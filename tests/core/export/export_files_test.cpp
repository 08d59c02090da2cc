// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_files.h"

#include <QTemporaryDir>
#include <QTest>

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

class ExportFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void filesInUseAreRefused() {
    const fs::path file = path("used");
    exports::writeExport(std::vector<exports::ExportFile>{{file, {std::byte{1}}}});
    const std::vector<fs::path> targets{file}, sources{path("other"), file};
    QVERIFY(messageOf([&] { exports::checkTargets(targets, {}, false); }).find(file.string()) == 0);
    QCOMPARE(messageOf([&] { exports::checkTargets(targets, {}, true); }), std::string());
    QVERIFY(messageOf([&] { exports::checkTargets(targets, sources, true); }).find("made of") != std::string::npos);
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

 private:
  fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }
  QTemporaryDir folder_;
};

GONIO_TEST(ExportFilesTest)

}  // namespace export_files_test

#include "export_files_test.moc"
