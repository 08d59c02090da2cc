// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/autosave.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

namespace autosave_test {
using namespace gonio;
using namespace gonio::app;

class AutosaveTest : public QObject {
  Q_OBJECT
 private:
  static editing::EditDocument work() {
    editing::EditDocument document;
    document.sourcePath = "library:sgd/chrome";
    document.sourceSha256 = std::string(64, '7');
    return document;
  }

 private Q_SLOTS:
  void copiesLieBesideTheDocumentAndGoWithTheSave() {
    const QTemporaryDir folder;
    bool unsaved = true;
    Autosave autosave(folder.filePath("data"), [&] { return unsaved ? std::optional(work()) : std::nullopt; });
    const QString path = folder.filePath("mine.gonio");
    autosave.setDocumentPath(path);
    const QString copy = autosave.currentCopy();
    QVERIFY(QFile::exists(copy));
    QCOMPARE(QFileInfo(copy).path(), folder.path());
    QVERIFY(copy.startsWith(path + '.') && copy.endsWith(".autosave"));
    unsaved = false;
    autosave.setDocumentPath(path);
    QVERIFY(!QFile::exists(copy));
    QVERIFY(Autosave::recoverable(folder.filePath("data")).isEmpty());
  }

  void nothingUnsavedLeavesNoCopy() {
    const QTemporaryDir folder;
    bool unsaved = true;
    Autosave autosave(folder.filePath("data"), [&] { return unsaved ? std::optional(work()) : std::nullopt; });
    autosave.update();
    const QString copy = autosave.currentCopy();
    QVERIFY(QFile::exists(copy));
    unsaved = false;
    autosave.update();
    QVERIFY(!QFile::exists(copy));
  }

  /// Two editors with one document: neither replaces nor removes the copy of the other.
  void editorsOfOneDocumentHaveACopyEach() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("mine.gonio");
    const auto snapshot = [] { return std::optional(work()); };
    Autosave first(folder.filePath("data"), snapshot), second(folder.filePath("data"), snapshot);
    first.setDocumentPath(path);
    second.setDocumentPath(path);
    QVERIFY(first.currentCopy() != second.currentCopy());
    first.discard();
    QVERIFY(QFile::exists(second.currentCopy()));
  }

  /// Where the document's folder takes no copy, the data folder does.
  void aCopyOfADocumentInALostFolderIsKept() {
    const QTemporaryDir folder;
    const QString data = folder.filePath("data"), path = folder.filePath("gone/mine.gonio");
    Autosave autosave(data, [] { return std::optional(work()); });
    autosave.setDocumentPath(path);
    QCOMPARE(QFileInfo(autosave.currentCopy()).path(), data);
    QCOMPARE(editing::readDocument(autosave.currentCopy().toStdString()).sourcePath, work().sourcePath);
  }

  /// A full disk, or a document that cannot be written: what was copied before stays.
  void aFailedCopyKeepsTheOneBefore() {
    const QTemporaryDir folder;
    editing::EditDocument document = work();
    Autosave autosave(folder.filePath("data"), [&] { return std::optional(document); });
    autosave.setDocumentPath(folder.filePath("mine.gonio"));
    const QString copy = autosave.currentCopy();
    document.sourcePath = "library:\xff";  // not UTF-8, so it is not JSON either
    autosave.update();
    QCOMPARE(autosave.currentCopy(), copy);
    QCOMPARE(editing::readDocument(copy.toStdString()).sourcePath, work().sourcePath);
    QCOMPARE(QDir(folder.filePath("data")).entryList({"*.record"}, QDir::Files).size(), qsizetype(1));
  }

  /// A program that dies leaves its copy; the next one finds it, but not while the first still runs.
  void whatWasLeftBehindIsFound() {
    const QTemporaryDir folder;
    const QString data = folder.filePath("data");
    auto autosave = std::make_unique<Autosave>(data, [] { return std::optional(work()); });
    autosave->update();
    QVERIFY(Autosave::recoverable(data).isEmpty());
    autosave.reset();  // without discard(): as if the program had died
    const auto found = Autosave::recoverable(data);
    QCOMPARE(found.size(), 1);
    QVERIFY(found[0].originalPath.isEmpty());
    QCOMPARE(editing::readDocument(found[0].autosavePath.toStdString()).sourceSha256, work().sourceSha256);
    Autosave::forget(data, found[0].autosavePath);
    QVERIFY(!QFile::exists(found[0].autosavePath));
    QVERIFY(Autosave::recoverable(data).isEmpty());
  }
};

GONIO_TEST(AutosaveTest)
}  // namespace autosave_test

#include "autosave_test.moc"
